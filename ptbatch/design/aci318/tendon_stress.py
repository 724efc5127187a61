"""Stress of the tendon at nominal flexural strength, approximately."""

from ptbatch.design.aci318 import PSI

SLENDER = 35.0  # span to depth


def applies(fse: float, fpu: float) -> bool:
    """Whether the approximate expressions may be used: fse is at least half of fpu.

    ACI 318-19, 20.3.2.3.1 and 20.3.2.4.1.
    """
    return fse >= 0.5 * fpu


def unbonded(fse: float, fc: float, rho_p: float, fpy: float, span_to_depth: float) -> float:
    """fps of unbonded tendons [MPa]; rho_p = Aps / (b dp).

    ACI 318-19 table 20.3.2.4.1.
    """
    divisor, most = (100.0, 60_000.0) if span_to_depth <= SLENDER else (300.0, 30_000.0)
    return min(fse + 10_000.0 * PSI + fc / (divisor * rho_p), fse + most * PSI, fpy)


def gamma_p(fpy: float, fpu: float) -> float:
    """Factor for the type of tendon.

    ACI 318-19 table 20.3.2.3.1.
    """
    ratio = fpy / fpu
    return 0.28 if ratio >= 0.90 else 0.40 if ratio >= 0.85 else 0.55


def bonded(
    fpu: float, fpy: float, fc: float, beta1: float, rho_p: float, d_over_dp: float, omega: float,
    omega_compression: float, d_compression_over_dp: float,
) -> float:  # fmt: skip
    """fps of bonded tendons [MPa]; omega = rho fy / fc of the bars in tension, omega_compression of those in
    compression. These count only within 0.15 dp of the compressed face, and then rho_p fpu / fc + d / dp
    (omega - omega') is taken as 0.17 at least.

    ACI 318-19 eq. (20.3.2.3.1) and 20.3.2.3.2.
    """
    counts = omega_compression > 0.0 and d_compression_over_dp <= 0.15
    term = rho_p * fpu / fc + d_over_dp * (omega - (omega_compression if counts else 0.0))
    if counts:
        term = max(term, 0.17)
    return fpu * (1.0 - gamma_p(fpy, fpu) / beta1 * term)
