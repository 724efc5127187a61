"""One-way shear of prestressed members."""

from ptbatch.design.aci318 import PSI

PHI = 0.75  # table 21.2.1
LARGEST_ROOT = 100.0  # psi, 22.5.3.1


def root(fc: float) -> float:
    """sqrt(fc) of psi, in MPa, no more than 100 psi.

    ACI 318-19, 22.5.3.1.
    """
    return float(min((fc / PSI) ** 0.5, LARGEST_ROOT) * PSI)


def well_prestressed(Aps: float, fse: float, fpu: float, As: float, fy: float) -> bool:
    """Whether the effective prestress is at least 40 % of the strength of the flexural steel.

    ACI 318-19, 22.5.6.2 and 22.5.6.3.
    """
    return Aps * fse >= 0.4 * (Aps * fpu + As * fy)


def approximate(fc: float, bw: float, d: float, ratio: float) -> float:
    """Vc [N] where `well_prestressed`; ratio: Vu dp / Mu of the same combination, counted up to 1.

    ACI 318-19 table 22.5.6.2, and no less than 2 sqrt(fc') bw d.
    """
    by_ratio = 0.6 * root(fc) + 700.0 * PSI * min(max(ratio, 0.0), 1.0)
    return min(max(by_ratio, 2.0 * root(fc)), 5.0 * root(fc)) * bw * d


def flexure_shear(fc: float, bw: float, dp: float, Vd: float, Vi: float, M_cre: float, M_max: float) -> float:
    """Vci [N] where not `well_prestressed`.

    ACI 318-19 eq. (22.5.6.3.1a) and (b).
    """
    least = 1.7 * root(fc) * bw * dp
    if M_max <= 0.0:
        return float("inf")
    return max(0.6 * root(fc) * bw * dp + Vd + Vi * max(M_cre, 0.0) / M_max, least)


def web_shear(fc: float, bw: float, dp: float, fpc: float, Vp: float) -> float:
    """Vcw [N]; fpc: compression at the centroid.

    ACI 318-19 eq. (22.5.6.3.2).
    """
    return (3.5 * root(fc) + 0.3 * fpc) * bw * dp + Vp


def stirrups(Av: float, s: float, fyt: float, d: float) -> float:
    """Vs [N].

    ACI 318-19 eq. (22.5.8.5.3).
    """
    return Av * fyt * d / s


def largest(fc: float, bw: float, d: float) -> float:
    """Largest Vs that the cross-section can bear [N].

    ACI 318-19 eq. (22.5.1.2): 8 sqrt(fc') bw d.
    """
    return 8.0 * root(fc) * bw * d


def least_stirrups(
    fc: float, bw: float, d: float, fyt: float, prestress: tuple[float, float] | None
) -> float:
    """Av,min / s [mm2/mm]; prestress: Aps and fpu where the member is `well_prestressed`.

    ACI 318-19 table 9.6.3.4.
    """
    plain = max(0.75 * root(fc), 50.0 * PSI) * bw / fyt
    if prestress is None:
        return plain
    Aps, fpu = prestress
    return float(min(plain, Aps * fpu / (80.0 * fyt * d) * (d / bw) ** 0.5))
