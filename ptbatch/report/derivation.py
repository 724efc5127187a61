"""The analytic losses of a member with the numbers put in, step by step, and what the analysis found beside
each: eq. (38) on the exact angle of the profile, and the wedge set as an area between two curves."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ptbatch.geometry.profile import ideal_profile
from ptbatch.losses import End, Losses, analytic_losses
from ptbatch.member import Member
from ptbatch.report.words import MINUS, digits, fixed, said
from ptbatch.response import JACKED
from ptbatch.workbook.stored import Stored

DASH = "\u2013"
JACKED_CURVE, ANCHORED_CURVE = "σ\u2009jacked", "σ\u2009anchored"
SAME = 1e-6  # of the stress: the formula of the level holds


class Step(NamedTuple):
    """A quantity, its formula, the numbers put in, the value of both, and what the analysis found.

    One that the analysis has nothing beside has `-` there.
    """

    quantity: str
    formula: str
    numbers: str
    analytic: str
    fe: str = DASH


def losses_of(stored: Stored) -> Losses:
    """The analytic losses as the run took them: with the jacking stress given, or found for `fpe`."""
    member = stored.member
    assert member is not None  # by the chapter
    fpj = stored.value("jacking_stress [MPa]") if member.fpj is None else member.fpj
    friction = member.mu, member.K, member.Ep, member.set, member.jack
    return analytic_losses(ideal_profile(member), fpj, *friction, reversal="mirror")


def derivation(stored: Stored) -> list[Step]:
    """All steps, in their order; none where fpe asks for a jacking stress that no analysis found."""
    member = stored.member
    assert member is not None  # by the chapter
    if member.fpj is None and not np.isfinite(stored.value("jacking_stress [MPa]")):
        return []
    losses = losses_of(stored)
    return [
        *_friction(stored, member, losses),
        *_set(stored, member, losses),
        *_losses(stored, losses),
        *_elongation(stored, member, losses),
    ]


def _friction(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """Eq. (38) from the (left) live end to the far end, or to where the curves of two live ends meet."""
    friction, P0, far = losses.friction, losses.fpj * member.Aps / 1e3, _far(losses)
    both = len(friction.live) == 2
    angle, length = _way(losses, far)
    yield Step(
        "jacking force",
        "P₀ = fpj Aps",
        f"{digits(losses.fpj)} MPa · {digits(member.Aps)} mm²",
        f"{fixed(P0, 'kN')} kN",
        _force(stored, member, friction.ends[friction.live[0]]),
    )
    place = "where the pull of both jacks is the same" if both else "the dead end"
    yield Step("angle turned", "α = Σ |changes of direction|", f"up to {place}", f"{digits(angle)} rad")
    at = f"arc length of the tendon up to there, {fixed(far / 1e3, 'm')} m from the left"
    yield Step("length", "x", at, f"{fixed(length / 1e3, '-')} m")
    exponent = (
        f"{digits(member.mu)} · {digits(angle)} + {digits(1e3 * member.K)} · {fixed(length / 1e3, '-')}"
    )
    yield Step(
        "force there, jacked",
        f"P = P₀ exp({MINUS}(μ α + K x)), eq. (38)",
        f"{fixed(P0, 'kN')} kN · exp({MINUS}({exponent}))",
        f"{fixed(P0 * float(friction.jacked(far)), 'kN')} kN",
        DASH if both else _force(stored, member, far),
    )


def _way(losses: Losses, x: float) -> tuple[float, float]:
    """Angle [rad] and arc length [mm] of the tendon from the (left) live end to x."""
    path, end = losses.friction.path, losses.friction.ends["right"]
    angle, length = float(path.angle(x)), float(path.arc_length(x))
    if losses.friction.live[0] == "left":
        return angle, length
    return float(path.angle(end)) - angle, float(path.arc_length(end)) - length


def _far(losses: Losses) -> float:
    """x of the dead end, or where the curves of two live ends meet [mm]."""
    friction = losses.friction
    if len(friction.live) == 1:
        return friction.ends["right" if friction.live[0] == "left" else "left"]
    return float(min(friction.stations, key=lambda x: abs(friction.exponent(x, "left") - friction.total / 2)))


def _force(stored: Stored, member: Member, x: float) -> str:
    """Force at an end while jacking, of the analysis."""
    jacked = stored.tendon.stage(JACKED)
    if not len(jacked):
        return "not reached"
    at = np.abs(jacked.numbers("x [mm]") - x).argmin()
    return f"{fixed(jacked.numbers('stress_fe [MPa]')[at] * member.Aps / 1e3, 'kN')} kN"


def _set(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """The area that the set takes, the length that it moves, and the curve it leaves."""
    if member.set == 0.0:
        yield Step("wedge set", "set = 0", "the curve after anchoring is the jacked one", "none")
        return
    removed, length, end = member.Ep * member.set, losses.set_length, losses.friction.live[0]
    area, level = _jacked_area(losses, end), losses.level[end] * losses.fpj
    yield Step(
        "area between the curves",
        f"∫ ({JACKED_CURVE} {MINUS} {ANCHORED_CURVE}) ds = Ep set",
        f"{digits(member.Ep)} MPa · {digits(member.set)} mm, at each live end",
        f"{fixed(removed / 1e3, 'kN')} MPa m",
    )
    all_of_it = abs(length - losses.friction.length) < 1e-9 * length
    yield Step(
        "set length",
        f"l: {'all of the tendon moves' if all_of_it else 'where the curves meet'}",
        f"∫ {JACKED_CURVE} ds over l = {fixed(area / 1e3, 'kN')} MPa m",
        f"{fixed(length, 'mm')} mm",
        _with("mm", stored, "set_length_fe [mm]"),
    )
    mirrored = abs((2.0 * area - removed) / length - level) < SAME * losses.fpj
    areas = f"(2 · {fixed(area / 1e3, 'kN')} {MINUS} {fixed(removed / 1e3, 'kN')}) MPa m"
    yield Step(
        "level of the mirrored curve",
        f"λ = (2 ∫ {JACKED_CURVE} ds {MINUS} Ep set) / l" if mirrored else "λ, by the area",
        f"{areas} / {fixed(length / 1e3, '-')} m" if mirrored else "l goes beyond where the two jacks meet",
        f"{fixed(level, 'MPa')} MPa",
    )
    yield Step(
        "stress at the anchor",
        f"{ANCHORED_CURVE} = λ {MINUS} fpj",
        f"({fixed(level, 'MPa')} {MINUS} {fixed(losses.fpj, 'MPa')}) MPa",
        f"{fixed(level - losses.fpj, 'MPa')} MPa",
        _anchored(stored),
    )


def _jacked_area(losses: Losses, end: End) -> float:
    """Area under the jacked curve from a live end to its still point [N/mm]."""
    exponents, weights = losses.friction.quadrature(end, losses.still[end])
    return losses.fpj * float(losses.friction.curves(exponents, end)[0] @ weights)


def _anchored(stored: Stored) -> str:
    """Stress at the (left) live end's anchor after the set, of the analysis."""
    left = (1.0 - stored.value("loss_jacking_end_fe [%]") / 100.0) * stored.value("jacking_stress [MPa]")
    return f"{fixed(left, 'MPa')} MPa" if np.isfinite(left) else "not reached"


