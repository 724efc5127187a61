"""Stresses in the tendon that are permitted while and after stressing."""


def jacking(fpu: float, fpy: float) -> float:
    """Largest stress due to the jacking force [MPa].

    ACI 318-19 table 20.3.2.5.1. What the maker of tendon or anchorage recommends may be lower.
    """
    return min(0.94 * fpy, 0.80 * fpu)


def at_anchorages(fpu: float) -> float:
    """Largest stress at post-tensioning anchorages, just after force transfer [MPa].

    ACI 318-19 table 20.3.2.5.1.
    """
    return 0.70 * fpu
