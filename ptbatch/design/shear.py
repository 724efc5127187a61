"""Shear along a member, whatever the code: factored forces beside the moments that go with them."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from ptbatch.design.check import Check, untold
from ptbatch.design.sections import Combination, Subject

NO_STIRRUPS = "stirrups are needed: give Av and s"


class Section(NamedTuple):
    """A section under one combination: place [mm], shear [N] (its size) and moment [N mm], secondary ones
    included; the shear of unfactored dead load, and what of shear and moment is not that dead load (Vi,
    Mmax)."""

    x: float
    V: float
    M: float
    V_dead: float
    M_dead: float
    sign: float  # of the shear, dM/dx positive


def sections(subject: Subject, combinations: Sequence[Combination], clear: float) -> Iterator[Section]:
    """Every station that is at least so far [mm] from the supports, on the side where the shear is larger."""
    moments, shears, member = subject.moments, subject.shears, subject.member
    x = moments.x
    held = [place for place, kind in zip(member.support_x, member.supports, strict=True) if kind != "free"]
    far = np.min(np.abs(x[:, None] - np.array(held)), axis=1) >= clear - 1e-6
    dead, live, secondary = shears["dead"], shears["live"], shears["secondary"]
    for g, q in combinations:
        V = g * dead + q * live + secondary
        M = g * moments.dead + q * moments.live + moments.secondary
        for i in np.flatnonzero(far):
            side = int(np.abs(V[i]).argmax())
            sign = 1.0 if V[i, side] >= 0.0 else -1.0
            yield Section(
                float(x[i]),
                float(abs(V[i, side])),
                float(M[i]),
                float(sign * dead[i, side]),
                float(moments.dead[i]),
                sign,
            )


def if_told(subject: Subject, made: Check) -> Check:
    """A check that stirrups could help: nothing fails for those that were not told of."""
    return untold(made, NO_STIRRUPS) if subject.member.Av is None else made


def web(subject: Subject) -> float:
    """Least width of the section [mm]."""
    return min(width for _, width in subject.strips(1))
