"""Elastic Euler-Bernoulli beam on the member's supports: consistent loads and the point that deflects
most."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded

from ptbatch.member import Load, Member

Array = NDArray[np.float64]


def hermite(xi: Array | float, h: Array | float) -> Array:
    """Weights (4, ...) of v1, theta1, v2, theta2 in the deflection at xi of an element of length h."""
    xi, h = np.asarray(xi, dtype=float), np.asarray(h, dtype=float)
    return np.array(
        [
            1 - 3 * xi**2 + 2 * xi**3,
            h * (xi - 2 * xi**2 + xi**3),
            3 * xi**2 - 2 * xi**3,
            h * (xi**3 - xi**2),
        ]
    )


def nodal_loads(x: Array, loads: Iterable[Load]) -> Array:
    """Work-equivalent nodal forces and moments (nodes, 2) of downward loads: exact deflections at the nodes
    of an elastic beam."""
    nodal = np.zeros((len(x), 2))
    for load in loads:
        if load.type == "point":
            e = int(np.clip(np.searchsorted(x, load.x, side="right") - 1, 0, len(x) - 2))
            h = x[e + 1] - x[e]
            nodal[e : e + 2] -= load.value * hermite((load.x - x[e]) / h, h).reshape(2, 2)
            continue
        under = slice(*np.searchsorted(x, [load.x, load.x_end], side="right") - [1, 0])
        left, h = x[:-1][under], np.diff(x)[under]
        a, b = np.maximum(load.x - left, 0.0) / h, np.minimum((load.x_end - left) / h, 1.0)
        shares = load.value * h * (hermite_integral(a, h) - hermite_integral(b, h))
        nodal[:-1][under] += shares[:2].T
        nodal[1:][under] += shares[2:].T
    return nodal


def hermite_integral(xi: Array, h: Array) -> Array:
    """Integral (4, ...) of `hermite` over xi, from zero on."""
    square, half = xi * xi, 0.5 * xi
    cube = square * xi
    rest = half * cube  # xi^4 / 2
    return np.array(
        [
            xi - cube + rest,
            h * (0.5 * square - 2.0 / 3.0 * cube + 0.5 * rest),
            cube - rest,
            h * (0.5 * rest - cube / 3.0),
        ]
    )


def held_nodes(member: Member, x: Array) -> list[tuple[int, bool, bool, bool]]:
    """(node, u held, v held, theta held) of every support."""
    nodes = [int(np.argmin(np.abs(x - place))) for place in member.support_x]
    return [
        (node, kind in ("pin", "fixed"), True, kind == "fixed")
        for node, kind in zip(nodes, member.supports, strict=True)
        if kind != "free"
    ]


def elastic_deflection(member: Member, x: Array, loads: Iterable[Load]) -> Array:
    """Deflection (nodes,), up positive, of a beam with EI = 1."""
    return displacements(member, x, nodal_loads(x, loads))[:, 0]


def displacements(member: Member, x: Array, forces: Array) -> Array:
    """Deflection and rotation (nodes, 2) of a beam with EI = 1 under nodal forces and moments (nodes, 2)."""
    n = len(x)
    band = np.zeros((4, 2 * n))  # upper form of a matrix with three superdiagonals
    h = np.diff(x)
    stiffness = {  # by degrees of freedom (v1, theta1, v2, theta2) of an element, times h^3
        **{(0, 0): 12.0 + 0.0 * h, (0, 1): 6.0 * h, (0, 2): -12.0 + 0.0 * h, (0, 3): 6.0 * h},
        **{(1, 1): 4.0 * h * h, (1, 2): -6.0 * h, (1, 3): 2.0 * h * h},
        **{(2, 2): 12.0 + 0.0 * h, (2, 3): -6.0 * h, (3, 3): 4.0 * h * h},
    }
    for (i, j), k in stiffness.items():
        band[3 - (j - i), j : j + 2 * (n - 1) : 2] += k / h**3
    stiff = 1e12 * band[3].max()
    for node, _, _, turns_not in held_nodes(member, x):
        band[3, 2 * node] += stiff
        if turns_not:
            band[3, 2 * node + 1] += stiff
    return np.asarray(solveh_banded(band, forces.ravel())).reshape(n, 2)
