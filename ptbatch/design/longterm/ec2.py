"""Creep, shrinkage and relaxation by EN 1992-1-1, and the loss of prestress that they make together."""

from math import exp, sqrt

import numpy as np

from ptbatch.design.longterm import TimeLoss, by_time

CEMENT = {"s": (-1.0, 3.0, 0.13), "n": (0.0, 4.0, 0.12), "r": (1.0, 6.0, 0.11)}  # alpha; alpha_ds1, alpha_ds2
RELAXATION = {1: (5.39, 6.7), 2: (0.66, 9.1), 3: (1.98, 8.0)}  # factor and exponent by class
RHO_1000 = {1: 8.0, 2: 2.5, 3: 4.0}  # %, 3.3.2 (6)
FOR_GOOD = 500_000.0  # hours, 3.3.2 (8)


def modulus(fck: float) -> float:
    """Ecm [MPa].

    EN 1992-1-1 table 3.1.
    """
    return float(22_000.0 * ((fck + 8.0) / 10.0) ** 0.3)


def creep_coefficient(t: float, t0: float, RH: float, h0: float, fck: float, cement: str = "n") -> float:
    """phi(t, t0); times in days, RH in %, h0 = 2 Ac / u in mm.

    EN 1992-1-1 Annex B.1.
    """
    fcm = fck + 8.0
    a1, a2, a3 = (min(1.0, (35.0 / fcm) ** power) for power in (0.7, 0.2, 0.5))
    dryness = (1.0 - RH / 100.0) / (0.1 * h0 ** (1.0 / 3.0))
    humid = 1.0 + dryness if fcm <= 35.0 else (1.0 + dryness * a1) * a2
    t0 = max(0.5, t0 * (9.0 / (2.0 + t0**1.2) + 1.0) ** CEMENT[cement][0])
    slow = min(1.5 * (1.0 + (0.012 * RH) ** 18) * h0 + 250.0 * a3, 1500.0 * a3)
    growth = ((t - t0) / (slow + t - t0)) ** 0.3
    return float(humid * 16.8 / sqrt(fcm) / (0.1 + t0**0.20) * growth)


def drying_shrinkage(t: float, ts: float, RH: float, h0: float, fck: float, cement: str = "n") -> float:
    """eps_cd(t), positive; ts: end of curing, in days as t.

    EN 1992-1-1, 3.1.4 (6), table 3.3 and Annex B.2.
    """
    _, ds1, ds2 = CEMENT[cement]
    dry = 1.55 * (1.0 - (RH / 100.0) ** 3)
    unrestrained = 0.85e-6 * (220.0 + 110.0 * ds1) * exp(-ds2 * (fck + 8.0) / 10.0) * dry
    kh = float(np.interp(h0, (100.0, 200.0, 300.0, 500.0), (1.0, 0.85, 0.75, 0.70)))
    return kh * unrestrained * (t - ts) / (t - ts + 0.04 * sqrt(h0**3))


def autogenous_shrinkage(t: float, fck: float) -> float:
    """eps_ca(t), positive.

    EN 1992-1-1, 3.1.4 (6), eq. (3.11) to (3.13).
    """
    return 2.5e-6 * (fck - 10.0) * (1.0 - exp(-0.2 * sqrt(t)))


def relaxation(share: float, hours: float, kind: int, rho_1000: float | None = None) -> float:
    """Loss over initial stress; share: initial stress over fpk; kind: class 1, 2 or 3.

    EN 1992-1-1 eq. (3.28), (3.29), (3.30).
    """
    factor, power = RELAXATION[kind]
    rho = RHO_1000[kind] if rho_1000 is None else rho_1000
    return float(factor * rho * exp(power * share) * (hours / 1000.0) ** (0.75 * (1.0 - share)) * 1e-5)


def losses(
    sigma_c: float, Ep: float, Ecm: float, Ap: float, Ac: float, Ic: float, zcp: float, phi: float,
    eps_cs: float, relaxed: float,
) -> TimeLoss:  # fmt: skip
    """Loss by the three together; sigma_c: compression of the concrete at the tendon under the
    quasi-permanent load; relaxed: relaxation of the tendon [MPa] at constant length; MPa, mm.

    EN 1992-1-1, 5.10.6 (2), eq. (5.46). Each part is its term over the common denominator.
    """
    stiff = Ep * Ap / (Ecm * Ac) * (1.0 + Ac / Ic * zcp**2) * (1.0 + 0.8 * phi)
    share = 1.0 / (1.0 + stiff)
    creep = Ep / Ecm * phi * max(sigma_c, 0.0) * share
    formula = (
        "(eps_cs Ep + 0.8 relaxation + Ep/Ecm phi sigma,c) / "
        "(1 + Ep Ap/(Ecm Ac) (1 + Ac zcp^2/Ic)(1 + 0.8 phi))"
    )
    causes = creep, eps_cs * Ep * share, 0.8 * relaxed * share
    return by_time(*causes, formula, "EN 1992-1-1 (5.46)", phi, eps_cs)
