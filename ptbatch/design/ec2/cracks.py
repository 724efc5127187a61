"""Crack widths and decompression."""

from collections.abc import Sequence
from typing import NamedTuple

from scipy.optimize import brentq

from ptbatch.design.flexure import Strip

LEAST_PRESTRESS = {"unbonded": 0.95, "bonded": 0.90}  # rinf, 5.10.9 (1)
MILD = ("X0", "XC1")
OTHER = ("XC2", "XC3", "XC4")
GAUSS = 0.5 / 3.0**0.5  # two points are exact for the moment of a linear stress
K_T = 0.4  # long-term loading, 7.3.4 (2)


def widest(bond: str, exposure: str) -> float | None:
    """wmax [mm]; None where decompression is asked for in its place.

    EN 1992-1-1 table 7.1N: quasi-permanent load for unbonded tendons, frequent load for bonded ones.
    """
    if bond == "unbonded":
        return 0.4 if exposure in MILD else 0.3
    return 0.2 if exposure in (*MILD, *OTHER) else None


class Cracked(NamedTuple):
    """An elastic section without tension in the concrete: neutral axis below the compressed face [mm], and
    the tension of its deepest bar [MPa]."""

    x: float
    bar_stress: float


def cracked(
    strips: Sequence[Strip],
    bars: Sequence[tuple[float, float]],
    Ec: float,
    Es: float,
    tendon: tuple[float, float],
    P: float,
    M: float,
) -> Cracked | None:
    """Section under a moment [N mm] and the force of a tendon [N]; bars: area and depth below the compressed
    face, tendon: depth, and the axial stiffness [N] that it adds where it is bonded. None where the section
    is not cracked, or has no equilibrium.

    Closed form but for the neutral axis: plane strains, about the tendon's level.
    """
    depth, stiff = tendon
    h = sum(thickness for thickness, _ in strips)

    def resultants(c: float) -> tuple[float, float]:
        """Force and moment about the tendon, over the curvature."""
        force = sum(Es * area * (c - d) for area, d in bars) + stiff * (c - depth)
        moment = sum(Es * area * (c - d) * (depth - d) for area, d in bars)
        top = 0.0
        for thickness, width in strips:
            part = min(max(c - top, 0.0), thickness)
            for share in (0.5 - GAUSS, 0.5 + GAUSS):
                y = top + share * part
                force += 0.5 * Ec * width * part * (c - y)
                moment += 0.5 * Ec * width * part * (c - y) * (depth - y)
            top += thickness
        return force, moment

    def unbalanced(c: float) -> float:
        force, moment = resultants(c)
        return moment * P - force * M

    low, high = 1e-3 * h, h
    if M <= 0.0 or unbalanced(low) <= 0.0 or unbalanced(high) >= 0.0:
        return None
    c = float(brentq(unbalanced, low, high, rtol=1e-12))
    curvature = M / resultants(c)[1]
    deepest = max(d for _, d in bars)
    return Cracked(c, Es * curvature * (deepest - c))


def width(
    stress: float, Es: float, Ecm: float, fctm: float, rho: float, cover: float, diameter: float
) -> float:
    """wk [mm]; stress of the bars in the crack [MPa], rho: As over Ac,eff, cover and diameter of the bars.

    EN 1992-1-1 eq. (7.8), (7.9) and (7.11), ribbed bars in bending.
    """
    stiffened = stress - K_T * fctm / rho * (1.0 + Es / Ecm * rho)
    strain = max(stiffened, 0.6 * stress) / Es
    return (3.4 * cover + 0.8 * 0.5 * 0.425 * diameter / rho) * strain
