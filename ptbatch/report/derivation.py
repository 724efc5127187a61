"""The analytic losses of a member with the numbers put in, step by step, and what the analysis found beside
each."""

from collections.abc import Iterator

import numpy as np

from ptbatch.losses import Losses
from ptbatch.member import Member
from ptbatch.report.friction import friction_steps
from ptbatch.report.step import ANCHORED_CURVE, JACKED_CURVE, Step, with_unit
from ptbatch.report.wedge_set import set_steps
from ptbatch.report.words import MINUS, Words, fixed
from ptbatch.tendon_losses import tendon_losses
from ptbatch.workbook.stored import Stored


def losses_of(stored: Stored) -> Losses:
    """The analytic losses as the run took them: with the jacking stress given, or found for `fpe`."""
    member = stored.member
    assert member is not None  # by the chapter
    fpj = stored.value("jacking_stress [MPa]") if member.fpj is None else member.fpj
    return tendon_losses(vars(member), fpj)


def derivation(stored: Stored) -> list[Step]:
    """All steps, in their order; none where fpe asks for a jacking stress that no analysis found."""
    member = stored.member
    assert member is not None  # by the chapter
    if member.fpj is None and not np.isfinite(stored.value("jacking_stress [MPa]")):
        return []
    losses = losses_of(stored)
    return [
        *friction_steps(stored, member, losses),
        *set_steps(stored, member, losses),
        *_losses(stored, losses),
        *_elongation(stored, member, losses),
    ]


def _losses(stored: Stored, losses: Losses) -> Iterator[Step]:
    """What is left at the ends."""
    words = Words(stored.system)
    far = "where the stress is least" if len(losses.friction.live) == 2 else "fixed end"
    places = (
        ("jacking_end", "jacking end", losses.loss_jacking_end),
        ("fixed_end", far, losses.loss_fixed_end),
    )
    for name, place, loss in places:
        yield Step(
            f"loss, {place}",
            f"1 {MINUS} {ANCHORED_CURVE} / fpj",
            f"1 {MINUS} {words.number((1.0 - loss) * losses.fpj, 'MPa')} / {words.number(losses.fpj, 'MPa')}",
            f"{fixed(100.0 * loss, '%')} %",
            with_unit("%", stored, f"loss_{name}_fe [%]"),
        )


def _elongation(stored: Stored, member: Member, losses: Losses) -> Iterator[Step]:
    """Elongation at the live ends, and the mean stress that it stands for."""
    words = Words(stored.system)
    before, after, ends = losses.elongation_before, losses.elongation_after, len(losses.level)
    yield Step(
        "elongation before the set",
        f"Δ = ∫ {JACKED_CURVE} ds / Ep",
        f"{words.amount(before * member.Ep / 1e3, 'MPa m')} / {words.size(member.Ep, 'MPa')}",
        words.amount(before, "mm"),
        with_unit("mm", stored, "elongation_before_set [mm]"),
    )
    yield Step(
        "elongation after the set",
        f"Δ\u2009after = Δ {MINUS} set, at each live end",
        f"{words.amount(before, 'mm')} {MINUS} {ends} · {words.size(member.set, 'mm')}",
        words.amount(after, "mm"),
        with_unit("mm", stored, "elongation_after_set [mm]"),
    )
    yield Step(
        "mean stress after anchoring",
        "Ep Δ\u2009after / L",
        f"{words.size(member.Ep, 'MPa')} · {words.amount(after, 'mm')} / "
        f"{words.amount(losses.friction.length / 1e3, 'm')}",
        words.amount(losses.mean_anchored, "MPa"),
        with_unit("MPa", stored, "stress_anchored_mean [MPa]"),
    )
