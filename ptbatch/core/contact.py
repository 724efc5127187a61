"""Modified node-to-segment contact, eqs (1)-(23): a tendon node slides with Coulomb friction along its duct
segment.

The segment is tied to the beam nodes at its ends (masters); it is either the straight line between the two
duct nodes (the paper's) or the cubic with the duct's own directions there, which is the profile itself.
Degrees of freedom, those of the paper: slave (x, y), master 1 and 2 (u, v, theta), these q (8,), and tendon
neighbours (x, y), which the chords stand for; positions relative to the first beam node.

Three things go beyond the paper. The force is turned as a whole: N along the bisector n' of the tendon (the
paper's P_n n + P_cor t is the same vector), friction across it, so that one kink gives T2/T1 = (1 - mu
tan(theta/2)) / (1 + mu tan(theta/2)) exactly. Wobble and the turning that a node does not feel (opposite
curvatures that cancel in its kink) add friction `rough` times the mean tendon force. The moment of the
friction force about the sheathing is passed on to the masters.
"""

from typing import NamedTuple

from ptbatch.core.embedding import arm, turned
from ptbatch.core.jit import inlined, inverse, inverse_root, kernel

ALMOST = 1.0 - 1e-9  # a node that has been sliding goes on sliding: round-off does not decide
# Motion of a tendon node along its duct in an iteration
BACKWARD, STICKING, FORWARD, HELD, GROUTED, UNKNOWN, EXPECTED_FORWARD, EXPECTED_BACKWARD = range(8)
ARRIVED = 1e-8  # share of a segment; Newton's next step would be the square of the last one


class Segment(NamedTuple):
    """One duct segment at rest: length h along the axis, heights and slopes at its ends, arc length at its
    start and over it."""

    h: float
    y1: float
    y2: float
    slope1: float
    slope2: float
    s: float
    ds: float
    smooth: bool


@kernel
def segment(m, model):
    return Segment(
        model.x[m + 1] - model.x[m],
        model.duct_y[m],
        model.duct_y[m + 1],
        model.duct_slope[m, 0],
        model.duct_slope[m, 1],
        model.duct_s[m],
        model.duct_s[m + 1] - model.duct_s[m],
        model.contact.smooth,
    )


@kernel
def shape(xi, smooth):
    """Weights of (point 1, direction 1, point 2, direction 2), and of their first and second derivatives by
    xi."""
    if not smooth:
        zero = 0.0 * xi
        return (1.0 - xi, zero, xi, zero), (zero - 1.0, zero, zero + 1.0, zero), (zero, zero, zero, zero)
    x2 = xi * xi
    x3 = x2 * xi
    return (
        (1.0 - 3.0 * x2 + 2.0 * x3, xi - 2.0 * x2 + x3, 3.0 * x2 - 2.0 * x3, x3 - x2),
        (6.0 * x2 - 6.0 * xi, 1.0 - 4.0 * xi + 3.0 * x2, 6.0 * xi - 6.0 * x2, 3.0 * x2 - 2.0 * xi),
        (12.0 * xi - 6.0, 6.0 * xi - 4.0, 6.0 - 12.0 * xi, 6.0 * xi - 2.0),
    )


@kernel
def masters(q, turn1, turn2, seg):
    """Duct (point 1, direction 1, point 2, direction 2) as x and y tuples, from the master dofs q[2:8];
    turn1, turn2: cosine and sine of the angles among these, q[4] and q[7]."""
    ax1, ay1 = arm(seg.y1, turn1)
    ax2, ay2 = arm(seg.y2, turn2)
    dx1, dy1 = turned(seg.h, seg.h * seg.slope1, turn1)
    dx2, dy2 = turned(seg.h, seg.h * seg.slope2, turn2)
    return (q[2] + ax1, dx1, seg.h + q[5] + ax2, dx2), (q[3] + ay1, dy1, q[6] + ay2, dy2)


@kernel
def dot4(w, p):
    return w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3] * p[3]


@kernel
def foot(q, px, py, xi, seg):
    """The slave over a point xi of the duct: its distance (x, y), the duct's derivative there (x, y), and how
    much of that changes eq. (2) as xi does. px, py: see `masters`."""
    w, w1, w2 = shape(xi, seg.smooth)
    rx = q[0] - dot4(w, px)
    ry = q[1] - dot4(w, py)
    tx = dot4(w1, px)
    ty = dot4(w1, py)
    bend = rx * dot4(w2, px) + ry * dot4(w2, py)
    return (rx, ry), (tx, ty), tx * tx + ty * ty - bend


@kernel
def projection_step(q, px, py, xi, seg):
    """One Newton step of eq. (2): the root of (x_s - p(xi)) . p'(xi). px, py: see `masters`."""
    r, t, change = foot(q, px, py, xi, seg)
    return xi + (r[0] * t[0] + r[1] * t[1]) / change


@kernel
def pace(q, px, py, xi, u, seg):
    """Arc length along the duct at rest by which the slave's projection moves on as the slave moves by one in
    the direction u; q, px, py, xi: as of `project`, which has found xi."""
    _, t, change = foot(q, px, py, xi, seg)
    return seg.ds * (u[0] * t[0] + u[1] * t[1]) / change


