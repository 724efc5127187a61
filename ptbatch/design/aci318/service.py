"""Stresses of the concrete at transfer and in service that are permitted, and the class of the member."""

from ptbatch.design.aci318 import PSI


def root(fc: float) -> float:
    """sqrt(fc) as the code means it, of psi, in MPa."""
    return float((fc / PSI) ** 0.5 * PSI)


def transfer_compression(fci: float, at_end: bool) -> float:
    """Largest compression just after transfer [MPa]; at_end: at the ends of simply supported members.

    ACI 318-19 table 24.5.3.1.
    """
    return (0.70 if at_end else 0.60) * fci


def transfer_tension(fci: float, at_end: bool) -> float:
    """Tension just after transfer beyond which bonded steel has to be there [MPa].

    ACI 318-19 table 24.5.3.2.
    """
    return (6.0 if at_end else 3.0) * root(fci)


def service_compression(fc: float, sustained: bool) -> float:
    """Largest compression of class U and T members at service load [MPa].

    ACI 318-19 table 24.5.4.1.
    """
    return (0.45 if sustained else 0.60) * fc


def service_class(ft: float, fc: float) -> str:
    """U (uncracked), T (transition) or C (cracked), by the largest tension at service load [MPa].

    ACI 318-19 table 24.5.2.1.
    """
    return "U" if ft <= 7.5 * root(fc) else "T" if ft <= 12.0 * root(fc) else "C"
