"""What the kernels read and write: one member as plain arrays.

Numbering runs along the member so that the tangent is banded: tendon node j (0 .. n+1) starts at 5 j with two
degrees of freedom, beam node k (0 .. n) at 5 k + 2 with three (u, v, theta). A tendon end node has `gap` (mm,
outward along the duct's end tangent, from its anchor) as its first degree of freedom and none as its second;
an inner one has its displacement from where it started.
"""

from typing import NamedTuple

import numpy as np

from ptbatch.core.concrete import Concrete
from ptbatch.core.jit import kernel
from ptbatch.core.steel import Steel
from ptbatch.core.tendon import Strand


class Contact(NamedTuple):
    """How tendon and duct hold each other; penalties in N/mm, K per mm."""

    normal: float
    tangential: float
    anchor: float
    mu: float
    K: float
    smooth: bool  # duct as the profile itself, else the polygon between the beam nodes
    corrected: bool  # normal force along the tendon's own bisector, eqs (16)-(20)


class Model(NamedTuple):
    """A member that is ready to be analysed; n beam elements, m concrete layers, r bars, t duct stations."""

    x: np.ndarray  # (n+1,) beam nodes
    layer_y: np.ndarray  # (m,) up from the reference axis
    layer_area: np.ndarray  # (m,)
    top: float  # (up from the reference axis) extreme fibres
    bottom: float
    bar_y: np.ndarray  # (r,)
    bar_area: np.ndarray  # (n, r)
    bar_fy: np.ndarray  # (r,)
    duct_y: np.ndarray  # (n+1,) height of the duct above the axis at the beam nodes
    duct_slope: np.ndarray  # (n, 2) of the duct at the two ends of each segment
    duct_s: np.ndarray  # (n+1,) arc length
    hat_s: np.ndarray  # (t,) stations of the tables below
    hat_turn: np.ndarray  # (t, 3) integral over arc length of the absolute angle, its slope right and left
    hat_angle: np.ndarray  # (t, 3) the same of the signed direction
    tendon_x: np.ndarray  # (n+2, 2) where tendon nodes start; ends unused
    rest_length: np.ndarray  # (n+1,)
    held: np.ndarray  # (ndof,) supports
    concrete: Concrete
    steel: Steel
    strand: Strand
    contact: Contact


class State(NamedTuple):
    """Committed state; everything that a restored step must bring back."""

    u: np.ndarray  # (ndof,)
    concrete: np.ndarray  # (m, 6, 2n) in all layers and sections, see commit_fibres
    bar: np.ndarray  # (n, 2, r) plastic strain, nan where ruptured
    tendon: np.ndarray  # (n+1,) largest strain
    segment: np.ndarray  # (n+2,) int, the duct segment of each tendon node
    s: np.ndarray  # (n+2,) arc length of the tendon nodes; of the ends what `end_slip` measures
    rub: np.ndarray  # (n+2,) friction force there: with s the history of slip, whatever the segment
    motion: np.ndarray  # (n+2,) int, how they are expected to move in the next step, see `friction`


class Ends(NamedTuple):
    """What drives the two ends of the tendon (index 0 left, 1 right)."""

    mode: np.ndarray  # (2,) int, one of the codes below
    value: np.ndarray  # (2,) gap for PRESCRIBED, force for PULLED, preload for ANCHORED
    born: np.ndarray  # (2,) gap at which an anchorage was born


PRESCRIBED, PULLED, ANCHORED = range(3)


@kernel
def tendon_dof(j):
    return 5 * j


@kernel
def beam_dof(k):
    return 5 * k + 2


@kernel
def element_displacements(e, u, q):
    """q (6,): u, v and theta of the two nodes of beam element e."""
    for i in range(3):
        q[i] = u[beam_dof(e) + i]
        q[3 + i] = u[beam_dof(e + 1) + i]
