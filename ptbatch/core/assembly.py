"""Internal forces and tangent of the whole member from its elements."""

import numpy as np

from ptbatch.core.anchorage import anchor, end_forces, end_friction, end_position
from ptbatch.core.banded import half_width
from ptbatch.core.beam import beam_forces, beam_strains, beam_tangent
from ptbatch.core.contact import (
    EXPECTED_BACKWARD,
    EXPECTED_FORWARD,
    GROUTED,
    HELD,
    UNKNOWN,
    contact_forces,
    segment,
)
from ptbatch.core.contact_tangent import COLUMNS, LEFT, MASTER1, MASTER2, RIGHT, SLAVE, contact_tangent
from ptbatch.core.jit import STEP, inlined, kernel
from ptbatch.core.model import ANCHORED, beam_dof, tendon_dof
from ptbatch.core.placement import duct_at, gather_contact, gather_end, stretch_tendon
from ptbatch.core.section import section_tangent
from ptbatch.core.truss import truss_tangent


@kernel
def end_slip(side, mode, model, u, work):
    """How far tendon has slid outward at an anchor: the gap of a live end, half the neighbour's movement at
    an anchored one."""
    n = model.x.size - 1
    if mode == ANCHORED:
        return -0.5 * work.s[1] if side == 0 else 0.5 * work.s[n]
    return u[0] if side == 0 else u[tendon_dof(n + 1)]


@kernel
def pulls_out(side, work):
    """Whether an end of the tendon is expected to slide out in this iteration."""
    if side == 0:
        return work.motion[0] == EXPECTED_BACKWARD
    return work.motion[work.motion.size - 1] == EXPECTED_FORWARD


@kernel
def add_ends(model, state, u, ends, work):
    """Forces of the two end elements (jack, wedge or anchorage with the tendon element next to it)."""
    n = model.x.size - 1
    for side in range(2):
        gather_end(side, model, u, work)
        e = side * n
        j = side * (n + 1)
        half_tan = end_forces(
            work.q6,
            ends.mode[side],
            ends.value[side],
            ends.born[side],
            work.T[e],
            0.0,
            work.length[e],
            state.s[j],
            state.rub[j],
            work.rough[j],
            pulls_out(side, work),
            anchor(side, model),
            model.contact,
            work.f6,
        )
        work.half_tan[side] = half_tan
        slip = end_slip(side, ends.mode[side], model, u, work)
        work.shear[j] = end_friction(
            work.T[e],
            half_tan,
            slip - state.s[j],
            state.rub[j],
            work.rough[j],
            pulls_out(side, work),
            model.contact,
        )
        gap = tendon_dof(j)
        node = beam_dof(side * n)
        neighbour = tendon_dof(1 + side * (n - 1))
        work.f[gap] += work.f6[0]
        for i in range(3):
            work.f[node + i] += work.f6[1 + i]
        for i in range(2):
            work.f[neighbour + i] += work.f6[4 + i]


@inlined
def duct_force(j, held, model, state, u, work):
    """work.f8 of the contact element of tendon node j on its present segment, by the laws as they stand; also
    returned: (N, T_t, s). held: as grout would hold it."""
    gather_contact(j, model, u, work)
    seg = segment(work.segment[j], model)
    px, py = duct_at(j, seg, work)
    N, Tt, s, _ = contact_forces(
        work.q8,
        px,
        py,
        work.xi[j],
        (work.chord[j - 1, 0], work.chord[j - 1, 1]),
        (work.chord[j, 0], work.chord[j, 1]),
        work.T[j - 1],
        work.T[j],
        state.s[j],
        state.rub[j],
        work.rough[j],
        GROUTED if held else UNKNOWN,
        seg,
        model.contact,
        work.f8,
    )
    return N, Tt, s


@kernel
def internal_forces(model, state, u, ends, bonded, work):
    """work.f at u, for which `find_segments` or `stay_on_segments` has placed the tendon: without a
    tangent, but with all that this needs of the beam and the tendon's elements."""
    n = model.x.size - 1
    stretch_tendon(model, state, work)
    bend_beam(model, state, u, 0.0, work)
    work.f[:] = 0.0
    for e in range(n):
        beam_forces(e, work, work.f6)
        for i in range(3):
            work.left_end[e, i] = work.f6[i]
        for i in range(6):
            work.f[(beam_dof(e) if i < 3 else beam_dof(e + 1) - 3) + i] += work.f6[i]
    for e in range(1, n):
        a = tendon_dof(e)
        b = tendon_dof(e + 1)
        for i in range(2):
            work.f[a + i] -= work.T[e] * work.chord[e, i]
            work.f[b + i] += work.T[e] * work.chord[e, i]
    for j in range(1, n + 1):
        held = bonded or work.motion[j] == GROUTED
        work.normal[j], work.shear[j], work.s[j] = duct_force(j, held, model, state, u, work)
        for i in range(8):
            work.duct[j, i] = work.f8[i]
        add_contact_forces(j, work)
    add_ends(model, state, u, ends, work)


