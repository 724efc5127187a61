"""Concrete: stress from strain, tension positive, both branches and their reversal.

On reversal from compression a fibre unloads straight, at most with the law's initial modulus, to the residual
strain of Karsan and Jirsa (1969), and returns on the same line: crushed concrete does not regain its
strength. Tension is counted from that residual strain. On reversal from a crack it returns along the secant
to where tension is counted from, and reopens on it: an opened crack does not carry ft again. Beyond
`crushing_strain` the last stress is held: the member has failed by then (the event is reported and capacity
is taken no later), and the curve that follows is for information.
"""

from typing import NamedTuple

from ptbatch.core.jit import inverse, kernel, power

HOGNESTAD, PARABOLA_RECTANGLE, POPOVICS, ELASTIC = range(4)
NO_TENSION, SOFTENING, STIFFENING = range(3)


class Concrete(NamedTuple):
    """Parameters of the two laws; stresses in MPa, strains and stress positive here for either branch."""

    law: int
    fc: float
    Ec: float
    E0: float  # initial modulus of the compression branch
    eps_c: float  # strain at fc
    exponent: float  # of parabola-rectangle (n) or popovics (r)
    crushing_strain: float
    tension_law: int
    ft: float
    eps_cr: float
    eps_end: float  # where the tension branch reaches zero


@kernel
def compression(x, c):
    """Envelope stress (positive) at a compressive strain x >= 0.

    Hognestad (1951): parabola to fc, straight to 0.85 fc at the crushing strain. EN 1992-1-1 (3.17):
    parabola-rectangle. Popovics (1973) in Collins and Mitchell's form.
    """
    if c.law == ELASTIC:
        return c.Ec * x
    if x.real > c.crushing_strain:
        x = c.crushing_strain + 0.0 * x
    ratio = x * (1.0 / c.eps_c)
    if c.law == HOGNESTAD:
        if ratio.real <= 1.0:
            return c.fc * ratio * (2.0 - ratio)
        return c.fc * (1.0 - (x - c.eps_c) * (0.15 / (c.crushing_strain - c.eps_c)))
    if c.law == PARABOLA_RECTANGLE:
        if ratio.real >= 1.0:
            return c.fc + 0.0 * x
        if c.exponent == 2.0:
            return c.fc * ratio * (2.0 - ratio)
        return c.fc * (1.0 - power(1.0 - ratio, c.exponent))
    if ratio.real == 0.0:
        return c.fc * c.exponent / (c.exponent - 1.0) * ratio
    return c.fc * c.exponent * ratio * inverse(c.exponent - 1.0 + power(ratio, c.exponent))


@kernel
def tension(x, c):
    """Envelope stress at a tensile strain x >= 0.

    `softening`: straight from ft to zero at eps_end. `stiffening`: Nayal and Rasheed (2006) after Gilbert and
    Warner (1978), 0.8 ft just after cracking, 0.45 ft at 4 eps_cr, zero at 10 eps_cr, stretched to eps_end;
    the sudden drop to 0.8 ft is spread over the first quarter of eps_cr, so that stress is a function of
    strain.
    """
    if c.law == ELASTIC:
        return c.Ec * x
    if c.tension_law == NO_TENSION or x.real >= c.eps_end:
        return 0.0 * x
    if x.real <= c.eps_cr:
        return c.ft / c.eps_cr * x
    if c.tension_law == SOFTENING:
        return (c.eps_end - x) * (c.ft / (c.eps_end - c.eps_cr))
    knee = c.eps_cr + (c.eps_end - c.eps_cr) / 36.0
    middle = c.eps_cr + (c.eps_end - c.eps_cr) / 3.0
    if x.real <= knee:
        return c.ft * (1.0 - (x - c.eps_cr) * (0.23 / (knee - c.eps_cr)))
    if x.real <= middle:
        return c.ft * (0.77 - (x - knee) * (0.32 / (middle - knee)))
    return (c.eps_end - x) * (0.45 * c.ft / (c.eps_end - middle))


@kernel
def concrete_stress(eps, past, c):
    """Stress of a fibre. past, five strains and moduli as magnitudes: worst tension, its secant, worst
    compression, its unloading modulus and residual strain.
    """
    opening = eps + past[4]
    if opening.real > 0.0:  # at rest a fibre shows its compressive modulus, also where tension has none
        return past[1] * opening if opening.real < past[0] else tension(opening, c)
    return past[3] * opening if -eps.real < past[2] else -compression(-eps, c)


@kernel
def residual_strain(x, c):
    """Residual strain (positive) after unloading from the compressive strain x; Karsan and Jirsa (1969) as
    fitted by Kent, Scott and Park, and never less than unloading with the initial modulus leaves.
    """
    ratio = x / c.eps_c
    residual = 0.145 * ratio**2 + 0.13 * ratio if ratio < 2.0 else 0.707 * (ratio - 2.0) + 0.834
    return min(residual * c.eps_c, x - compression(x, c) / c.E0)


@kernel
def commit_concrete(eps, past, c):
    """Move the worst strains on where eps exceeds them."""
    if c.law == ELASTIC:
        return
    opening = eps + past[4]
    if opening > past[0]:
        past[0] = opening
        past[1] = tension(opening, c) / opening
    elif -eps > past[2]:
        past[2] = -eps
        past[4] = residual_strain(-eps, c)
        past[3] = compression(-eps, c) / (-eps - past[4])
