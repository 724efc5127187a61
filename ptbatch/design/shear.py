"""Shear along a member, whatever the code: factored forces beside the moments that go with them."""

from collections.abc import Iterator, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.design.check import Check, untold
from ptbatch.design.subject import Array, Combination, Subject

CHECKED = 6  # every so many stations
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
    """Every station that is at least so far [mm] from the supports, for either sense of the shear, with the
    live load on the spans where it counts, on the side where it is larger."""
    moments, shears, member = subject.moments, subject.shears, subject.member
    x = moments.x
    held = [place for place, kind in zip(member.support_x, member.supports, strict=True) if kind != "free"]
    away = np.min(np.abs(x[:, None] - np.array(held)), axis=1)
    far = (away >= clear - 1e-6) & looked_at(subject, away, clear)
    dead, secondary = shears["dead"], shears["secondary"]
    live_moments, live_shears = subject.live_parts
    for (g, q), sign in product(combinations, (1.0, -1.0)):
        counts = sign * live_shears > 0.0
        V = sign * (g * dead + q * np.sum(live_shears * counts, axis=0) + secondary)
        live = np.sum(live_moments[..., None] * counts, axis=0)
        M = (g * moments.dead + moments.secondary)[:, None] + q * live
        side = V.argmax(axis=1)
        for i in np.flatnonzero(far & (V.max(axis=1) >= 0.0)):
            at = i, side[i]
            there = float(x[i]), float(V[at]), float(M[at])
            yield Section(*there, float(sign * dead[at]), float(moments.dead[i]), sign)


def looked_at(subject: Subject, away: Array, clear: float) -> NDArray[np.bool_]:
    """Stations at which shear is looked at, by their distance from the supports: every some, the first ones
    that are clear of the supports, and both sides of point loads."""
    x, loads = subject.moments.x, subject.loads
    at = np.zeros(len(x), bool)
    at[::CHECKED] = True
    beyond = away >= clear - 1e-6
    at[1:] |= beyond[1:] & ~beyond[:-1]
    at[:-1] |= beyond[:-1] & ~beyond[1:]
    for load in (*loads["dead"], *loads["live"]):
        if load.type == "point":
            at |= np.abs(x - load.x) < 1e-6
    return at


def if_told(subject: Subject, made: Check) -> Check:
    """A check that stirrups could help: nothing fails for those that were not told of."""
    return untold(made, NO_STIRRUPS) if subject.member.Av is None else made


def web(subject: Subject) -> float:
    """Least width of the section [mm]."""
    return min(width for _, width in subject.strips(1))