@kernel
def project(q, px, py, xi, seg):
    """xi of the slave's projection, from a first guess; it may lie outside 0..1, which the contact search
    then mends. px, py: see `masters`."""
    for _ in range(20):
        new = projection_step(q, px, py, xi, seg)
        if abs(new - xi) < ARRIVED:
            return new
        xi = new
    return xi


@kernel
def friction(slip, rub, N, T, rough, was, c):
    """Coulomb's return mapping, eq. (23): (friction force, motion) after a slip that starts with the friction
    force `rub`.

    was: the node's motion in the iteration before. One that slid and is now pushed the other way is held
    first, whatever force that takes: Newton's method then finds its place of rest in one step, where jumping
    from +capacity to -capacity and back would go on for ever. A motion that is only expected is taken as
    given, once.
    """
    trial = rub + c.tangential * slip
    if was == GROUTED:
        return trial, GROUTED
    capacity = c.mu * N + rough * T
    if was == EXPECTED_FORWARD:
        return capacity, FORWARD
    if was == EXPECTED_BACKWARD:
        return -capacity, BACKWARD
    if capacity.real < 0.0:
        capacity = 0.0 * capacity
    limit = ALMOST * capacity.real
    if trial.real >= limit:
        return (trial, HELD) if was == BACKWARD else (capacity, FORWARD)
    if trial.real <= -limit:
        return (trial, HELD) if was == FORWARD else (-capacity, BACKWARD)
    return trial, STICKING


@kernel
def bisector(e3, e4):
    """Unit vector t' across n' of eqs (16)-(17), between those of the two chords that meet at a tendon
    node."""
    x, y = e3[0] + e4[0], e3[1] + e4[1]
    scale = inverse_root(x * x + y * y)
    return x * scale, y * scale


@inlined
def node_force(e3, e4, u, gap, t, slip, T3, T4, rub, rough, was, c):
    """Force of the tendon node on its duct: (fx, fy, N, T_t, motion).

    e3, e4: unit vectors of the chords left and right; u: see `bisector`. t: unit tangent of the duct; gap:
    across it, eq. (1). slip: along it since the last step. T3, T4: tensions left and right.
    """
    P = c.normal * gap  # eq. (22), both signs: the duct holds the tendon on both sides
    if c.corrected:  # along the bisector: eqs (18)-(20) without their singular cases
        ux, uy = u[0] + 0.0 * gap, u[1] + 0.0 * gap
        N = P * inverse(ux * t[0] + uy * t[1])
    else:
        ux, uy = t[0] + 0.0 * u[0], t[1] + 0.0 * u[0]
        N = P + 0.0 * ux
    # In equilibrium this is N. On the way there the penalty makes N jump with the square of what is missing,
    # and its sign with it; what the tendon's own kink presses does not.
    into3 = e3[0] * uy - e3[1] * ux
    into4 = e4[1] * ux - e4[0] * uy
    press = T3 * into3 + T4 * into4
    # by the kink, so that a slack tendon knows as well which way it is going to press
    press = press if (into3 + into4).real >= 0.0 else -press
    Tt, motion = friction(slip + 0.0 * ux, rub, press, 0.5 * (T3 + T4), rough, was, c)
    return Tt * ux - N * uy, Tt * uy + N * ux, N, Tt, motion


@inlined
def contact_forces(q, px, py, xi, e3, e4, T3, T4, s0, rub, rough, was, seg, c, f):
    """Forces f (8,) on slave and masters; also returned: (N, T_t, s, motion).

    q (8,); px, py: see `masters`. xi: the converged projection. e3, e4, T3, T4: unit vectors and tensions of
    the tendon elements left and right.
    """
    w, w1, _ = shape(xi, seg.smooth)
    rx = q[0] - dot4(w, px)
    ry = q[1] - dot4(w, py)
    tx = dot4(w1, px)
    ty = dot4(w1, py)
    scale = inverse_root(tx * tx + ty * ty)
    tx = tx * scale
    ty = ty * scale
    s = seg.s + xi * seg.ds
    gap = ry * tx - rx * ty
    u = bisector(e3, e4)
    fx, fy, N, Tt, motion = node_force(e3, e4, u, gap, (tx, ty), s - s0, T3, T4, rub, rough, was, c)
    couple = rx * fy - ry * fx
    ax1 = px[0] - q[2]
    ay1 = py[0] - q[3]
    ax2 = px[2] - seg.h - q[5]
    ay2 = py[2] - q[6]
    lever1 = w[0] * ax1 + w[1] * px[1], w[0] * ay1 + w[1] * py[1]
    lever2 = w[2] * ax2 + w[3] * px[3], w[2] * ay2 + w[3] * py[3]
    share_out(fx, fy, couple, xi, w, lever1, lever2, f)
    return N, Tt, s, motion


@inlined
def share_out(fx, fy, couple, xi, w, lever1, lever2, f):
    """f (8,) of the force on the slave and its couple about the duct: what the masters bear of them, by
    weights w and levers (x, y)."""
    f[0] = fx
    f[1] = fy
    f[2] = -fx * w[0]
    f[3] = -fy * w[0]
    f[4] = -(fy * lever1[0] - fx * lever1[1] + (1.0 - xi) * couple)
    f[5] = -fx * w[2]
    f[6] = -fy * w[2]
    f[7] = -(fy * lever2[0] - fx * lever2[1] + xi * couple)
