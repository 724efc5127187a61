"""Tendon steel: stress from strain. Unloading and reloading run at Ep from the largest strain reached."""

from typing import NamedTuple

from ptbatch.core.jit import inlined
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


@inlined
def envelope(eps, law, s):
    """First-loading stress, by s.law; straight with Ep below zero strain (a slack tendon is stiff only in
    name: it is never left there)."""
    elastic = s.Ep * eps
    if law == ELASTIC_TENDON:
        return elastic
    if law == BILINEAR:
        eps_y = s.fpy / s.Ep
        yielding = s.fpy + (s.fpu - s.fpy) * (eps - eps_y) / (s.epu - eps_y)
        return elastic if eps.real <= eps_y else yielding
    taut = eps.real > 0.0
    ratio = elastic * (1.0 / s.knee) if taut else 1.0 + 0.0 * eps
    curved = elastic * (s.Q + (1.0 - s.Q) * power(1.0 + power(ratio, s.R), -1.0 / s.R))
    return curved if taut else elastic


@inlined
def tendon_stress(eps, worst, law, s):
    """Stress at strain eps by s.law when the largest committed strain is worst."""
    on = eps if eps.real >= worst else worst + 0.0 * eps  # where the envelope was left
    return envelope(on, law, s) - s.Ep * (on - eps)
