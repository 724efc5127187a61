"""Functions that are smooth within each of several pieces, by their values at the Gauss points there: their
integrals, and where they rise above zero. Within a piece each is the polynomial through these values.
"""

import numpy as np
from numpy.polynomial.legendre import legint, legval, legvander
from scipy.optimize import brentq

from ptbatch.geometry.curve import GAUSS_POINTS, GAUSS_WEIGHTS, Array, Side

_COUNT = GAUSS_POINTS.size
_ALONG = 2.0 * GAUSS_POINTS - 1.0  # the points on (-1, 1), where Legendre's polynomials live
# From values at the points to coefficients of Legendre's polynomials, by their orthogonality
_SERIES = (2.0 * np.arange(_COUNT)[:, None] + 1.0) * GAUSS_WEIGHTS * legvander(_ALONG, _COUNT - 1).T
# From values at the points to integrals over (0, 1) up to each of them
_UP_TO = 0.5 * legval(_ALONG, legint(_SERIES, lbnd=-1)).T
_AT_EDGES = legvander(np.array([-1.0, 1.0]), _COUNT - 1) @ _SERIES


def running_integral(integrand: Array, end: Side = "left") -> Array:
    """Integral of an integrand (pieces, points), times the length of its piece, from an end up to each of the
    points."""
    seen = _seen_from(end, integrand)
    whole = seen @ GAUSS_WEIGHTS
    return _seen_from(end, (np.cumsum(whole) - whole)[:, None] + seen @ _UP_TO.T)


def first_rise(edges: Array, values: Array, within: float, end: Side = "left") -> float | None:
    """The place nearest to an end where a function, negative there, becomes positive, to `within` of a piece;
    None if it does not. edges: (pieces + 1,), where the function may jump; values: (pieces, points)."""
    if end == "right":
        place = first_rise(-edges[::-1], _seen_from(end, values), within)
        return None if place is None else -place
    before, after = _AT_EDGES @ values.T
    risen = np.flatnonzero((before > 0.0) | (after > 0.0))
    if not risen.size:
        return None
    first = int(risen[0])
    series = _SERIES @ values[first]
    if legval(-1.0, series) >= 0.0:
        along = -1.0
    elif legval(1.0, series) <= 0.0:  # but for round-off
        along = 1.0
    else:
        along = float(brentq(legval, -1.0, 1.0, (series,), xtol=2.0 * within))
    return float(edges[first] + (edges[first + 1] - edges[first]) * 0.5 * (1.0 + along))


def _seen_from(end: Side, values: Array) -> Array:
    return values if end == "left" else values[::-1, ::-1]
