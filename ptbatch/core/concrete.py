"""Concrete: stress from strain, tension positive, both branches and their reversal.

On reversal from compression a fibre unloads straight, at most with the law's initial modulus, to the residual
strain of Karsan and Jirsa (1969), and returns on the same line: crushed concrete does not regain its
strength. Tension is counted from that residual strain. On reversal from a crack it returns along the secant
to where tension is counted from, and reopens on it: an opened crack does not carry ft again. Beyond
`crushing_strain` the last stress is held: the member has failed by then (the event is reported and capacity
is taken no later), and the curve that follows is for information.

Nearly all laws are made of a few parabolas, so that a fibre picks the coefficients of the one it is on,
without a branch in the code, and a layer in all sections is one loop that the processor can take several
fibres of at a time. Of a law with a power in it the tangent takes their place.
"""

from typing import NamedTuple

from ptbatch.core.jit import inlined, kernel
from ptbatch.core.power import positive_power

HOGNESTAD, PARABOLA_RECTANGLE, POPOVICS, ELASTIC = range(4)
NO_TENSION, SOFTENING, STIFFENING = range(3)
TINY = 1e-15  # as a share of a strain: next to nothing of it, next to all of it
FREE = 5  # where the history of a fibre has what it strains without a stress: see `commit_fibres`


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
    curved: bool  # whether the compression branch has a power in it, so that `pressed` is not used
    pressed: tuple  # of 3 pieces (up to which strain, a, b, c) of a + b x + c x^2; the last one goes on
    opened: tuple  # of 4 pieces (up to which strain, a, b) of a + b x; then zero


@inlined
def power_law(x, c):
    """Envelope stress (positive) and its slope, at a compressive strain x > 0, of the laws with a power in
    them, short of the strain that they hold their stress from.

    EN 1992-1-1 (3.17): parabola-rectangle. Popovics (1973) in Collins and Mitchell's form.
    """
    n, ratio, parabolic = c.exponent, x / c.eps_c, c.law == PARABOLA_RECTANGLE
    base = 1.0 - ratio if parabolic else ratio
    p = positive_power(base, n)
    scale = n / (n - 1.0 + p)
    stress = 1.0 - p if parabolic else scale * ratio
    slope = n * p / base if parabolic else (n - 1.0) / n * scale * scale * (1.0 - p)
    return c.fc * stress, c.fc / c.eps_c * slope


@inlined
def tangent_line(x, c):
    """Coefficients (a, b, 0) of the tangent to the envelope of these laws at x; a fibre in tension gets that
    at zero."""
    last = min(c.crushing_strain, c.eps_c) if c.law == PARABOLA_RECTANGLE else c.crushing_strain
    within = x < last
    x = x if x > TINY * c.eps_c else TINY * c.eps_c
    stress, slope = power_law(x if within else (1.0 - TINY) * last, c)
    slope = slope if within else 0.0
    return stress - slope * x, slope, 0.0


@kernel
def parabola(x, c):
    """Coefficients (a, b, c) of a + b x + c x^2, the envelope at a compressive strain x >= 0 of a law that is
    made of pieces."""
    p, q, r = c.pressed
    first, second = x <= p[0], x <= q[0]
    a = p[1] if first else (q[1] if second else r[1])
    b = p[2] if first else (q[2] if second else r[2])
    return a, b, p[3] if first else (q[3] if second else r[3])


@kernel
def opened(x, c):
    """Coefficients (a, b) of a + b x, the envelope at a tensile strain x >= 0."""
    o, p, q, r = c.opened
    a = o[1] if x <= o[0] else (p[1] if x <= p[0] else (q[1] if x <= q[0] else r[1]))
    b = o[2] if x <= o[0] else (p[2] if x <= p[0] else (q[2] if x <= q[0] else r[2]))
    within = x < r[0]
    return a if within else 0.0, b if within else 0.0


@kernel
def piece(eps, worst_opening, secant, worst_pressed, unloading, residual, envelope, c):
    """Coefficients (a, b, c) of a + b eps + c eps^2, the stress of a fibre at the strain eps.

    worst_opening .. residual: its history, see `commit_fibres`; envelope: that of compression at -eps.
    """
    opening = eps + residual
    a, b = opened(opening, c)
    back = opening < worst_opening
    a, b = (0.0 if back else a), (secant if back else b)
    under = -eps < worst_pressed
    d = unloading * residual if under else -envelope[0]
    e = unloading if under else envelope[1]
    f = 0.0 if under else -envelope[2]
    tense = opening > 0.0  # at rest a fibre shows its compressive modulus, also where tension has none
    return a + b * residual if tense else d, b if tense else e, 0.0 if tense else f


@inlined
def fibres(y, eps0, kappa, past, c, stress, modulus):
    """Stress and modulus (k,) of the layer at height y in k sections with the histories past (6, k), under
    the strains eps0 - y kappa less what the concrete does by itself."""
    if c.curved:
        evaluate(y, eps0, kappa, past, c, True, stress, modulus)
    else:
        evaluate(y, eps0, kappa, past, c, False, stress, modulus)


@inlined
def evaluate(y, eps0, kappa, past, c, curved, stress, modulus):
    """`fibres` of either kind of law."""
    for s in range(eps0.size):
        eps = eps0[s] - y * kappa[s] - past[FREE, s]
        envelope = tangent_line(-eps, c) if curved else parabola(-eps, c)
        a, b, d = piece(eps, past[0, s], past[1, s], past[2, s], past[3, s], past[4, s], envelope, c)
        stress[s] = a + eps * (b + eps * d)
        modulus[s] = b + 2.0 * eps * d


@kernel
def residual_strain(x, stress, c):
    """Residual strain (positive) after unloading from the compressive strain x and the stress there; Karsan
    and Jirsa (1969) as fitted by Kent, Scott and Park, and never less than unloading with the initial modulus
    leaves.
    """
    ratio = x / c.eps_c
    residual = (0.145 * ratio + 0.13) * ratio if ratio < 2.0 else 0.707 * (ratio - 2.0) + 0.834
    return min(residual * c.eps_c, x - stress / c.E0)


@inlined
def commit_fibres(y, eps0, kappa, past, c):
    """Move the histories past (6, k) of a layer on where the strains exceed them; arguments as of `fibres`.

    Strains and moduli as magnitudes: worst tension, its secant, worst compression, its unloading modulus and
    residual strain. The last one, `FREE`, is the strain of creep and shrinkage, tension positive.
    """
    if c.curved:
        move_on(y, eps0, kappa, past, c, True)
    else:
        move_on(y, eps0, kappa, past, c, False)


@inlined
def move_on(y, eps0, kappa, past, c, curved):
    """`commit_fibres` of either kind of law."""
    for s in range(eps0.size):
        eps = eps0[s] - y * kappa[s] - past[FREE, s]
        opening = eps + past[4, s]
        if opening > past[0, s]:
            a, b = opened(opening, c)
            past[0, s] = opening
            past[1, s] = a / opening + b
        elif -eps > past[2, s]:
            a, b, d = tangent_line(-eps, c) if curved else parabola(-eps, c)
            stress = a - eps * (b - eps * d)
            residual = residual_strain(-eps, stress, c)
            past[2, s] = -eps
            past[3, s] = stress / (-eps - residual)
            past[4, s] = residual
