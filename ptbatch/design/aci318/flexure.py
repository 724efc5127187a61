"""Flexural strength: the stress block, and the factor phi by the strain of the steel."""

from ptbatch.design.aci318 import PSI
from ptbatch.design.flexure import Block

CRUSHING = 0.003


def beta1(fc: float) -> float:
    """Depth of the stress block over that of the neutral axis; fc in MPa.

    ACI 318-19 table 22.2.2.4.3.
    """
    return min(0.85, max(0.65, 0.85 - 0.05 * (fc / PSI - 4000.0) / 1000.0))


def block(fc: float) -> Block:
    """The rectangular stress block.

    ACI 318-19, 22.2.2.1 and 22.2.2.4.
    """
    return Block(0.85 * fc, beta1(fc), CRUSHING)


def phi(strain: float, yield_strain: float = 0.002) -> float:
    """Strength reduction factor by the net tensile strain of the extreme steel; prestressed steel counts with
    a yield strain of 0.002.

    ACI 318-19 table 21.2.2, not spiral.
    """
    return min(0.90, max(0.65, 0.65 + 0.25 * (strain - yield_strain) / 0.003))


def modulus_of_rupture(fc: float) -> float:
    """fr of normal-weight concrete [MPa].

    ACI 318-19 eq. (19.2.3.1).
    """
    return float(7.5 * (fc / PSI) ** 0.5 * PSI)


def least_bonded_steel(area: float) -> float:
    """As,min of members with unbonded tendons [mm2]; area: of the section between the flexural tension face
    and the centroid of the gross section [mm2].

    ACI 318-19, 7.6.2.3 and 9.6.2.3.
    """
    return 0.004 * area
