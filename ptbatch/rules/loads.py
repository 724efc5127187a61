"""Live pattern, load table and bars along the member must lie on the member."""

from collections.abc import Iterator

from ptbatch.rules.fault import Fault, Rule, Values, counted, rule

SERVICE_VALUES = {"uniform": "w_live", "midspan": "P_live", "third-points": "P_live"}


@rule("span", "live_spans")
def loaded_spans_exist(v: Values) -> Iterator[Fault]:
    """Spans are counted from 1 at the left."""
    last = len(v["span"])
    wrong = [i for i in v["live_spans"] if not 1 <= i <= last]
    if wrong:
        cure = f"there are {last}: give numbers from 1 to {last}" if last > 1 else "there is one: give 1"
        yield Fault("live_spans", v["live_spans"], f"there is no span {wrong[0]}", cure)
    if len(set(v["live_spans"])) < len(v["live_spans"]):
        yield Fault("live_spans", v["live_spans"], "a span is named twice", "name each loaded span once")


@rule("live", "loads")
def pattern_has_loads(v: Values) -> Iterator[Fault]:
    """live = loads needs something to scale."""
    if v["live"] == "loads" and not any(load.case == "live" for load in v["loads"]):
        wrong = "there are no live rows for this member in the sheet loads"
        yield Fault("live", "loads", wrong, "add rows with case = live, or choose another pattern")


@rule("span", "loads")
def loads_on_member(v: Values) -> Iterator[Fault]:
    """Loads act between the ends of the member and are not zero."""
    end = sum(v["span"])
    for i, load in enumerate(v["loads"]):
        yield from _within(f"loads[{i}].x", load.x, end)
        if load.type == "uniform":
            yield from _within(f"loads[{i}].x_end", load.x_end, end)
            yield from _rising(f"loads[{i}].x_end", load.x, load.x_end)
        if load.value == 0.0:
            yield Fault(f"loads[{i}].value", 0.0, "the load is zero", "give its value, or delete the row")


@rule("span", "bars", "h")
def bars_on_member(v: Values) -> Iterator[Fault]:
    """Bars of the sheet rebar lie along the member and inside the section."""
    end = sum(v["span"])
    for i, bar in enumerate(v["bars"]):
        yield from _within(f"bars[{i}].x_end", bar.x_end, end)
        yield from _rising(f"bars[{i}].x_end", bar.x_start, bar.x_end)
        if bar.depth >= v["h"]:
            wrong = f"bars at {bar.depth:g} mm lie outside the section, which is {v['h']:g} mm deep"
            yield Fault(f"bars[{i}].depth", bar.depth, wrong, "give a depth from the top fibre, less than h")


def _within(column: str, x: float, end: float) -> Iterator[Fault]:
    if x > end * (1.0 + 1e-9):
        wrong = f"x = {x:g} mm lies beyond the right end at {end:g} mm"
        yield Fault(column, x, wrong, "give a distance from the left end of the member")


def _rising(column: str, start: float, end: float) -> Iterator[Fault]:
    if end <= start:
        wrong = f"the right end at {end:g} mm is not right of the left one at {start:g} mm"
        yield Fault(column, end, wrong, "swap the ends, or check their units")


@rule("live")
def service_value_used(v: Values) -> Iterator[Fault]:
    """Warning: a service value that belongs to another pattern."""
    for name in ("w_live", "P_live"):
        if v.get(name) and SERVICE_VALUES.get(v["live"]) != name:
            cure = "check the pattern, or leave the cell blank"
            yield Fault(name, v[name], f"not used: live is {v['live']}", cure)


@rule("live", "loads")
def live_rows_used(v: Values) -> Iterator[Fault]:
    """Warning: live rows of the sheet loads, but another pattern."""
    rows = sum(load.case == "live" for load in v["loads"])
    if rows and v["live"] != "loads":
        wrong = f"{counted(rows, 'live row')} of the sheet loads not used: live is {v['live']}"
        yield Fault("live", v["live"], wrong, "choose live = loads to use them")


@rule()
def factors_paired(v: Values) -> Iterator[Fault]:
    """Both load factors, or none. One that is missing from the values is faulty already."""
    for one, other in (("factor_dead", "factor_live"), ("factor_live", "factor_dead")):
        if one in v and v[one] is None and v.get(other) is not None:
            yield Fault(one, None, f"missing, and {other} is given", f"give {one}, or leave {other} blank")


RULES: tuple[Rule, ...] = (
    factors_paired,
    loaded_spans_exist,
    pattern_has_loads,
    loads_on_member,
    bars_on_member,
)
WARNINGS: tuple[Rule, ...] = (service_value_used, live_rows_used)
