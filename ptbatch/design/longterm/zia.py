"""Losses by Zia, Preston, Scott and Workman (1979), as ACI 423.10R recommends them for ordinary buildings.

Elastic shortening and friction are those of the analysis, so that ES is not among the losses here: all
strands of a member are jacked at once, and the jack measures the shortening.
"""

from typing import NamedTuple

import numpy as np

from ptbatch.design.aci318 import PSI
from ptbatch.design.longterm import TimeLoss, by_time

K_CR = 1.6  # post-tensioned, normal weight
# Days from the end of moist curing to prestressing, and K_sh
DAYS = (1.0, 3.0, 5.0, 7.0, 10.0, 20.0, 30.0, 60.0)
K_SH = (0.92, 0.85, 0.80, 0.77, 0.73, 0.64, 0.58, 0.45)


class Strand(NamedTuple):
    """Kre [psi], J, and C by the ratio fpi / fpu of 0.60, 0.61 .. (up to the last one tabulated)."""

    K_re: float
    J: float
    C: tuple[float, ...]


STRANDS = {
    "low": Strand(
        5000.0,
        0.040,
        (
            *(0.33, 0.37, 0.41, 0.45, 0.49, 0.53, 0.57, 0.61, 0.66, 0.70),
            *(0.75, 0.80, 0.85, 0.90, 0.95, 1.00, 1.05, 1.11, 1.16, 1.22, 1.28),
        ),
    ),
    "normal": Strand(
        20_000.0,
        0.15,
        (
            *(0.49, 0.53, 0.58, 0.63, 0.68, 0.73, 0.78, 0.83, 0.89, 0.94),
            *(1.00, 1.09, 1.18, 1.27, 1.36, 1.45),
        ),
    ),
}


def creep(fcpa: float, Ep: float, Ec: float) -> float:
    """CR = Kcr (Es / Ec) fcpa [MPa]; fcpa: compression of the concrete at the tendon under prestress and the
    sustained load, averaged along the member where the tendon is unbonded."""
    return K_CR * Ep / Ec * max(fcpa, 0.0)


def shrinkage(Ep: float, V_S: float, RH: float, days: float) -> float:
    """SH = 8.2e-6 Ksh Es (1 - 0.06 V/S) (100 - RH) [MPa]; V_S in mm (the 0.06 is per inch), RH in %."""
    K_sh = float(np.interp(np.log(days), np.log(DAYS), K_SH))
    return max(8.2e-6 * K_sh * Ep * (1.0 - 0.06 * V_S / 25.4) * (100.0 - RH), 0.0)


def relaxation(fpi: float, fpu: float, before: float, kind: str) -> float:
    """RE = [Kre - J (SH + CR + ES)] C [MPa]; fpi: stress after anchoring; before: SH + CR + ES [MPa].

    Between its entries C is interpolated; below the first one it is that one, which is safe.
    """
    strand = STRANDS[kind]
    ratios = 0.60 + 0.01 * np.arange(len(strand.C))
    C = float(np.interp(fpi / fpu, ratios, strand.C))
    return max((strand.K_re * PSI - strand.J * before) * C, 0.0)


def losses(
    fcpa: float, fpi: float, fpu: float, Ep: float, Ec: float, V_S: float, RH: float, days: float, kind: str
) -> TimeLoss:
    """All three; MPa, mm, %, days from the end of curing to stressing; kind of strand: low or normal."""
    CR, SH = creep(fcpa, Ep, Ec), shrinkage(Ep, V_S, RH, max(days, DAYS[0]))
    RE = relaxation(fpi, fpu, CR + SH, kind)
    formula = "1.6 (Es/Ec) fcpa + 8.2e-6 Ksh Es (1 - 0.06 V/S) (100 - RH) + [Kre - J (SH + CR)] C"
    return by_time(CR, SH, RE, formula, "ACI 423.10R, Zia et al. (1979)", K_CR, SH / Ep)