@kernel
def add_contact_forces(j, work):
    a = tendon_dof(j)
    m1 = beam_dof(work.segment[j])
    m2 = beam_dof(work.segment[j] + 1)
    work.f[a] += work.f8[0]
    work.f[a + 1] += work.f8[1]
    for i in range(3):
        work.f[m1 + i] += work.f8[2 + i]
        work.f[m2 + i] += work.f8[5 + i]


@kernel
def add_to(matrix, row, column, value):
    matrix[np.uint64(row), np.uint64(column - row + half_width(matrix))] += value


@kernel
def add_block(matrix, row, column, k, i, j):
    """Add the three by three of an element's tangent k that start at (i, j) to the matrix from (row, column)
    on."""
    half, three = half_width(matrix), np.uint64(3)
    for r in range(three):
        at = np.uint64(column - row + half) - r
        to, of = np.uint64(row) + r, np.uint64(i) + r
        for c in range(three):
            matrix[to, at + c] += k[of, np.uint64(j) + c]


@kernel
def bend_beam(model, state, u, damping, work):
    """Strains, forces and moduli of all sections at u; see `section_tangent`."""
    beam_strains(model, u, work)
    section_tangent(model, state, damping, work)


@kernel
def tangent(model, state, u, ends, bonded, work):
    """work.f and work.matrix at u, for which `place_tendon` has placed the tendon and `bend_beam` bent the
    beam."""
    n = model.x.size - 1
    work.f[:] = 0.0
    work.matrix[:] = 0.0
    for e in range(n):
        add_beam(e, model, work)
    for e in range(1, n):
        add_truss(e, work)
    work.held_back[0] = 0
    if bonded:
        work.motion[:] = GROUTED
    for j in range(1, n + 1):
        add_contact(j, model, state, u, bonded, work)
    for side in range(2):
        add_end_tangent(side, model, state, u, ends, work)
    add_ends(model, state, u, ends, work)
    work.motion[0] = UNKNOWN  # what was expected has been taken as given, once
    work.motion[n + 1] = UNKNOWN


@inlined
def add_beam(e, model, work):
    beam_tangent(e, model, work, work.f6, work.k6)
    for i in range(6):
        work.f[(beam_dof(e) if i < 3 else beam_dof(e + 1) - 3) + i] += work.f6[i]
    for i in range(2):
        for j in range(2):
            add_block(work.matrix, beam_dof(e + i), beam_dof(e + j), work.k6, 3 * i, 3 * j)


@inlined
def add_truss(e, work):
    a = tendon_dof(e)
    b = tendon_dof(e + 1)
    ex = work.chord[e, 0]
    ey = work.chord[e, 1]
    truss_tangent(work.T[e], work.slope[e], ex, ey, work.length[e], work.k2)
    for i in range(2):
        work.f[a + i] -= work.T[e] * work.chord[e, i]
        work.f[b + i] += work.T[e] * work.chord[e, i]
        for j in range(2):
            k = work.k2[i, j]
            add_to(work.matrix, a + i, a + j, k)
            add_to(work.matrix, a + i, b + j, -k)
            add_to(work.matrix, b + i, a + j, -k)
            add_to(work.matrix, b + i, b + j, k)


@kernel
def add_contact(j, model, state, u, bonded, work):
    """Force and tangent of one contact element."""
    gather_contact(j, model, u, work)
    seg = segment(work.segment[j], model)
    px, py = duct_at(j, seg, work)
    N, Tt, s, motion, spread = contact_tangent(
        work.q8,
        px,
        py,
        work.xi[j],
        (work.chord[j - 1, 0], work.chord[j - 1, 1]),
        (work.chord[j, 0], work.chord[j, 1]),
        (work.length[j - 1], work.length[j]),
        (work.T[j - 1], work.T[j]),
        (work.slope[j - 1], work.slope[j]),
        state.s[j],
        state.rub[j],
        work.rough[j],
        work.motion[j],
        seg,
        model.contact,
        work.d7,
        work.f8,
        work.columns,
    )
    work.normal[j] = N
    work.shear[j] = Tt
    work.s[j] = s
    work.motion[j] = motion
    if motion == HELD:
        work.held_back[0] += 1
    add_contact_forces(j, work)
    rows = tendon_dof(j), beam_dof(work.segment[j]), beam_dof(work.segment[j] + 1)
    add_columns(SLAVE, tendon_dof(j), 2, rows, spread, work)
    add_columns(MASTER1, rows[1], 3, rows, spread, work)
    add_columns(MASTER2, rows[2], 3, rows, spread, work)
    add_to(work.matrix, rows[1] + 2, rows[1] + 2, spread.couple[0])
    add_to(work.matrix, rows[2] + 2, rows[2] + 2, spread.couple[1])
    n = model.x.size - 1
    if j == 1:
        add_end_columns(0, LEFT, rows, spread, model, u, work)
    else:
        add_columns(LEFT, tendon_dof(j - 1), 2, rows, spread, work)
    if j == n:
        add_end_columns(1, RIGHT, rows, spread, model, u, work)
    else:
        add_columns(RIGHT, tendon_dof(j + 1), 2, rows, spread, work)


