"""Bending resistance: design strengths, the stress block, unbonded tendons, least reinforcement."""

from ptbatch.design.flexure import Block


def fctm(fck: float) -> float:
    """Mean tensile strength [MPa].

    EN 1992-1-1 table 3.1.
    """
    from math import log

    return float(0.30 * fck ** (2.0 / 3.0)) if fck <= 50.0 else 2.12 * log(1.0 + (fck + 8.0) / 10.0)


def block(fck: float, gamma_c: float = 1.5, alpha_cc: float = 1.0) -> Block:
    """The rectangular stress block with lambda, eta and eps_cu3.

    EN 1992-1-1, 3.1.6, 3.1.7 (3) and table 3.1.
    """
    over = max(0.0, fck - 50.0)
    strain = 0.0035 if fck <= 50.0 else 0.0026 + 0.035 * ((90.0 - fck) / 100.0) ** 4
    eta, share = 1.0 - over / 200.0, 0.8 - over / 400.0
    return Block(eta * alpha_cc * fck / gamma_c, share, strain)


def unbonded_stress(fse: float, increase: float = 100.0) -> float:
    """Stress of unbonded tendons in the ultimate limit state [MPa].

    EN 1992-1-1, 5.10.8 (2): the effective prestress and 100 MPa.
    """
    return fse + increase


def least_reinforcement(fck: float, fyk: float, bt: float, d: float) -> float:
    """As,min [mm2]; bt: mean width of the tension zone, d: effective depth [mm].

    EN 1992-1-1, 9.2.1.1 (1), eq. (9.1N).
    """
    return max(0.26 * fctm(fck) / fyk, 0.0013) * bt * d
