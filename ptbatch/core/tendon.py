"""Tendon steel: stress from strain. Unloading and reloading run at Ep from the largest strain reached."""

from typing import NamedTuple

from ptbatch.core.jit import kernel
from ptbatch.core.power import power

RAMBERG_OSGOOD, BILINEAR, ELASTIC_TENDON = range(3)


class Strand(NamedTuple):
    """Area in mm2, stresses in MPa. Q, knee and R shape the Ramberg-Osgood curve (see `strand` in
    materials)."""

    Aps: float
    law: int
    Ep: float
    fpy: float
    fpu: float
    epu: float
    Q: float
    knee: float  # stress where the two asymptotes meet
    R: float


@kernel
def envelope(eps, s):
    """First-loading stress; straight with Ep below zero strain (a slack tendon is stiff only in name: it is
    never left there)."""
    if s.law == ELASTIC_TENDON or eps.real <= 0.0:
        return s.Ep * eps
    if s.law == BILINEAR:
        eps_y = s.fpy / s.Ep
        if eps.real <= eps_y:
            return s.Ep * eps
        return s.fpy + (s.fpu - s.fpy) * (eps - eps_y) / (s.epu - eps_y)
    elastic = s.Ep * eps
    return elastic * (s.Q + (1.0 - s.Q) * power(1.0 + power(elastic / s.knee, s.R), -1.0 / s.R))


@kernel
def tendon_stress(eps, worst, s):
    """Stress at strain eps when the largest committed strain is worst."""
    if eps.real >= worst:
        return envelope(eps, s)
    return envelope(worst, s) - s.Ep * (worst - eps)
