"""Fibre-section Euler-Bernoulli beam element, co-rotational: cubic deflection and constant axial strain about
its own chord.

Two Gauss sections an element; at these points the bending moment under uniform load is exact. Sagging
curvature and moment are positive, the layer at height y strains by eps0 - y kappa.
"""

import numpy as np

from ptbatch.core.concrete import commit_concrete, concrete_stress
from ptbatch.core.jit import STEP, kernel
from ptbatch.core.steel import commit_steel, steel_stress

GAUSS = 0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0)


@kernel
def fibre(past, i):
    """History of one fibre, out of its array: a view of it would cost more than the law."""
    return past[i, 0], past[i, 1], past[i, 2], past[i, 3], past[i, 4]


@kernel
def section_forces(eps0, kappa, model, past, plastic, bar_area):
    """(N, M) of one section."""
    N = 0.0
    M = 0.0
    for i in range(model.layer_y.size):
        y = model.layer_y[i]
        force = model.layer_area[i] * concrete_stress(eps0 - y * kappa, fibre(past, i), model.concrete)
        N += force
        M -= y * force
    for i in range(model.bar_y.size):
        if bar_area[i] > 0.0 and not np.isnan(plastic[i]):
            y = model.bar_y[i]
            force = bar_area[i] * steel_stress(eps0 - y * kappa, plastic[i], model.bar_fy[i], model.steel)
            N += force
            M -= y * force
    return N, M


@kernel
def section_tangent(eps0, kappa, model, past, plastic, bar_area, damping):
    """(N, M, dN/deps0, dN/dkappa = dM/deps0, dM/dkappa): one complex evaluation a fibre gives stress and
    modulus.

    damping: added to the modulus of each concrete fibre, as a share of the uncracked one.
    """
    N = 0.0
    M = 0.0
    EA = 0.0
    ES = 0.0
    EI = 0.0
    for i in range(model.layer_y.size):
        y = model.layer_y[i]
        stress = concrete_stress(complex(eps0 - y * kappa, STEP), fibre(past, i), model.concrete)
        force = model.layer_area[i] * stress.real
        stiffness = model.layer_area[i] * (stress.imag / STEP + damping * model.concrete.E0)
        N += force
        M -= y * force
        EA += stiffness
        ES -= y * stiffness
        EI += y * y * stiffness
    for i in range(model.bar_y.size):
        if bar_area[i] > 0.0 and not np.isnan(plastic[i]):
            y = model.bar_y[i]
            stress = steel_stress(complex(eps0 - y * kappa, STEP), plastic[i], model.bar_fy[i], model.steel)
            force = bar_area[i] * stress.real
            stiffness = bar_area[i] * (stress.imag / STEP)
            N += force
            M -= y * force
            EA += stiffness
            ES -= y * stiffness
            EI += y * y * stiffness
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
def beam_forces(e, model, state, d, f):
    """Nodal forces f (6,) of element e at the displacements d (6,)."""
    length = model.x[e + 1] - model.x[e]
    elongation, c, s, now, turn1, turn2 = chord(length, d)
    N = 0.0
    M1 = 0.0
    M2 = 0.0
    for g in range(2):
        xi = GAUSS[g]
        eps0, kappa = strains(length, elongation, turn1, turn2, xi)
        Ng, Mg = section_forces(eps0, kappa, model, state.concrete[e, g], state.bar[e, g], model.bar_area[e])
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
def beam_tangent(e, model, state, d, damping, f, k):
    """Nodal forces f (6,) and tangent k (6, 6): material part by the complex step in the fibres, geometric
    part of the chord."""
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
            eps0, kappa, model, state.concrete[e, g], state.bar[e, g], model.bar_area[e], damping
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
    r = (-c, -s, 0.0, c, s, 0.0)  # d elongation
    z = (s, -c, 0.0, -s, c, 0.0)  # now * d turn, negative of the chord's rotation
    for i in range(6):
        t1 = -z[i] / now + (1.0 if i == 2 else 0.0)
        t2 = -z[i] / now + (1.0 if i == 5 else 0.0)
        a0 = k00 * r[i] + k01 * t1 + k02 * t2
        a1 = k01 * r[i] + k11 * t1 + k12 * t2
        a2 = k02 * r[i] + k12 * t1 + k22 * t2
        for j in range(6):
            u1 = -z[j] / now + (1.0 if j == 2 else 0.0)
            u2 = -z[j] / now + (1.0 if j == 5 else 0.0)
            k[i, j] = (
                a0 * r[j]
                + a1 * u1
                + a2 * u2
                + N / now * z[i] * z[j]
                + shear / now * (r[i] * z[j] + z[i] * r[j])
            )


@kernel
def commit_beam(e, model, state, d):
    """Take the fibres' history to the displacements d (6,)."""
    length = model.x[e + 1] - model.x[e]
    elongation, _, _, _, turn1, turn2 = chord(length, d)
    for g in range(2):
        eps0, kappa = strains(length, elongation, turn1, turn2, GAUSS[g])
        past = state.concrete[e, g]
        for i in range(model.layer_y.size):
            eps = eps0 - model.layer_y[i] * kappa
            if eps + past[i, 4] > past[i, 0] or -eps > past[i, 2]:
                commit_concrete(eps, past[i], model.concrete)
        for i in range(model.bar_y.size):
            eps = eps0 - model.bar_y[i] * kappa
            state.bar[e, g, i] = commit_steel(eps, state.bar[e, g, i], model.bar_fy[i], model.steel)
