"""The parts of the section must exist and fit into each other; bars must lie inside."""

from collections.abc import Iterator

from ptbatch.rules.fault import Fault, Rule, Values, counted, rule

NEEDED = {
    "rectangle": (),
    "tee": ("bw", "hf"),
    "i": ("bw", "hf", "b_bottom", "hf_bottom"),
    "box": ("bw", "hf"),
}
USED = NEEDED | {"box": NEEDED["i"]}


@rule("shape")
def parts_given(v: Values) -> Iterator[Fault]:
    """A shape with flanges needs their sizes. A part that is missing from the values is faulty already."""
    for part in NEEDED[v["shape"]]:
        if part in v and v[part] is None:
            yield Fault(part, None, f"missing, and shape {v['shape']} needs it", f"give {part}")


@rule("shape", "h", "hf")
def flanges_fit(v: Values) -> Iterator[Fault]:
    """The flanges leave some height for the web."""
    if v["shape"] == "rectangle":
        return
    flanges = v["hf"] + (v.get("hf_bottom") or 0.0) * (v["shape"] != "tee")
    if flanges >= v["h"]:
        wrong = f"flanges {flanges:g} mm thick leave no web in a depth of {v['h']:g} mm"
        yield Fault("hf", v["hf"], wrong, "give thinner flanges or a larger h")


@rule("shape", "b", "bw")
def web_fits(v: Values) -> Iterator[Fault]:
    """The web is no wider than its flanges."""
    if v["shape"] == "rectangle":
        return
    bottom = None if v["shape"] == "tee" else v.get("b_bottom")
    narrowest = min(v["b"], bottom or v["b"])
    if v["bw"] > narrowest:
        wrong = f"a web {v['bw']:g} mm wide is wider than a flange of {narrowest:g} mm"
        yield Fault("bw", v["bw"], wrong, "give a bw up to the width of the flanges")


def _bars_pair(areas: str, depths: str) -> Rule:
    @rule(areas, depths)
    def paired(v: Values) -> Iterator[Fault]:
        if len(v[areas]) != len(v[depths]) and (any(v[areas]) or any(v[depths])):
            wrong = f"{counted(len(v[depths]), 'depth')} for {counted(len(v[areas]), 'area')}"
            yield Fault(depths, v[depths], wrong, f"give one depth to each area in {areas}")

    return paired


def _bars_inside(areas: str, depths: str) -> Rule:
    @rule(areas, depths, "h")
    def inside(v: Values) -> Iterator[Fault]:
        for area, depth in zip(v[areas], v[depths], strict=False):
            if area > 0.0 and not 0.0 < depth < v["h"]:
                wrong = f"bars at {depth:g} mm lie outside the section, which is {v['h']:g} mm deep"
                yield Fault(
                    depths, v[depths], wrong, "give depths from the top fibre, above zero and less than h"
                )

    return inside


@rule("shape")
def parts_used(v: Values) -> Iterator[Fault]:
    """Warning: a size that the shape does not have."""
    for part in USED["i"]:
        if part not in USED[v["shape"]] and v.get(part) is not None:
            wrong = f"not used: a {v['shape']} has no {part}"
            yield Fault(part, v[part], wrong, "check the shape, or leave the cell blank")


@rule("Av")
def stirrups_spaced(v: Values) -> Iterator[Fault]:
    """Stirrups have an area and a spacing."""
    if v["Av"] and "s" in v and v["s"] is None:
        yield Fault("s", None, "missing, and stirrups Av are given", "give s, or leave Av blank")


RULES: tuple[Rule, ...] = (
    stirrups_spaced,
    parts_given,
    flanges_fit,
    web_fits,
    _bars_pair("As", "ds"),
    _bars_pair("As_top", "ds_top"),
    _bars_inside("As", "ds"),
    _bars_inside("As_top", "ds_top"),
)
WARNINGS: tuple[Rule, ...] = (parts_used,)
