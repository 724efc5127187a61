"""The tendon: its path inside the section, its stress."""

from collections.abc import Iterator

from ptbatch.losses import fpj_for_mean
from ptbatch.rules.fault import Fault, Rule, Values, counted, rule
from ptbatch.tendon_losses import FRICTION, PATH, ideal_path, tendon_losses


@rule("span", "profile", "dp", "profile_points")
def depths_counted(v: Values) -> Iterator[Fault]:
    """One depth for a straight tendon, 2 n + 1 for the other shapes over n spans."""
    wanted = 1 if v["profile"] == "straight" else 2 * len(v["span"]) + 1
    if not v["profile_points"] and len(v["dp"]) != wanted:
        spans = counted(len(v["span"]), "span")
        wrong = f"{counted(len(v['dp']), 'depth')} given; {v['profile']} over {spans} needs {wanted}"
        cure = "give left end; then low point; right end of each span" if wanted > 1 else "give one depth"
        yield Fault("dp", v["dp"], wrong, cure)


@rule("n_strands_lost")
def some_strands_left(v: Values) -> Iterator[Fault]:
    """Lost strands are some of those that there are, but not all."""
    lost, whole = v["n_strands_lost"], v.get("n_strands")
    if lost and "n_strands" in v and whole is None:
        yield Fault("n_strands", None, "missing, and n_strands_lost is given", "give n_strands")
    elif whole is not None and lost >= whole:
        wrong = f"of {counted(whole, 'strand')} none is left"
        yield Fault("n_strands_lost", lost, wrong, "give fewer than n_strands")


@rule("harp")
def harps_in_order(v: Values) -> Iterator[Fault]:
    """Harping points from left to right."""
    if list(v["harp"]) != sorted(set(v["harp"])):
        cure = "give rising fractions, e.g. 1/3; 2/3"
        yield Fault("harp", v["harp"], "harping points are not in order", cure)


@rule("inflection")
def inflection_before_midspan(v: Values) -> Iterator[Fault]:
    """The reversed parabola ends before the low point."""
    if v["inflection"] >= 0.5:
        wrong = "the inflection point is not between support and midspan"
        yield Fault("inflection", v["inflection"], wrong, "give a fraction below 0.5")


@rule("span", "profile_points")
def points_run_through(v: Values) -> Iterator[Fault]:
    """Points of a free profile go from end to end, left to right."""
    x = [point[0] for point in v["profile_points"]]
    if not x:
        return
    end = sum(v["span"])
    for i in range(1, len(x)):
        if x[i] - x[i - 1] < 1e-6 * end:
            wrong = f"x = {x[i]:g} mm does not lie right of the point before, x = {x[i - 1]:g} mm"
            yield Fault(f"profile_points[{i}].x", x[i], wrong, "list the points from left to right")
    if abs(x[0]) > 1e-6 * end:
        yield Fault("profile_points[0].x", x[0], "the first point is not at the left end", "begin with x = 0")
    if abs(x[-1] - end) > 1e-6 * end:
        wrong = f"the last point is not at the right end, {end:g} mm from the left"
        cure = "end the points where the spans end"
        yield Fault(f"profile_points[{len(x) - 1}].x", x[-1], wrong, cure)


@rule("dp", "profile_points", "h")
def tendon_inside(v: Values) -> Iterator[Fault]:
    """The tendon stays inside the section. No shape reaches above or below the depths that it is given."""
    points = [(f"profile_points[{i}].dp", depth, depth) for i, (_, depth) in enumerate(v["profile_points"])]
    for column, value, depth in points or [("dp", v["dp"], depth) for depth in v["dp"]]:
        if depth >= v["h"]:
            wrong = f"the tendon at {depth:g} mm lies outside the section, which is {v['h']:g} mm deep"
            yield Fault(column, value, wrong, "give depths from the top fibre, less than h")


@rule("fpu")
def one_stress(v: Values) -> Iterator[Fault]:
    """Exactly one of fpj and fpe, not above fpu. One that is missing from the values is faulty already."""
    if "fpj" not in v or "fpe" not in v:
        return
    if v["fpj"] is None and v["fpe"] is None:
        cure = "give the jacking stress fpj, or the mean stress fpe wanted after anchoring"
        yield Fault("fpj", None, "neither fpj nor fpe is given", cure)
    elif v["fpj"] is not None and v["fpe"] is not None:
        yield Fault("fpe", v["fpe"], "both fpj and fpe are given", "leave one of them blank")


def _below_fpu(name: str) -> Rule:
    @rule(name, "fpu")
    def below(v: Values) -> Iterator[Fault]:
        if v[name] > v["fpu"]:
            wrong = f"stress of {v[name]:g} MPa is above fpu = {v['fpu']:g} MPa"
            yield Fault(name, v[name], wrong, "give a stress below fpu; check the unit in the header")

    return below


def path_is_sound(v: Values) -> bool:
    """Whether there is a path to ask more about, of values that hold all of `PATH`."""
    rules = (depths_counted, harps_in_order, inflection_before_midspan, points_run_through, tendon_inside)
    return not any(rule(v) for rule in rules)


@rule(*PATH, *FRICTION, "fpu")
def set_leaves_stress(v: Values) -> Iterator[Fault]:
    """Stress is left after the wedge set, and `fpe` can be reached without passing fpu at the jack.

    Asked only where the tendon is otherwise sound.
    """
    wanted = v.get("fpe")
    if not path_is_sound(v) or (wanted is None) == (v.get("fpj") is None):
        return
    friction = [v[name] for name in FRICTION]
    fpj: float = v["fpj"] if wanted is None else fpj_for_mean(ideal_path(v), wanted, *friction)
    if wanted is not None:
        if fpj > v["fpu"]:
            wrong = f"a set of {v['set']:g} mm makes it take {fpj:.4g} MPa at the jack, above fpu"
            yield Fault("fpe", wanted, wrong, "ask for less stress, or give a smaller set")
            return
    try:
        tendon_losses(v, fpj)
    except ValueError as slack:
        wrong = str(slack).removeprefix("set: ")
        yield Fault("set", v["set"], wrong, "give a smaller set, or 0 where losses are not asked for")


RULES: tuple[Rule, ...] = (
    depths_counted,
    some_strands_left,
    harps_in_order,
    inflection_before_midspan,
    points_run_through,
    tendon_inside,
    one_stress,
    _below_fpu("fpj"),
    _below_fpu("fpe"),
    set_leaves_stress,
)
