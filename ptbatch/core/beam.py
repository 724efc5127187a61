"""Fibre-section Euler-Bernoulli beam element, co-rotational: cubic deflection and constant axial strain about
its own chord.

Two Gauss sections an element; at these points the bending moment under uniform load is exact. Sagging
curvature and moment are positive, the layer at height y strains by eps0 - y kappa.
"""

import numpy as np

from ptbatch.core.concrete import FREE, commit_concrete, fibres
from ptbatch.core.jit import STEP, kernel
from ptbatch.core.model import beam_dof
from ptbatch.core.steel import commit_steel, steel_stress

GAUSS = 0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0)


@kernel
def section_forces(eps0, kappa, model, past, plastic, bar_area, fibre):
    """(N, M) of one section; fibre (2, m) is scratch for stress and modulus of the layers."""
    y, area, stress = model.layer_y, model.layer_area, fibre[0]
    fibres(eps0, kappa, y, past, model.concrete, stress, fibre[1])
    N = M = 0.0
    for i in range(y.size):
        force = area[i] * stress[i]
        N += force
        M -= y[i] * force
    for i in range(model.bar_y.size):
        if bar_area[i] > 0.0 and not np.isnan(plastic[i]):
            height = model.bar_y[i]
            force = bar_area[i] * steel_stress(
                eps0 - height * kappa, plastic[i], model.bar_fy[i], model.steel
            )
            N += force
            M -= height * force
    return N, M


@kernel
def section_tangent(eps0, kappa, model, past, plastic, bar_area, damping, fibre):
    """(N, M, dN/deps0, dN/dkappa = dM/deps0, dM/dkappa).

    damping: added to the modulus of each concrete fibre, as a share of the uncracked one.
    """
    y, area, stress, modulus = model.layer_y, model.layer_area, fibre[0], fibre[1]
    fibres(eps0, kappa, y, past, model.concrete, stress, modulus)
    more = damping * model.concrete.E0
    N = M = EA = ES = EI = 0.0
    for i in range(y.size):
        force = area[i] * stress[i]
        stiffness = area[i] * (modulus[i] + more)
        N += force
        M -= y[i] * force
        EA += stiffness
        ES -= y[i] * stiffness
        EI += y[i] * y[i] * stiffness
    for i in range(model.bar_y.size):
        if bar_area[i] > 0.0 and not np.isnan(plastic[i]):
            height = model.bar_y[i]
            bar = steel_stress(complex(eps0 - height * kappa, STEP), plastic[i], model.bar_fy[i], model.steel)
            force = bar_area[i] * bar.real
            stiffness = bar_area[i] * (bar.imag / STEP)
            N += force
            M -= height * force
            EA += stiffness
            ES -= height * stiffness
            EI += height * height * stiffness
    return N, M, EA, ES, EI


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
def beam_forces(e, model, state, d, fibre, f):
    """Nodal forces f (6,) of element e at the displacements d (6,); fibre: see `section_forces`."""
    length = model.x[e + 1] - model.x[e]
    elongation, c, s, now, turn1, turn2 = chord(length, d)
    N = 0.0
    M1 = 0.0
    M2 = 0.0
    for g in range(2):
        xi = GAUSS[g]
        eps0, kappa = strains(length, elongation, turn1, turn2, xi)
        Ng, Mg = section_forces(
            eps0, kappa, model, state.concrete[e, g], state.bar[e, g], model.bar_area[e], fibre
        )
        N += 0.5 * Ng
        M1 += 0.5 * (6.0 * xi - 4.0) * Mg
        M2 += 0.5 * (6.0 * xi - 2.0) * Mg
    shear = (M1 + M2) / now
    f[0] = -c * N - s * shear
    f[1] = -s * N + c * shear
    f[2] = M1
    f[3] = -f[0]
    f[4] = -f[1]
    f[5] = M2


@kernel
def beam_tangent(e, model, state, d, damping, fibre, f, k):
    """Nodal forces f (6,) and tangent k (6, 6): material part by the moduli of the fibres, geometric part of
    the chord; fibre: see `section_forces`."""
    length = model.x[e + 1] - model.x[e]
    elongation, c, s, now, turn1, turn2 = chord(length, d)
    N = M1 = M2 = 0.0
    k00 = k01 = k02 = k11 = k12 = k22 = 0.0
    for g in range(2):
        xi = GAUSS[g]
        b1 = 6.0 * xi - 4.0
        b2 = 6.0 * xi - 2.0
        eps0, kappa = strains(length, elongation, turn1, turn2, xi)
        Ng, Mg, EA, ES, EI = section_tangent(
            eps0, kappa, model, state.concrete[e, g], state.bar[e, g], model.bar_area[e], damping, fibre
        )
        N += 0.5 * Ng
        M1 += 0.5 * b1 * Mg
        M2 += 0.5 * b2 * Mg
        w = 0.5 / length
        k00 += w * EA
        k01 += w * b1 * ES
        k02 += w * b2 * ES
        k11 += w * b1 * b1 * EI
        k12 += w * b1 * b2 * EI
        k22 += w * b2 * b2 * EI
    shear = (M1 + M2) / now
    f[0] = -c * N - s * shear
    f[1] = -s * N + c * shear
    f[2] = M1
    f[3] = -f[0]
    f[4] = -f[1]
    f[5] = M2
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


@kernel
def commit_beam(e, model, state, d):
    """Take the fibres' history to the displacements d (6,)."""
    length = model.x[e + 1] - model.x[e]
    elongation, _, _, _, turn1, turn2 = chord(length, d)
    for g in range(2):
        eps0, kappa = strains(length, elongation, turn1, turn2, GAUSS[g])
        past = state.concrete[e, g]
        for i in range(model.layer_y.size):
            eps = eps0 - model.layer_y[i] * kappa - past[FREE, i]
            if eps + past[4, i] > past[0, i] or -eps > past[2, i]:
                commit_concrete(eps, past[:, i], model.concrete)
        for i in range(model.bar_y.size):
            eps = eps0 - model.bar_y[i] * kappa
            state.bar[e, g, i] = commit_steel(eps, state.bar[e, g, i], model.bar_fy[i], model.steel)


@kernel
def concrete_stress(model, state, u, q, stress, modulus):
    """Stress and modulus (n, 2, m) of the concrete in all layers at the displacements u; q (6,) is
    scratch."""
    for e in range(model.x.size - 1):
        for i in range(3):
            q[i] = u[beam_dof(e) + i]
            q[3 + i] = u[beam_dof(e + 1) + i]
        length = model.x[e + 1] - model.x[e]
        elongation, _, _, _, turn1, turn2 = chord(length, q)
        for g in range(2):
            eps0, kappa = strains(length, elongation, turn1, turn2, GAUSS[g])
            past = state.concrete[e, g]
            fibres(eps0, kappa, model.layer_y, past, model.concrete, stress[e, g], modulus[e, g])


@kernel
def free_at_faces(model, past):
    """Strain of creep and shrinkage at the top and at the bottom fibre of a section: on the line through the
    two layers next to it."""
    y, free, last = model.layer_y, past[FREE], model.layer_y.size - 1
    if last == 0:
        return free[0], free[0]
    top = free[0] + (free[0] - free[1]) * (model.top - y[0]) / (y[0] - y[1])
    bottom = free[last] + (free[last] - free[last - 1]) * (model.bottom - y[last]) / (y[last] - y[last - 1])
    return top, bottom
