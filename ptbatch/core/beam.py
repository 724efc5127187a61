"""Fibre-section Euler-Bernoulli beam element, co-rotational: cubic deflection and constant axial strain about
its own chord.

Two Gauss sections an element; at these points the bending moment under uniform load is exact. What happens in
the sections is done for all of them at once, in `section`: strains first, then the sections, then the
elements.
"""

import numpy as np

from ptbatch.core.jit import inlined, kernel
from ptbatch.core.model import element_displacements

GAUSS = 0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0)


@kernel
def chord(length, d):
    """(elongation, cosine, sine, current length, end rotations 1 and 2 from the chord) from the element's six
    displacements."""
    du = d[3] - d[0]
    dv = d[4] - d[1]
    now = np.sqrt((length + du) ** 2 + dv**2)
    elongation = (2.0 * length * du + du * du + dv * dv) / (now + length)
    turn = np.arctan2(dv, length + du)
    return elongation, (length + du) / now, dv / now, now, d[2] - turn, d[5] - turn


@kernel
def strains(length, elongation, turn1, turn2, xi):
    """(eps0, kappa) of the section at xi in 0..1."""
    return elongation / length, ((6.0 * xi - 4.0) * turn1 + (6.0 * xi - 2.0) * turn2) / length


@kernel
def beam_strains(model, u, work):
    """work.frame and work.strain of all elements and their sections at the displacements u."""
    for e in range(model.x.size - 1):
        element_displacements(e, u, work.q6)
        length = model.x[e + 1] - model.x[e]
        elongation, c, s, now, turn1, turn2 = chord(length, work.q6)
        work.frame[e, 0], work.frame[e, 1], work.frame[e, 2] = c, s, now
        for g in range(2):
            eps0, kappa = strains(length, elongation, turn1, turn2, GAUSS[g])
            work.strain[0, 2 * e + g] = eps0
            work.strain[1, 2 * e + g] = kappa


@kernel
def beam_forces(e, work, f):
    """Nodal forces f (6,) of element e from those of its sections; returned as well: its axial force and
    shear."""
    N = M1 = M2 = 0.0
    for g in range(2):
        xi, Mg = GAUSS[g], work.section[1, 2 * e + g]
        N += 0.5 * work.section[0, 2 * e + g]
        M1 += 0.5 * (6.0 * xi - 4.0) * Mg
        M2 += 0.5 * (6.0 * xi - 2.0) * Mg
    c, s, now = work.frame[e, 0], work.frame[e, 1], work.frame[e, 2]
    shear = (M1 + M2) / now
    f[0] = -c * N - s * shear
    f[1] = -s * N + c * shear
    f[2] = M1
    f[3] = -f[0]
    f[4] = -f[1]
    f[5] = M2
    return N, shear


@inlined
def beam_tangent(e, model, work, f, k):
    """Nodal forces f (6,) and tangent k (6, 6) of element e from those of its sections: material part by the
    moduli of the fibres, geometric part of the chord."""
    N, shear = beam_forces(e, work, f)
    k00 = k01 = k02 = k11 = k12 = k22 = 0.0
    for g in range(2):
        xi, at = GAUSS[g], 2 * e + g
        b1 = 6.0 * xi - 4.0
        b2 = 6.0 * xi - 2.0
        EA, ES, EI = work.section[2, at], work.section[3, at], work.section[4, at]
        w = 0.5 / (model.x[e + 1] - model.x[e])
        k00 += w * EA
        k01 += w * b1 * ES
        k02 += w * b2 * ES
        k11 += w * b1 * b1 * EI
        k12 += w * b1 * b2 * EI
        k22 += w * b2 * b2 * EI
    c, s, now = work.frame[e, 0], work.frame[e, 1], work.frame[e, 2]
    # By the far end along the chord (a) and across it (b: the chord turns by b / now), and the rotations
    ab = (shear - k01 - k02) / now
    bb = (k11 + 2.0 * k12 + k22) / (now * now) + N / now
    b1, b2 = -(k11 + k12) / now, -(k12 + k22) / now
    xx = c * c * k00 - 2.0 * c * s * ab + s * s * bb
    xy = c * s * (k00 - bb) + (c * c - s * s) * ab
    yy = s * s * k00 + 2.0 * c * s * ab + c * c * bb
    x1, y1 = c * k01 - s * b1, s * k01 + c * b1
    x2, y2 = c * k02 - s * b2, s * k02 + c * b2
    fill_symmetric(k, xx, xy, yy, x1, y1, x2, y2, k11, k12, k22)


@kernel
def fill_symmetric(k, xx, xy, yy, x1, y1, x2, y2, k11, k12, k22):
    """k (6, 6) from that of the far end's x and y and of the two rotations: the near end moves the other
    way."""
    k[3, 3] = k[0, 0] = xx
    k[4, 4] = k[1, 1] = yy
    k[3, 4] = k[4, 3] = k[0, 1] = k[1, 0] = xy
    k[0, 3] = k[3, 0] = -xx
    k[1, 4] = k[4, 1] = -yy
    k[0, 4] = k[4, 0] = k[1, 3] = k[3, 1] = -xy
    k[3, 2] = k[2, 3] = x1
    k[4, 2] = k[2, 4] = y1
    k[0, 2] = k[2, 0] = -x1
    k[1, 2] = k[2, 1] = -y1
    k[3, 5] = k[5, 3] = x2
    k[4, 5] = k[5, 4] = y2
    k[0, 5] = k[5, 0] = -x2
    k[1, 5] = k[5, 1] = -y2
    k[2, 2] = k11
    k[2, 5] = k[5, 2] = k12
    k[5, 5] = k22