@inlined
def add_columns(first, column, count, rows, spread, work):
    """Add so many columns of a contact element, from its `first` on, to the matrix from `column` on; rows:
    where slave and masters are in it."""
    matrix, by = work.matrix, work.columns
    one, two = np.uint64(1), np.uint64(2)
    slave, master1, master2 = np.uint64(rows[0]), np.uint64(rows[1]), np.uint64(rows[2])
    weight1, weight2 = spread.weight
    place1, place2 = spread.place
    lever1, lever2 = spread.lever
    for i in range(count):
        c, at = first + i, np.uint64(column + i + half_width(matrix))
        fx, fy, xi, moment = by[c], by[COLUMNS + c], by[2 * COLUMNS + c], by[3 * COLUMNS + c]
        matrix[slave, at - slave] += fx
        matrix[slave + one, at - slave - one] += fy
        matrix[master1, at - master1] += weight1 * fx + place1[0] * xi
        matrix[master1 + one, at - master1 - one] += weight1 * fy + place1[1] * xi
        couple1 = lever1[0] * fx + lever1[1] * fy + lever1[2] * xi + lever1[3] * moment
        matrix[master1 + two, at - master1 - two] += couple1
        matrix[master2, at - master2] += weight2 * fx + place2[0] * xi
        matrix[master2 + one, at - master2 - one] += weight2 * fy + place2[1] * xi
        couple2 = lever2[0] * fx + lever2[1] * fy + lever2[2] * xi + lever2[3] * moment
        matrix[master2 + two, at - master2 - two] += couple2


@kernel
def add_end_columns(side, first, rows, spread, model, u, work):
    """Add the two columns of a neighbour that is an end node of the tendon, which its gap and its beam node
    carry."""
    n = model.x.size - 1
    by = work.columns
    gather_end(side, model, u, work)
    x, y, ox, oy = end_position(work.q6, anchor(side, model))
    dx, dy = x - work.q6[1], y - work.q6[2]
    node = beam_dof(side * n)
    add_columns(first, node, 2, rows, spread, work)
    along_x, along_y = (by[first], by[first + 1]), (by[COLUMNS + first], by[COLUMNS + first + 1])
    by[first] = along_x[0] * ox + along_x[1] * oy
    by[COLUMNS + first] = along_y[0] * ox + along_y[1] * oy
    add_columns(first, tendon_dof(side * (n + 1)), 1, rows, spread, work)
    by[first] = along_x[1] * dx - along_x[0] * dy
    by[COLUMNS + first] = along_y[1] * dx - along_y[0] * dy
    add_columns(first, node + 2, 1, rows, spread, work)


@kernel
def add_end_tangent(side, model, state, u, ends, work):
    """Tangent of an end element by complex steps of the gap, the rotation and the neighbour; where the beam
    node goes is the opposite of where the neighbour goes."""
    n = model.x.size - 1
    e = side * n
    j = side * (n + 1)
    gather_end(side, model, u, work)
    z = work.z6
    for i in range(6):
        z[i] = work.q6[i]
    a = anchor(side, model)
    gap = tendon_dof(j)
    node = beam_dof(side * n)
    neighbour = tendon_dof(1 + side * (n - 1))
    for column in (0, 3, 4, 5):
        z[column] = complex(work.q6[column], STEP)
        end_forces(
            z,
            ends.mode[side],
            ends.value[side],
            ends.born[side],
            work.T[e],
            work.slope[e],
            work.length[e],
            state.s[j],
            state.rub[j],
            work.rough[j],
            pulls_out(side, work),
            a,
            model.contact,
            work.w6,
        )
        z[column] = work.q6[column]
        at = gap if column == 0 else (node + 2 if column == 3 else neighbour + column - 4)
        for i in range(6):
            row = gap if i == 0 else (node + i - 1 if i < 4 else neighbour + i - 4)
            slope = work.w6[i].imag / STEP
            add_to(work.matrix, row, at, slope)
            if column > 3:
                add_to(work.matrix, row, node + column - 4, -slope)