def _losses(stored: Stored, losses: Losses) -> Iterator[Step]:
    """What is left at the ends."""
    far = "where the stress is least" if len(losses.friction.live) == 2 else "fixed end"
    places = (
        ("jacking_end", "jacking end", losses.loss_jacking_end),
        ("fixed_end", far, losses.loss_fixed_end),
    )
    for name, place, loss in places:
        yield Step(
            f"loss, {place}",
            f"1 {MINUS} {ANCHORED_CURVE} / fpj",
            f"1 {MINUS} {fixed((1.0 - loss) * losses.fpj, 'MPa')} / {fixed(losses.fpj, 'MPa')}",
            f"{fixed(100.0 * loss, '%')} %",
            _with("%", stored, f"loss_{name}_fe [%]"),
        )


def _elongation(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """Elongation at the live ends, and the mean stress that it stands for."""
    before, after, ends = losses.elongation_before, losses.elongation_after, len(losses.level)
    yield Step(
        "elongation before the set",
        f"Δ = ∫ {JACKED_CURVE} ds / Ep",
        f"{fixed(before * member.Ep / 1e3, 'kN')} MPa m / {digits(member.Ep)} MPa",
        f"{fixed(before, 'mm')} mm",
        _with("mm", stored, "elongation_before_set [mm]"),
    )
    yield Step(
        "elongation after the set",
        f"Δ\u2009after = Δ {MINUS} set, at each live end",
        f"{fixed(before, 'mm')} mm {MINUS} {ends} · {digits(member.set)} mm",
        f"{fixed(after, 'mm')} mm",
        _with("mm", stored, "elongation_after_set [mm]"),
    )
    yield Step(
        "mean stress after anchoring",
        "Ep Δ\u2009after / L",
        f"{digits(member.Ep)} MPa · {fixed(after, 'mm')} mm / {fixed(losses.friction.length / 1e3, '-')} m",
        f"{fixed(losses.mean_anchored, 'MPa')} MPa",
        _with("MPa", stored, "stress_anchored_mean [MPa]"),
    )


def _with(unit: str, stored: Stored, header: str) -> str:
    """A value of the summary with its unit, or the text in its place."""
    text = said(stored.summary.get(header), unit)
    return f"{text} {unit}" if np.isfinite(stored.value(header)) else text
