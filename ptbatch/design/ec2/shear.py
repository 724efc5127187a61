"""Shear resistance without and with stirrups."""

from math import sqrt

GAMMA_C, GAMMA_S = 1.5, 1.15
FLATTEST = 2.5  # cot theta, 6.2.3 (2)


def without_stirrups(fck: float, bw: float, d: float, rho_l: float, sigma_cp: float) -> float:
    """VRd,c [N] where the section is cracked; sigma_cp: compression by the prestress [MPa].

    EN 1992-1-1 eq. (6.2a), (6.2b) and (6.3N).
    """
    k = min(1.0 + sqrt(200.0 / d), 2.0)
    axial = 0.15 * min(sigma_cp, 0.2 * fck / GAMMA_C)
    by_steel = 0.18 / GAMMA_C * k * (100.0 * min(rho_l, 0.02) * fck) ** (1.0 / 3.0)
    return (max(by_steel, 0.035 * k**1.5 * sqrt(fck)) + axial) * bw * d


def with_stirrups(fck: float, bw: float, z: float, Asw: float, fywk: float, sigma_cp: float) -> float:
    """VRd [N] of vertical stirrups: the smaller of VRd,s and VRd,max, at the angle of the struts that makes
    it largest; z: inner lever arm; Asw: area over spacing [mm2/mm].

    EN 1992-1-1 eq. (6.8), (6.9), (6.6N) and (6.11N).
    """
    fcd, pulled = fck / GAMMA_C, Asw * fywk / GAMMA_S
    crushed = squeezed(sigma_cp, fcd) * bw * 0.6 * (1.0 - fck / 250.0) * fcd
    if pulled <= 0.0:
        return 0.0
    cot = min(max(sqrt(max(crushed / pulled - 1.0, 0.0)), 1.0), FLATTEST)
    return min(pulled * z * cot, crushed * z * cot / (1.0 + cot**2))


def squeezed(sigma_cp: float, fcd: float) -> float:
    """alpha_cw: what compression does to the struts.

    EN 1992-1-1 eq. (6.11.aN) to (6.11.cN).
    """
    share = sigma_cp / fcd
    if share <= 0.25:
        return 1.0 + max(share, 0.0)
    return 1.25 if share <= 0.5 else max(2.5 * (1.0 - share), 0.0)


def least_stirrups(fck: float, bw: float, fywk: float) -> float:
    """Asw,min / s [mm2/mm].

    EN 1992-1-1 eq. (9.4) and (9.5N).
    """
    return 0.08 * sqrt(fck) / fywk * bw
