"""Supports must hold the member. Inner ones are rollers, the first of them a pin if no end is held."""

from collections.abc import Iterator

from ptbatch.rules.fault import Fault, Rule, Values, rule

ENDS = ("span", "support_left", "support_right")


def _ends(v: Values) -> tuple[str, str]:
    return v["support_left"], v["support_right"]


@rule(*ENDS)
def stable(v: Values) -> Iterator[Fault]:
    """One fixed end, or two places that carry vertical load."""
    ends = _ends(v)
    carried = sum(end != "free" for end in ends) + len(v["span"]) - 1
    if "fixed" not in ends and carried < 2:
        wrong = f"the member is unstable: {ends[0]} and {ends[1]} ends over {len(v['span'])} span(s)"
        yield Fault("support_left", v["support_left"], wrong, "fix one end or support it in two places")


@rule(*ENDS)
def held_along(v: Values) -> Iterator[Fault]:
    """A single span needs an end that takes horizontal force."""
    if _ends(v) == ("roller", "roller") and len(v["span"]) == 1:
        yield Fault("support_left", "roller", "nothing holds the member horizontally", "make one end a pin")


@rule(*ENDS)
def restrained(v: Values) -> Iterator[Fault]:
    """Warning: two ends that cannot move apart take part of the prestress."""
    if set(_ends(v)) <= {"pin", "fixed"}:
        wrong = "both ends are held horizontally: the supports take part of the prestress"
        yield Fault("support_right", v["support_right"], wrong, "make one end a roller if it can move")


RULES: tuple[Rule, ...] = (stable, held_along)
WARNINGS: tuple[Rule, ...] = (restrained,)
