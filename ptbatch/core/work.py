"""Scratch arrays of one analysis, allocated once: nothing is allocated inside an iteration."""

from typing import NamedTuple

import numpy as np

from ptbatch.core.contact_tangent import COLUMNS


class Work(NamedTuple):
    """n beam elements, ndof = 5 n + 7, half = half bandwidth."""

    f: np.ndarray  # (ndof,) internal forces
    residual: np.ndarray  # (ndof,)
    trial: np.ndarray  # (ndof,) displacements under iteration
    before: np.ndarray  # (ndof,) those that a line search starts from
    du: np.ndarray  # (ndof,)
    du_load: np.ndarray  # (ndof,) response to the live pattern
    matrix: np.ndarray  # (ndof, 3 half + 1), see `banded`
    weights: np.ndarray  # (ndof,) one over the largest number of each row
    multipliers: np.ndarray  # (ndof, half)
    pivots: np.ndarray  # (ndof,) int
    reach: np.ndarray  # (ndof,) int
    place: np.ndarray  # (n+2, 2) tendon nodes' displacements
    turn: np.ndarray  # (n+1, 2) cosine and sine of the beam nodes' rotations
    T: np.ndarray  # (n+1,) tendon element: tension,
    slope: np.ndarray  # (n+1,) its derivative by length,
    length: np.ndarray  # (n+1,) current length,
    stretch: np.ndarray  # (n+1,) strain
    chord: np.ndarray  # (n+1, 2) and direction
    segment: np.ndarray  # (n+2,) int
    xi: np.ndarray  # (n+2,)
    s: np.ndarray  # (n+2,)
    hats: np.ndarray  # (n+2,) s with the anchors in place of the ends
    rough: np.ndarray  # (n+2,)
    normal: np.ndarray  # (n+2,) contact force N
    shear: np.ndarray  # (n+2,) contact force T_t; at the ends J - T
    motion: np.ndarray  # (n+2,) int, of the tendon nodes along the duct in the last iteration
    held_back: np.ndarray  # (1,) int, how many of them were held where friction alone would not
    spent: np.ndarray  # (1,) int, iterations so far
    on_beam: np.ndarray  # (n+1, 3) for the check by statics: forces on the beam nodes,
    left_end: np.ndarray  # (n+1, 3) and those of the fibres at the left end of each element
    half_tan: np.ndarray  # (2,) tan(theta/2) of the kinks at the anchors
    norms: np.ndarray  # (16,) the last residuals
    duct: np.ndarray  # (n+2, 8) what each tendon node does to itself and its duct, see `contact_forces`
    frame: np.ndarray  # (n, 3) cosine and sine of each beam element's chord, and its length
    strain: np.ndarray  # (2, 2n) of all sections: eps0, kappa,
    section: np.ndarray  # (5, 2n) and N, M, EA, ES, EI
    fibre: np.ndarray  # (2, 2n) stress and modulus of one layer in all sections
    f6: np.ndarray
    q6: np.ndarray
    k6: np.ndarray  # (6, 6)
    k2: np.ndarray  # (2, 2)
    q8: np.ndarray
    f8: np.ndarray
    columns: np.ndarray  # (4 COLUMNS,) of a contact element, see `contact_tangent`
    z6: np.ndarray  # complex
    w6: np.ndarray
    d7: np.ndarray  # (7, 2)
    # The tendon as a chain, see `slide`, of its nodes:
    ahead: np.ndarray  # (n+2,) how far they move on; zero at the anchors
    axis: np.ndarray  # (n+2, 2) in which direction
    pace: np.ndarray  # (n+2,) by how much that takes them along the duct at rest, as a share of it
    along: np.ndarray  # (n+2, 2) cosines of the chords left and right to that
    grip: np.ndarray  # (n+2, 2) most friction by the tensions left and right
    sense: np.ndarray  # (n+2,) int, how they move along the duct
    diagonal: np.ndarray  # (n+2,)
    upper: np.ndarray  # (n+2,)
    kinks: np.ndarray  # (2, 2, 2n+1), before a node and beyond it: how far the first one moves, the tension
    turner: np.ndarray  # (2, 2n+1) int


def new_work(n: int, half: int) -> Work:
    """Work for n beam elements and a half bandwidth."""
    ndof = 5 * n + 7
    vectors = [np.zeros(ndof) for _ in range(6)]
    complex_scratch = [np.zeros(size, np.complex128) for size in (6, 6)]
    arrays = [
        *vectors,
        np.zeros((ndof, 3 * half + 1)),
        np.zeros(ndof),
        np.zeros((ndof, half)),
        np.zeros(ndof, np.int64),
        np.zeros(ndof, np.int64),
        np.zeros((n + 2, 2)),
        np.zeros((n + 1, 2)),
        *[np.zeros(n + 1) for _ in range(4)],
        np.zeros((n + 1, 2)),
        np.zeros(n + 2, np.int64),
        np.full(n + 2, 0.5),
        *[np.zeros(n + 2) for _ in range(5)],
        np.zeros(n + 2, np.int64),
        np.zeros(1, np.int64),
        np.zeros(1, np.int64),
        np.zeros((n + 1, 3)),
        np.zeros((n + 1, 3)),
        np.zeros(2),
        np.zeros(16),
        np.zeros((n + 2, 8)),
        np.zeros((n, 3)),
        np.zeros((2, 2 * n)),
        np.zeros((5, 2 * n)),
        np.zeros((2, 2 * n)),
        np.zeros(6),
        np.zeros(6),
        np.zeros((6, 6)),
        np.zeros((2, 2)),
        np.zeros(8),
        np.zeros(8),
        np.zeros(4 * COLUMNS),
        *complex_scratch,
        np.zeros((7, 2)),
        np.zeros(n + 2),
        np.zeros((n + 2, 2)),
        np.ones(n + 2),
        *[np.zeros((n + 2, 2)) for _ in range(2)],
        np.zeros(n + 2, np.int64),
        *[np.zeros(n + 2) for _ in range(2)],
        np.zeros((2, 2, 2 * n + 1)),
        np.zeros((2, 2 * n + 1), np.int64),
    ]
    return Work(*arrays)
