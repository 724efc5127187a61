"""Tangent of one contact element: complex steps in the law of friction, and kinematics.

The force on the duct depends on seven quantities: the tendon's two chords (x, y each), the gap, the direction
of the duct and the slip. How it follows the turns and lengths of the chords is geometry. How gap, direction
and slip follow the twelve degrees of freedom is kinematics, eqs (4) and (5), carried to the curved duct: with
e the movement of the slave against the duct point under it, p' and p'' the derivatives of the duct by xi and
r the gap as a vector,

    d gap = e . n,   d xi (p' . p' - r . p'') = e . p' + r . dp',   d direction = n . (dp' + p'' d xi) / |p'|.
"""

from typing import NamedTuple

import numpy as np

from ptbatch.core.contact import bisector, dot4, friction, shape, share_out
from ptbatch.core.jit import STEP, inlined, kernel

COLUMNS = 12  # of a contact element, and the first of each node
SLAVE, MASTER1, MASTER2, LEFT, RIGHT = 0, 2, 5, 8, 10


class Spread(NamedTuple):
    """How the eight forces of a contact element change with what `contact_tangent` finds of each column: the
    two on a master by (fx, fy) `weight` and by xi `place`, the couple on it by fx, fy, xi and moment `lever`;
    `couple`: by its own rotation besides."""

    weight: tuple  # of master 1, of master 2
    place: tuple  # (u, v) of 1, (u, v) of 2
    lever: tuple  # (fx, fy, xi, moment) of 1, and of 2
    couple: tuple


@inlined
def friction_derivatives(slip, rub, press, T, rough, was, c):
    """(T_t, motion), and the derivatives of T_t by slip, press and T; arguments as of `friction`."""
    by_slip, motion = friction(complex(slip, STEP), rub, complex(press, 0.0), complex(T, 0.0), rough, was, c)
    by_press, _ = friction(complex(slip, 0.0), rub, complex(press, STEP), complex(T, 0.0), rough, was, c)
    by_mean, _ = friction(complex(slip, 0.0), rub, complex(press, 0.0), complex(T, STEP), rough, was, c)
    return by_slip.real, motion, by_slip.imag / STEP, by_press.imag / STEP, by_mean.imag / STEP


@inlined
def force_derivatives(e3, e4, length, gap, t, slip, T, slope, rub, rough, was, c, d):
    """(fx, fy, N, T_t, motion), and in d (7, 2) the derivatives of (fx, fy) by the two chords, gap,
    direction, slip.

    e3, e4, length, T, slope: directions of the chords, and left and right their lengths, tensions and the
    slopes of these by length. The force is T_t along u and N across it;
    u turns by the mean of the two chords' turns, or with the duct where it is not corrected.
    """
    u = bisector(e3, e4)
    half = 0.5 if c.corrected else 0.0
    P = c.normal * gap
    ux, uy = (u[0], u[1]) if c.corrected else (t[0], t[1])
    level = 1.0 / (ux * t[0] + uy * t[1])
    N = P * level
    into3, with3 = e3[0] * uy - e3[1] * ux, e3[0] * ux + e3[1] * uy
    into4, with4 = e4[1] * ux - e4[0] * uy, e4[0] * ux + e4[1] * uy
    sign = 1.0 if into3 + into4 >= 0.0 else -1.0
    press = sign * (T[0] * into3 + T[1] * into4)
    mean = 0.5 * (T[0] + T[1])
    Tt, motion, by_slip, by_press, by_mean = friction_derivatives(slip, rub, press, mean, rough, was, c)
    N_turn = N * level * (t[0] * uy - t[1] * ux)  # by u's turn, and less that by the duct's
    press3, press4 = -sign * T[0] * with3, sign * T[1] * with4  # by the chords' turns
    press_turn = -press3 - press4  # by u's turn
    turn3 = by_press * (press3 + half * press_turn) - half * N, half * (N_turn + Tt)
    turn4 = by_press * (press4 + half * press_turn) - half * N, half * (N_turn + Tt)
    grow3 = slope[0] * (by_press * sign * into3 + 0.5 * by_mean)
    grow4 = slope[1] * (by_press * sign * into4 + 0.5 * by_mean)
    duct = 1.0 - 2.0 * half
    write(0, e3, u_xy(turn3, ux, uy), (grow3 * ux, grow3 * uy), length[0], d)
    write(2, e4, u_xy(turn4, ux, uy), (grow4 * ux, grow4 * uy), length[1], d)
    d[4, 0], d[4, 1] = u_xy((0.0, c.normal * level), ux, uy)
    d[5, 0], d[5, 1] = u_xy((duct * (by_press * press_turn - N), duct * (N_turn + Tt) - N_turn), ux, uy)
    d[6, 0], d[6, 1] = u_xy((by_slip, 0.0), ux, uy)
    return Tt * ux - N * uy, Tt * uy + N * ux, N, Tt, motion


