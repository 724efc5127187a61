"""The check of bending, whatever the code: factored moments along the member against its strengths."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ptbatch.design.check import FAIL, INFO, REVIEW, Check, Value, at_most, unless
from ptbatch.design.subject import HOGGING, SAGGING, Array, Combination, Subject

WORDS = {SAGGING: "sagging", HOGGING: "hogging"}
CHECKED = 12  # every so many stations, and the supports
NOTHING = 1e-9  # of the demand: round-off
APART = 0.15  # of the code's strength: the analysis differs by more than that


class Resistance(NamedTuple):
    """Design strength and nominal strength [N mm], the numbers that they come from, and why they may not be
    valid."""

    design: float
    nominal: float
    values: tuple[Value, ...]
    tendon_stress: float
    doubt: str = ""


Resists = Callable[[Subject, float, int], Resistance]


def bending(
    subject: Subject, clause: str, formula: str, combinations: Sequence[Combination], resists: Resists
) -> list[Check]:
    """The section that is used most, for either sense of the moment; none where that sense does not occur."""
    found = []
    moments = subject.moments
    places = _places(subject)
    for sense in (SAGGING, HOGGING):
        demand = _demand(subject, combinations, sense)
        at = [i for i in places if demand[i] > 1e-6 * np.abs(demand).max()]
        if not at:
            continue
        strengths = {i: resists(subject, float(moments.x[i]), sense) for i in at}
        worst = max(
            at, key=lambda i: demand[i] / strengths[i].design if strengths[i].design > 0.0 else np.inf
        )
        found.append(_check(subject, clause, formula, sense, worst, float(demand[worst]), strengths[worst]))
    return found


def _demand(subject: Subject, combinations: Sequence[Combination], sense: int) -> Array:
    """Largest factored moments (stations,) of a sense [N mm], the live load on the spans where it counts."""
    moments = subject.moments
    live = moments.live_for(sense)
    factored = [g * moments.dead + q * live + moments.secondary for g, q in combinations]
    return np.asarray(np.max([sense * moment for moment in factored], axis=0))


def _places(subject: Subject) -> list[int]:
    x, supports = subject.moments.x, subject.member.support_x
    near = [int(np.abs(x - place).argmin()) for place in supports]
    moments = subject.moments
    most = [int(np.abs(part).argmax()) for part in (moments.dead, moments.live_most, moments.live_least)]
    return sorted({*range(0, len(x), CHECKED), *near, *most})


def _check(
    subject: Subject, clause: str, formula: str, sense: int, i: int, demand: float, strength: Resistance
) -> Check:
    moments = subject.moments
    parts = (
        ("M,dead", moments.dead),
        ("M,live", moments.live_for(sense)),
        ("M,secondary", moments.secondary),
    )
    told = [(name, float(m[i]) / 1e6) for name, m in parts]
    values = tuple(Value(name, m if abs(m) > NOTHING * demand / 1e6 else 0.0, "kN m") for name, m in told)
    values += strength.values
    made = at_most(
        *(f"bending, {WORDS[sense]}", clause, formula, values, demand / 1e6, strength.design / 1e6, "kN m"),
        x=float(moments.x[i]),
    )
    if made.outcome == FAIL:
        reason = "no steel in tension there" if strength.design <= 0.0 else ""
        return _with(made, FAIL, reason)
    return unless(made, "; ".join(filter(None, (strength.doubt, subject.doubt))))


def _with(check: Check, outcome: str, reason: str) -> Check:
    return replace(check, outcome=outcome, reason=reason)


def two_views(
    subject: Subject, clause: str, resists: Resists, combinations: Sequence[Combination]
) -> list[Check]:
    """The code's nominal strength beside the analysis' moment, at the section of the peak, and the factored
    moment over either with the code's safety."""
    response = subject.response
    peak, state, curve = response.event("peak"), response.tendon.get("peak"), response.curve
    if peak is None or state is None or curve is None:
        return []
    moment = float(curve.moment_max[round(peak.step)])
    sense = SAGGING if moment > 0.0 else HOGGING
    x = peak.place if np.isfinite(peak.place) else _most(subject, sense)
    code = resists(subject, x, sense)
    if code.nominal <= 0.0:
        return []
    analysis = curve.at(peak.step, np.abs(curve.moment_max))
    stress = state.mean if subject.member.bond == "unbonded" else state.most
    demand = float(np.interp(x, subject.moments.x, _demand(subject, combinations, sense)))
    safety = code.design / code.nominal
    values = (
        Value("fps, code", code.tendon_stress, "MPa"),
        Value("fps, analysis", stress, "MPa"),
        Value("Mn, code", code.nominal / 1e6, "kN m"),
        Value("M, analysis", analysis / 1e6, "kN m"),
        Value("used, code", demand / code.design),
        Value("used, analysis", demand / (safety * analysis)),
    )
    ratio = analysis / code.nominal
    numbers = analysis / 1e6, code.nominal / 1e6, "kN m", None
    made = Check("strength, two views", clause, "M,analysis / Mn,code", values, *numbers, INFO, x)
    if abs(ratio - 1.0) <= APART:
        return [made]
    lower = "code" if ratio > 1.0 else "analysis"
    return [
        _with(
            made,
            REVIEW,
            f"the {lower}'s is lower, by {abs(ratio - 1.0):.0%}: {_why(subject, code, stress, ratio)}",
        )
    ]


def _most(subject: Subject, sense: int) -> float:
    """Where dead and live load bend most in that sense."""
    moments = subject.moments
    return float(moments.x[int((sense * (moments.dead + moments.live)).argmax())])


def _why(subject: Subject, code: Resistance, stress: float, ratio: float) -> str:
    """What sets the two apart, as far as it can be told."""
    if subject.member.bond == "unbonded" and (stress - code.tendon_stress) * (ratio - 1.0) > 0.0:
        return "the stress of the unbonded tendon"
    if len(subject.member.span) > 1:
        return "redistribution between the sections"
    return f"the analysis ends by {subject.response.failure}"
