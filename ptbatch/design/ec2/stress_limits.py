"""Stresses in the tendon that are permitted while and after stressing."""


def jacking(fpk: float, fp01k: float, k1: float = 0.8, k2: float = 0.9) -> float:
    """Largest stress during tensioning [MPa].

    EN 1992-1-1, 5.10.2.1 (1), eq. (5.41).
    """
    return min(k1 * fpk, k2 * fp01k)


def after_transfer(fpk: float, fp01k: float, k7: float = 0.75, k8: float = 0.85) -> float:
    """Largest stress just after transfer [MPa].

    EN 1992-1-1, 5.10.3 (2), eq. (5.43).
    """
    return min(k7 * fpk, k8 * fp01k)
