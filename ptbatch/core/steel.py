"""Bonded bars: bilinear stress with kinematic hardening, unloading at Es.

A bar that has passed its rupture strain carries nothing from the next step on.
"""

from typing import NamedTuple

import numpy as np

from ptbatch.core.jit import kernel


class Steel(NamedTuple):
    """Modulus in MPa, slope after yield as a fraction of it, rupture strain."""

    Es: float
    hardening: float
    esu: float


@kernel
def steel_stress(eps, eps_p, fy, s):
    """Stress at strain eps with the plastic strain eps_p of the last step."""
    H = s.Es * s.hardening / (1.0 - s.hardening)
    trial = s.Es * (eps - eps_p)
    shifted = trial - H * eps_p
    if abs(shifted.real) <= fy:
        return trial
    bound = fy if shifted.real > 0.0 else -fy
    return trial - s.Es / (s.Es + H) * (shifted - bound)


@kernel
def commit_steel(eps, eps_p, fy, s):
    """The plastic strain after a step that ends at eps."""
    if np.isnan(eps_p) or abs(eps) > s.esu:
        return np.nan
    return eps - steel_stress(eps, eps_p, fy, s) / s.Es
