"""Friction: eq. (38) on the exact angle of the profile, with the numbers put in."""

from collections.abc import Iterator

import numpy as np

from ptbatch.losses import Losses
from ptbatch.member import Member
from ptbatch.report.step import Step
from ptbatch.report.words import DASH, MINUS, Words, digits
from ptbatch.response import JACKED
from ptbatch.workbook.stored import Stored


def friction_steps(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """Eq. (38) from the (left) live end to the far end, or to where the curves of two live ends meet."""
    friction, P0, far = losses.friction, losses.fpj * member.intact_area / 1e3, _far(losses)
    words = Words(stored.system)
    both = len(friction.live) == 2
    angle, length = _way(losses, far)
    yield Step(
        "jacking force",
        "P₀ = fpj Aps",
        f"{words.size(losses.fpj, 'MPa')} · {words.size(member.intact_area, 'mm2')}",
        words.amount(P0, "kN"),
        _force(stored, member, friction.ends[friction.live[0]]),
    )
    place = "where the pull of both jacks is the same" if both else "the dead end"
    yield Step("angle turned", "α = Σ |changes of direction|", f"up to {place}", f"{digits(angle)} rad")
    at = f"arc length of the tendon up to there, {words.amount(far / 1e3, 'm')} from the left"
    yield Step("length", "x", at, words.amount(length / 1e3, "m"))
    exponent = (
        f"{digits(member.mu)} · {digits(angle)} + "
        f"{words.digits(1e3 * member.K, '1/m')} · {words.number(length / 1e3, 'm')}"
    )
    yield Step(
        "force there, jacked",
        f"P = P₀ exp({MINUS}(μ α + K x)), eq. (38)",
        f"{words.amount(P0, 'kN')} · exp({MINUS}({exponent}))",
        words.amount(P0 * float(friction.jacked(far)), "kN"),
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
    return Words(stored.system).amount(jacked.numbers("stress_fe [MPa]")[at] * member.intact_area / 1e3, "kN")
