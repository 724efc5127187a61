"""The analytic losses of a member with the numbers put in, step by step, and what the analysis found beside
each: eq. (38) on the exact angle of the profile, and the wedge set as an area between two curves."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ptbatch.geometry.profile import ideal_profile
from ptbatch.losses import End, Losses, analytic_losses
from ptbatch.member import Member
from ptbatch.report.words import digits, fixed, said
from ptbatch.response import JACKED
from ptbatch.workbook.stored import Stored

SAME = 1e-6  # of the stress: the formula of the level holds


class Step(NamedTuple):
    """A quantity, its formula, the numbers put in, the value of both, and what the analysis found.

    One that the analysis has nothing beside has `-` there.
    """

    quantity: str
    formula: str
    numbers: str
    analytic: str
    fe: str = "\u2013"


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
    friction, P0 = losses.friction, losses.fpj * member.Aps / 1e3
    end, x = friction.live[0], _far(losses)
    total = friction.ends["right"]
    angle, length = float(friction.path.angle(x)), float(friction.path.arc_length(x))
    if end == "right":
        angle, length = float(friction.path.angle(total)) - angle, friction.length - length
    place = "where both jacks pull alike" if len(friction.live) == 2 else "the dead end"
    yield Step("jacking force", "P₀ = fpj Aps", f"{digits(losses.fpj)} MPa · {digits(member.Aps)} mm²",
               f"{fixed(P0, 'kN')} kN", _force(stored, member, friction.ends[end]))  # fmt: skip
    yield Step("friction", f"α, x: angle and length of the tendon up to {place} (x = {fixed(x / 1e3, 'm')} m)",
               "sum of the absolute changes of direction; arc length",
               f"α = {digits(angle)} rad; x = {fixed(length / 1e3, '-')} m")  # fmt: skip
    exponent = f"{digits(member.mu)} · {digits(angle)} + {digits(1e3 * member.K)} · {fixed(length / 1e3, '-')}"
    P = P0 * float(friction.jacked(x))
    fe = "\u2013" if len(friction.live) == 2 else _force(stored, member, x)
    yield Step("force there, jacked", "P = P₀ exp(\u2212(μ α + K x)), eq. (38)",
               f"{fixed(P0, 'kN')} kN · exp(\u2212({exponent}))", f"{fixed(P, 'kN')} kN", fe)  # fmt: skip


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
    removed = member.Ep * member.set
    yield Step("wedge set, each live end", "area between the curves = Ep set = ∫ (σ\u2009jacked \u2212 σ\u2009anchored) ds",
               f"{digits(member.Ep)} MPa · {digits(member.set)} mm", f"{fixed(removed / 1e3, 'kN')} MPa m")  # fmt: skip
    end, length = losses.friction.live[0], losses.set_length
    reaches = abs(length - losses.friction.length) < 1e-9 * length
    how = "all of the tendon moves" if reaches else "where the curves meet"
    yield Step("set length", f"l: the area above is used up; {how}", _area(losses, end),
               f"{fixed(length, 'mm')} mm", _with("mm", stored, "set_length_fe [mm]"))  # fmt: skip
    area, level = _jacked_area(losses, end), losses.level[end] * losses.fpj
    if abs((2.0 * area - removed) / length - level) < SAME * losses.fpj:
        yield Step("level of the mirrored curve", "λ = (2 ∫ σ\u2009jacked ds \u2212 Ep set) / l",
                   f"(2 · {fixed(area / 1e3, 'kN')} \u2212 {fixed(removed / 1e3, 'kN')}) MPa m / "
                   f"{fixed(length / 1e3, '-')} m", f"{fixed(level, 'MPa')} MPa")  # fmt: skip
    yield Step("stress at the anchor", "σ\u2009anchored = λ \u2212 fpj",
               f"({fixed(level, 'MPa')} \u2212 {fixed(losses.fpj, 'MPa')}) MPa",
               f"{fixed(level - losses.fpj, 'MPa')} MPa", _anchored(stored))  # fmt: skip


def _area(losses: Losses, end: End) -> str:
    """Area under the jacked curve over the set length, in words."""
    return f"∫ σ\u2009jacked ds over l = {fixed(_jacked_area(losses, end) / 1e3, 'kN')} MPa m"


def _jacked_area(losses: Losses, end: End) -> float:
    """Area under the jacked curve from a live end to its still point [N/mm]."""
    exponents, weights = losses.friction.quadrature(end, losses.still[end])
    return losses.fpj * float(losses.friction.curves(exponents, end)[0] @ weights)


def _anchored(stored: Stored) -> str:
    """Stress at the (left) live end's anchor after the set, of the analysis."""
    loss, jacked = stored.value("loss_jacking_end_fe [%]"), stored.value("jacking_stress [MPa]")
    return f"{fixed((1.0 - loss / 100.0) * jacked, 'MPa')} MPa" if np.isfinite(loss * jacked) else "not reached"


def _losses(stored: Stored, losses: Losses) -> Iterator[Step]:
    """What is left at the ends."""
    far = "where the stress is least" if len(losses.friction.live) == 2 else "fixed end"
    for name, place, loss in (
        ("jacking_end", "jacking end", losses.loss_jacking_end),
        ("fixed_end", far, losses.loss_fixed_end),
    ):
        left = fixed((1.0 - loss) * losses.fpj, "MPa")
        yield Step(f"loss, {place}", "1 \u2212 σ\u2009anchored / fpj", f"1 \u2212 {left} / {fixed(losses.fpj, 'MPa')}",
                   f"{fixed(100.0 * loss, '%')} %", _with("%", stored, f"loss_{name}_fe [%]"))  # fmt: skip


def _elongation(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """Elongation at the live ends, and the mean stress that it stands for."""
    before, after, L = losses.elongation_before, losses.elongation_after, losses.friction.length
    area = fixed(before * member.Ep / 1e3, "kN")
    yield Step("elongation before the set", "Δ = ∫ σ\u2009jacked ds / Ep", f"{area} MPa m / {digits(member.Ep)} MPa",
               f"{fixed(before, 'mm')} mm", _with("mm", stored, "elongation_before_set [mm]"))  # fmt: skip
    ends = len(losses.friction.live)
    yield Step("elongation after the set", "Δ \u2212 set, each live end",
               f"{fixed(before, 'mm')} mm \u2212 {ends} · {digits(member.set)} mm",
               f"{fixed(after, 'mm')} mm", _with("mm", stored, "elongation_after_set [mm]"))  # fmt: skip
    yield Step("mean stress after anchoring", "Ep Δ\u2009after / L",
               f"{digits(member.Ep)} MPa · {fixed(after, 'mm')} mm / {fixed(L / 1e3, '-')} m",
               f"{fixed(losses.mean_anchored, 'MPa')} MPa", _with("MPa", stored, "stress_anchored_mean [MPa]"))  # fmt: skip


def _with(unit: str, stored: Stored, header: str) -> str:
    """A value of the summary with its unit, or the text in its place."""
    text = said(stored.summary.get(header), unit)
    return f"{text} {unit}" if np.isfinite(stored.value(header)) else text
