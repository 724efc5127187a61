"""Section moments from equilibrium alone: reactions and loads on one side of the section, on the deflected
member."""

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.beam import GAUSS

Array = NDArray[np.float64]


def section_moments(x: Array, u: Array, forces: Array) -> Array:
    """Bending moment (n, 2) in N mm at the Gauss sections, sagging positive, everything included.

    x (n+1,) nodes; u (ndof,) displacements; forces (ndof,) the external nodal forces, reactions included.
    """
    across, up, turn = (node_values(forces, len(x), i) for i in range(3))
    place_x, place_y = x + node_values(u, len(x), 0), node_values(u, len(x), 1)
    moment = np.empty((len(x) - 1, 2))
    for g, xi in enumerate(GAUSS):
        at_x = place_x[:-1] + xi * np.diff(place_x)
        at_y = place_y[:-1] + xi * np.diff(place_y)
        left = np.tri(len(x) - 1, len(x), dtype=bool)
        lever_x = np.where(left, at_x[:, None] - place_x, 0.0)
        lever_y = np.where(left, at_y[:, None] - place_y, 0.0)
        moment[:, g] = lever_x @ up - lever_y @ across - np.where(left, turn, 0.0).sum(axis=1)
    return moment


def node_values(vector: Array, nodes: int, component: int) -> Array:
    """Component 0 u, 1 v or 2 theta of the beam nodes from arrays (..., ndof) in the kernels' numbering."""
    return vector[..., 2 + component : 5 * nodes : 5]
