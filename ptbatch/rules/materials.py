"""Strengths and strains must make sense together."""

from collections.abc import Iterator

from ptbatch.rules.fault import Fault, Rule, Values, rule


@rule("fpu", "fpy")
def tendon_yields_first(v: Values) -> Iterator[Fault]:
    """Yield comes before rupture."""
    if v["fpy"] >= v["fpu"]:
        wrong = f"yield stress of {v['fpy']:g} MPa is not below fpu = {v['fpu']:g} MPa"
        yield Fault("fpy", v["fpy"], wrong, "give fpy below fpu, or leave it blank for 0.9 fpu")


@rule("fpu", "Ep", "epu", "tendon_law")
def tendon_ruptures_last(v: Values) -> Iterator[Fault]:
    """The rupture strain lies beyond the elastic strain at fpu."""
    elastic = v["fpu"] / v["Ep"]
    if v["tendon_law"] != "elastic" and v["epu"] <= elastic:
        wrong = f"a rupture strain of {v['epu']:g} lies before fpu / Ep = {elastic:.4g}"
        yield Fault("epu", v["epu"], wrong, "give a larger epu (0.035 is usual), or check fpu and Ep")


@rule("fc", "Ec", "crushing_strain", "concrete_law")
def concrete_crushes_after_peak(v: Values) -> Iterator[Fault]:
    """The parabola of hognestad starts with Ec and so peaks at 2 fc / Ec, which must lie within the law."""
    peak = 2.0 * v["fc"] / v["Ec"]
    if v["concrete_law"] == "hognestad" and v["crushing_strain"] <= peak:
        wrong = f"hognestad peaks at a strain of 2 fc / Ec = {peak:.4f}, not before {v['crushing_strain']:g}"
        cure = "take popovics or parabola-rectangle for high strength, or check fc, Ec and crushing_strain"
        yield Fault("crushing_strain", v["crushing_strain"], wrong, cure)


@rule("tension_end")
def softening_ends_after_cracking(v: Values) -> Iterator[Fault]:
    """Stress reaches zero beyond the cracking strain."""
    if v["tension_end"] <= 1.0:
        wrong = "tension would end before the concrete cracks"
        yield Fault("tension_end", v["tension_end"], wrong, "give more than 1 cracking strain; 10 is usual")


@rule("fy", "Es", "esu")
def bars_rupture_last(v: Values) -> Iterator[Fault]:
    """Bars yield before they rupture."""
    if v["esu"] <= v["fy"] / v["Es"]:
        wrong = f"a rupture strain of {v['esu']:g} lies before yield at {v['fy'] / v['Es']:.4g}"
        yield Fault("esu", v["esu"], wrong, "give a larger esu (0.05 is usual), or check fy and Es")


@rule("hardening")
def hardening_below_elastic(v: Values) -> Iterator[Fault]:
    """The slope after yield is a small fraction of Es."""
    if v["hardening"] >= 1.0:
        cure = "give a fraction of Es such as 0.01"
        yield Fault("hardening", v["hardening"], "the slope after yield is not below Es", cure)


RULES: tuple[Rule, ...] = (
    tendon_yields_first,
    tendon_ruptures_last,
    concrete_crushes_after_peak,
    softening_ends_after_cracking,
    bars_rupture_last,
    hardening_below_elastic,
)