@kernel
def u_xy(f, ux, uy):
    """x and y of a vector that is given along u and across it."""
    return f[0] * ux - f[1] * uy, f[0] * uy + f[1] * ux


@kernel
def write(row, e, turn, grow, length, d):
    """Rows of d by the x and y of a chord with the direction e: how the force changes as it turns and as it
    grows."""
    across = 1.0 / length
    d[row, 0], d[row, 1] = grow[0] * e[0] - turn[0] * e[1] * across, grow[1] * e[0] - turn[1] * e[1] * across
    d[row + 1, 0] = grow[0] * e[1] + turn[0] * e[0] * across
    d[row + 1, 1] = grow[1] * e[1] + turn[1] * e[0] * across


@inlined
def contact_tangent(q, px, py, xi, e3, e4, length, T, slope, s0, rub, rough, was, seg, c, d, f, by):
    """Forces f (8,), and in by (4 COLUMNS,) how fx, fy, xi and the moment e x f change with each of the
    twelve degrees of freedom, of which `add_columns` makes the tangent; also returned: (N, T_t, s, motion)
    and the Spread. Arguments as of `contact_forces` and `force_derivatives`, all real; d (7, 2) is scratch.

    by is flat: of rows of a matrix the compiler would not know that they are apart, and take the columns one
    by one.
    """
    w, w1, w2 = shape(xi, seg.smooth)
    rx, ry = q[0] - dot4(w, px), q[1] - dot4(w, py)
    vx, vy = dot4(w1, px), dot4(w1, py)  # p'
    second = dot4(w2, px), dot4(w2, py)  # p''
    slowness = 1.0 / np.sqrt(vx * vx + vy * vy)
    tx, ty = vx * slowness, vy * slowness
    s = seg.s + xi * seg.ds
    gap = ry * tx - rx * ty
    fx, fy, N, Tt, motion = force_derivatives(
        e3, e4, length, gap, (tx, ty), s - s0, T, slope, rub, rough, was, c, d
    )
    # levers of the force about the two masters, arm and direction by their weights, and how these change
    # with xi
    ax1, ay1, ax2, ay2 = px[0] - q[2], py[0] - q[3], px[2] - seg.h - q[5], py[2] - q[6]
    x1, y1 = w[0] * ax1 + w[1] * px[1], w[0] * ay1 + w[1] * py[1]
    x2, y2 = w[2] * ax2 + w[3] * px[3], w[2] * ay2 + w[3] * py[3]
    x1_xi, y1_xi = w1[0] * ax1 + w1[1] * px[1], w1[0] * ay1 + w1[1] * py[1]
    x2_xi, y2_xi = w1[2] * ax2 + w1[3] * px[3], w1[2] * ay2 + w1[3] * py[3]
    move(SLAVE, (1.0, 0.0), (0.0, 0.0), by)
    move(SLAVE + 1, (0.0, 1.0), (0.0, 0.0), by)
    move(MASTER1, (-w[0], 0.0), (w1[0], 0.0), by)
    move(MASTER1 + 1, (0.0, -w[0]), (0.0, w1[0]), by)
    move(MASTER1 + 2, (y1, -x1), (-y1_xi, x1_xi), by)
    move(MASTER2, (-w[2], 0.0), (w1[2], 0.0), by)
    move(MASTER2 + 1, (0.0, -w[2]), (0.0, w1[2]), by)
    move(MASTER2 + 2, (y2, -x2), (-y2_xi, x2_xi), by)
    follow_moves((rx, ry), (vx, vy), second, slowness, seg.ds, (fx, fy), d, by)
    turn_chords(d, by)
    couple, turned = rx * fy - ry * fx, vx * fy - vy * fx
    share_out(fx, fy, couple, xi, w, (x1, y1), (x2, y2), f)
    place1 = fy * x1_xi - fx * y1_xi - (1.0 - xi) * turned - couple
    place2 = fy * x2_xi - fx * y2_xi - xi * turned + couple
    spread = Spread(
        (-w[0], -w[2]),
        ((-fx * w1[0], -fy * w1[0]), (-fx * w1[2], -fy * w1[2])),
        (
            (y1 + (1.0 - xi) * ry, -x1 - (1.0 - xi) * rx, -place1, xi - 1.0),
            (y2 + xi * ry, -x2 - xi * rx, -place2, -xi),
        ),
        (fx * x1 + fy * y1, fx * x2 + fy * y2),
    )
    return N, Tt, s, motion, spread


