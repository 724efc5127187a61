"""Section moments from equilibrium alone: reactions and loads on one side of the section, on the deflected
member."""

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.beam import GAUSS

Array = NDArray[np.float64]


def section_moments(x: Array, u: Array, forces: Array) -> Array:
    """Bending moments (..., n, 2) in N mm at the Gauss sections, sagging positive, everything included.

    x (n+1,) nodes; u (..., ndof) displacements; forces (..., ndof) the external nodal forces, reactions
    included.
    """
    across, up, turn = (node_values(forces, len(x), i) for i in range(3))
    place_x, place_y = x + node_values(u, len(x), 0), node_values(u, len(x), 1)
    about_origin = np.cumsum(place_x * up - place_y * across + turn, axis=-1)[..., :-1, None]
    across_left, up_left = (np.cumsum(force, axis=-1)[..., :-1, None] for force in (across, up))
    at_x, at_y = (
        place[..., :-1, None] + np.diff(place)[..., None] * np.array(GAUSS) for place in (place_x, place_y)
    )
    return np.asarray(at_x * up_left - at_y * across_left - about_origin)


def node_values(vector: Array, nodes: int, component: int) -> Array:
    """Component 0 u, 1 v or 2 theta of the beam nodes from arrays (..., ndof) in the kernels' numbering."""
    return vector[..., 2 + component : 5 * nodes : 5]
