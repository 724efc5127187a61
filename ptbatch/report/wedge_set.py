"""The wedge set: an area between two curves, with the numbers put in."""

from collections.abc import Iterator

import numpy as np

from ptbatch.losses import End, Losses
from ptbatch.member import Member
from ptbatch.report.step import ANCHORED_CURVE, JACKED_CURVE, Step, with_unit
from ptbatch.report.words import MINUS, Words
from ptbatch.workbook.stored import Stored

SAME = 1e-6  # of the jacking stress: the formula of the level holds


def set_steps(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """The area that the set takes, the length that it moves, and the curve it leaves."""
    if member.set == 0.0:
        yield Step("wedge set", "set = 0", "the curve after anchoring is the jacked one", "none")
        return
    words = Words(stored.system)
    removed, length, end = member.Ep * member.set, losses.set_length, losses.friction.live[0]
    area, level = _jacked_area(losses, end), losses.level[end] * losses.fpj
    yield Step(
        "area between the curves",
        f"∫ ({JACKED_CURVE} {MINUS} {ANCHORED_CURVE}) ds = Ep set",
        f"{words.size(member.Ep, 'MPa')} · {words.size(member.set, 'mm')}, at each live end",
        words.amount(removed / 1e3, "MPa m"),
    )
    all_of_it = abs(length - losses.friction.length) < 1e-9 * length
    yield Step(
        "set length",
        f"l: {'all of the tendon moves' if all_of_it else 'where the curves meet'}",
        f"∫ {JACKED_CURVE} ds over l = {words.amount(area / 1e3, 'MPa m')}",
        words.amount(length, "mm"),
        with_unit("mm", stored, "set_length_fe [mm]"),
    )
    mirrored = abs((2.0 * area - removed) / length - level) < SAME * losses.fpj
    twice, less = words.number(area / 1e3, "MPa m"), words.number(removed / 1e3, "MPa m")
    areas = f"(2 · {twice} {MINUS} {less}) {words.unit('MPa m')}"
    yield Step(
        "level of the mirrored curve",
        f"λ = (2 ∫ {JACKED_CURVE} ds {MINUS} Ep set) / l" if mirrored else "λ, by the area",
        f"{areas} / {words.amount(length / 1e3, 'm')}"
        if mirrored
        else "l goes beyond where the two jacks meet",
        words.amount(level, "MPa"),
    )
    yield Step(
        "stress at the anchor",
        f"{ANCHORED_CURVE} = λ {MINUS} fpj",
        f"({words.number(level, 'MPa')} {MINUS} {words.number(losses.fpj, 'MPa')}) {words.unit('MPa')}",
        words.amount(level - losses.fpj, "MPa"),
        _anchored(stored),
    )


def _jacked_area(losses: Losses, end: End) -> float:
    """Area under the jacked curve from a live end to its still point [N/mm]."""
    exponents, weights = losses.friction.quadrature(end, losses.still[end])
    return losses.fpj * float(losses.friction.curves(exponents, end)[0] @ weights)


def _anchored(stored: Stored) -> str:
    """Stress at the (left) live end's anchor after the set, of the analysis."""
    left = (1.0 - stored.value("loss_jacking_end_fe [%]") / 100.0) * stored.value("jacking_stress [MPa]")
    return Words(stored.system).amount(left, "MPa") if np.isfinite(left) else "not reached"