@inlined
def move(column, e, dv, by):
    """What a degree of freedom moves: the slave by e against the duct point, p' by dv."""
    by[column], by[COLUMNS + column] = e
    by[2 * COLUMNS + column], by[3 * COLUMNS + column] = dv


@inlined
def follow_moves(r, v, second, slowness, ds, force, d, by):
    """Of what slave and masters move, as `move` has written it, what it does to fx, fy, xi and the moment
    e x f. r: gap as a vector; v, second: p', p''; slowness: 1 / |p'|."""
    (rx, ry), (vx, vy), (cx, cy) = r, v, second
    tx, ty = vx * slowness, vy * slowness
    bend = 1.0 / (vx * vx + vy * vy - rx * cx - ry * cy)
    by_gap, by_turn, by_slip = (d[4, 0], d[4, 1]), (d[5, 0], d[5, 1]), (d[6, 0], d[6, 1])
    for j in range(LEFT):
        ex, ey, dvx, dvy = by[j], by[COLUMNS + j], by[2 * COLUMNS + j], by[3 * COLUMNS + j]
        dxi = (ex * vx + ey * vy + rx * dvx + ry * dvy) * bend
        dgap = ey * tx - ex * ty
        turn = (tx * (dvy + cy * dxi) - ty * (dvx + cx * dxi)) * slowness
        slip = ds * dxi
        by[j] = by_gap[0] * dgap + by_turn[0] * turn + by_slip[0] * slip
        by[COLUMNS + j] = by_gap[1] * dgap + by_turn[1] * turn + by_slip[1] * slip
        by[2 * COLUMNS + j] = dxi
        by[3 * COLUMNS + j] = ex * force[1] - ey * force[0]


@inlined
def turn_chords(d, by):
    """Add what the chords do to fx and fy: the slave moves them one way, the neighbours, which move nothing
    else, the other."""
    for j in range(2):
        for i in range(2):
            by[i * COLUMNS + SLAVE + j] += d[j, i] - d[j + 2, i]
            by[i * COLUMNS + LEFT + j], by[i * COLUMNS + RIGHT + j] = -d[j, i], d[j + 2, i]
            by[(2 + i) * COLUMNS + LEFT + j] = by[(2 + i) * COLUMNS + RIGHT + j] = 0.0
