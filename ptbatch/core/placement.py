"""Where the tendon lies on the deformed member: its nodes, the duct segments that they are on, how far they
have come along the duct, what stretches the elements between them.

What the kernels of an iteration need of that is in `work`, see there.
"""

from ptbatch.core.anchorage import anchor, end_position
from ptbatch.core.banded import half_width
from ptbatch.core.contact import UNKNOWN, masters, pace, project, segment
from ptbatch.core.jit import cos_sin, kernel
from ptbatch.core.model import beam_dof, tendon_dof
from ptbatch.core.slide import slide, turns_round
from ptbatch.core.truss import stretch, tensions, unit
from ptbatch.core.turning import roughness


@kernel
def gather_end(side, model, u, work):
    """q6 of a tendon end and its neighbour's number."""
    n = model.x.size - 1
    node, neighbour, gap = (0, 1, 0) if side == 0 else (n, n, tendon_dof(n + 1))
    q = work.q6
    q[0] = u[gap]
    for i in range(3):
        q[1 + i] = u[beam_dof(node) + i]
    at = tendon_dof(neighbour)
    q[4] = model.tendon_x[neighbour, 0] - model.x[node] + u[at]
    q[5] = model.tendon_x[neighbour, 1] + u[at + 1]


@kernel
def place_nodes(model, u, work):
    """Displacements of all tendon nodes from `tendon_x`, and how the beam nodes have turned."""
    n = model.x.size - 1
    for k in range(n + 1):
        work.turn[k, 0], work.turn[k, 1] = cos_sin(u[beam_dof(k) + 2])
    for j in range(1, n + 1):
        work.place[j, 0] = u[tendon_dof(j)]
        work.place[j, 1] = u[tendon_dof(j) + 1]
    for side in range(2):
        gather_end(side, model, u, work)
        a = anchor(side, model)
        x, y, _, _ = end_position(work.q6, a)
        j = side * (n + 1)
        work.place[j, 0] = x
        work.place[j, 1] = y - a.y


@kernel
def gather_contact(j, model, u, work):
    """q8 of the contact element of tendon node j on its present segment."""
    m = work.segment[j]
    q = work.q8
    x = model.x[m]
    q[0] = model.tendon_x[j, 0] - x + work.place[j, 0]
    q[1] = model.tendon_x[j, 1] + work.place[j, 1]
    for i in range(6):
        q[2 + i] = u[beam_dof(m) + i] if i < 3 else u[beam_dof(m + 1) + i - 3]


@kernel
def duct_at(j, seg, work):
    """The duct of the segment that tendon node j is on, see `masters`."""
    m = work.segment[j]
    turn1, turn2 = (work.turn[m, 0], work.turn[m, 1]), (work.turn[m + 1, 0], work.turn[m + 1, 1])
    return masters(work.q8, turn1, turn2, seg)


@kernel
def find_segments(model, u, work):
    """Contact search: give each inner tendon node the segment that its projection lies in, and its arc
    length.

    A node stays within the segments that the band of the matrix has room for; beyond the last of them its
    segment is prolonged.
    """
    n = model.x.size - 1
    reach = (half_width(work.matrix) - 9) // 5
    place_nodes(model, u, work)
    for j in range(1, n + 1):
        for _ in range(n):
            m = work.segment[j]
            gather_contact(j, model, u, work)
            seg = segment(m, model)
            px, py = duct_at(j, seg, work)
            xi = project(work.q8, px, py, work.xi[j], seg)
            if xi > 1.0 and m < min(n - 1, j - 1 + reach):
                work.segment[j] = m + 1
                work.xi[j] = (xi - 1.0) * seg.h / (model.x[m + 2] - model.x[m + 1])
            elif xi < 0.0 and m > max(0, j - 1 - reach):
                work.segment[j] = m - 1
                work.xi[j] = 1.0 + xi * seg.h / (model.x[m] - model.x[m - 1])
            else:
                work.xi[j] = xi
                work.s[j] = seg.s + xi * seg.ds
                break
        work.hats[j] = work.s[j]
    work.s[0] = model.duct_s[0] - u[0]
    work.s[n + 1] = model.duct_s[n] + u[tendon_dof(n + 1)]
    work.hats[0] = model.duct_s[0]
    work.hats[n + 1] = model.duct_s[n]
    roughness(work.hats, model, work.rough)


@kernel
def stay_on_segments(model, u, work):
    """Project each inner tendon node on the duct segment found by the last search."""
    place_nodes(model, u, work)
    for j in range(1, model.x.size):
        gather_contact(j, model, u, work)
        seg = segment(work.segment[j], model)
        px, py = duct_at(j, seg, work)
        work.xi[j] = project(work.q8, px, py, work.xi[j], seg)


@kernel
def stretch_tendon(model, state, work):
    """Tension, its slope dT/dlength, length and direction of all tendon elements."""
    for e in range(model.rest_length.size):
        x = model.tendon_x[e + 1, 0] - model.tendon_x[e, 0] + (work.place[e + 1, 0] - work.place[e, 0])
        y = model.tendon_x[e + 1, 1] - model.tendon_x[e, 1] + (work.place[e + 1, 1] - work.place[e, 1])
        work.length[e], work.chord[e, 0], work.chord[e, 1] = unit(x, y)
        work.stretch[e] = stretch(model.rest_length[e], work.length[e])
    tensions(work.stretch, state.tendon, model.rest_length, model.strand, work.T, work.slope)


@kernel
def place_tendon(model, state, u, work):
    """Contact search and tensions at u."""
    find_segments(model, u, work)
    stretch_tendon(model, state, work)


@kernel
def find_paces(model, u, work):
    """work.pace of the inner tendon nodes, as placed, along work.axis: the beam, and the duct with it, is not
    as long as at rest."""
    for j in range(1, model.x.size):
        gather_contact(j, model, u, work)
        seg = segment(work.segment[j], model)
        px, py = duct_at(j, seg, work)
        axis = work.axis[j, 0], work.axis[j, 1]
        work.pace[j] = pace(work.q8, px, py, work.xi[j], axis, seg)


@kernel
def slide_tendon(model, state, u, work):
    """Move the tendon, as placed, along the duct to where friction balances it: its nodes in u, and what
    `place_tendon` found. Both its ends stand still."""
    if not turns_round(model, state, work):
        return
    find_paces(model, u, work)
    if slide(model, state, work):
        for j in range(1, model.x.size):
            for i in range(2):
                u[tendon_dof(j) + i] += work.ahead[j] * work.axis[j, i]
        work.motion[:] = UNKNOWN
        place_tendon(model, state, u, work)
