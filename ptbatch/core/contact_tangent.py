"""Tangent of one contact element: complex steps in the law of friction, and kinematics.

The force on the duct depends on seven quantities: the tendon's two chords (x, y each), the gap, the direction
of the duct and the slip. How it follows the turns and lengths of the chords is geometry. How gap, direction
and slip follow the twelve degrees of freedom is kinematics, eqs (4) and (5), carried to the curved duct: with
e the movement of the slave against the duct point under it, p' and p'' the derivatives of the duct by xi and
r the gap as a vector,

    d gap = e . n,   d xi (p' . p' - r . p'') = e . p' + r . dp',   d direction = n . (dp' + p'' d xi) / |p'|.
"""

import numpy as np

from ptbatch.core.contact import bisector, dot4, friction, shape
from ptbatch.core.jit import STEP, kernel


@kernel
def friction_derivatives(slip, rub, press, T, rough, was, c):
    """(T_t, motion), and the derivatives of T_t by slip, press and T; arguments as of `friction`."""
    by_slip, motion = friction(complex(slip, STEP), rub, complex(press, 0.0), complex(T, 0.0), rough, was, c)
    by_press, _ = friction(complex(slip, 0.0), rub, complex(press, STEP), complex(T, 0.0), rough, was, c)
    by_mean, _ = friction(complex(slip, 0.0), rub, complex(press, 0.0), complex(T, STEP), rough, was, c)
    return by_slip.real, motion, by_slip.imag / STEP, by_press.imag / STEP, by_mean.imag / STEP


@kernel
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


@kernel
def contact_tangent(q, px, py, xi, e3, e4, length, T, slope, s0, rub, rough, was, seg, c, d, f, k):
    """Forces f (8,) and tangent k (8, 12); also returned: (N, T_t, s, motion). Arguments as of
    `contact_forces` and `force_derivatives`, all real; d (7, 2) is scratch."""
    w, w1, w2 = shape(xi, seg.smooth)
    rx, ry = q[0] - dot4(w, px), q[1] - dot4(w, py)
    vx, vy = dot4(w1, px), dot4(w1, py)  # p'
    cx, cy = dot4(w2, px), dot4(w2, py)  # p''
    speed = np.sqrt(vx * vx + vy * vy)
    tx, ty = vx / speed, vy / speed
    s = seg.s + xi * seg.ds
    gap = ry * tx - rx * ty
    fx, fy, N, Tt, motion = force_derivatives(
        e3, e4, length, gap, (tx, ty), s - s0, T, slope, rub, rough, was, c, d
    )
    # levers of the force about the two masters: arm and direction, by their weights
    ax1, ay1, ax2, ay2 = px[0] - q[2], py[0] - q[3], px[2] - seg.h - q[5], py[2] - q[6]
    lever1 = w[0] * ax1 + w[1] * px[1], w[0] * ay1 + w[1] * py[1]
    lever2 = w[2] * ax2 + w[3] * px[3], w[2] * ay2 + w[3] * py[3]
    couple = rx * fy - ry * fx
    f[0] = fx
    f[1] = fy
    f[2] = -fx * w[0]
    f[3] = -fy * w[0]
    f[4] = -(fy * lever1[0] - fx * lever1[1] + (1.0 - xi) * couple)
    f[5] = -fx * w[2]
    f[6] = -fy * w[2]
    f[7] = -(fy * lever2[0] - fx * lever2[1] + xi * couple)
    bend = 1.0 / (speed * speed - rx * cx - ry * cy)
    for j in range(8, 12):  # neighbours move the chords alone
        row = j - 8
        sign = -1.0 if j < 10 else 1.0
        spread(sign * d[row, 0], sign * d[row, 1], xi, rx, ry, w, lever1, lever2, j, k)
    # movement e of the slave against the duct point, and dp', by each of the first eight degrees of freedom
    for j in range(8):
        ex = ey = vx_j = vy_j = 0.0
        if j == 0:
            ex = 1.0
        elif j == 1:
            ey = 1.0
        elif j == 2:
            ex, vx_j = -w[0], w1[0]
        elif j == 3:
            ey, vy_j = -w[0], w1[0]
        elif j == 4:
            ex, ey = lever1[1], -lever1[0]
            vx_j, vy_j = -(w1[0] * ay1 + w1[1] * py[1]), w1[0] * ax1 + w1[1] * px[1]
        elif j == 5:
            ex, vx_j = -w[2], w1[2]
        elif j == 6:
            ey, vy_j = -w[2], w1[2]
        else:
            ex, ey = lever2[1], -lever2[0]
            vx_j, vy_j = -(w1[2] * ay2 + w1[3] * py[3]), w1[2] * ax2 + w1[3] * px[3]
        dxi = (ex * vx + ey * vy + rx * vx_j + ry * vy_j) * bend
        dgap = ey * tx - ex * ty
        turn = (tx * (vy_j + cy * dxi) - ty * (vx_j + cx * dxi)) / speed
        slip = seg.ds * dxi
        dfx = d[4, 0] * dgap + d[5, 0] * turn + d[6, 0] * slip
        dfy = d[4, 1] * dgap + d[5, 1] * turn + d[6, 1] * slip
        if j < 2:
            dfx += d[j, 0] - d[j + 2, 0]
            dfy += d[j, 1] - d[j + 2, 1]
        spread(dfx, dfy, xi, rx, ry, w, lever1, lever2, j, k)
        # what the force itself does as weights, levers and gap change
        drx, dry = ex - vx * dxi, ey - vy * dxi
        dcouple = drx * fy - dry * fx
        dlever1_x, dlever1_y = (w1[0] * ax1 + w1[1] * px[1]) * dxi, (w1[0] * ay1 + w1[1] * py[1]) * dxi
        dlever2_x, dlever2_y = (w1[2] * ax2 + w1[3] * px[3]) * dxi, (w1[2] * ay2 + w1[3] * py[3]) * dxi
        if j == 4:
            dlever1_x, dlever1_y = dlever1_x - lever1[1], dlever1_y + lever1[0]
        elif j == 7:
            dlever2_x, dlever2_y = dlever2_x - lever2[1], dlever2_y + lever2[0]
        k[2, j] -= fx * w1[0] * dxi
        k[3, j] -= fy * w1[0] * dxi
        k[4, j] -= fy * dlever1_x - fx * dlever1_y + (1.0 - xi) * dcouple - dxi * couple
        k[5, j] -= fx * w1[2] * dxi
        k[6, j] -= fy * w1[2] * dxi
        k[7, j] -= fy * dlever2_x - fx * dlever2_y + xi * dcouple + dxi * couple
    return N, Tt, s, motion


@kernel
def spread(dfx, dfy, xi, rx, ry, w, lever1, lever2, j, k):
    """Column j of k for a change (dfx, dfy) of the force on the slave, its place being as it is."""
    couple = rx * dfy - ry * dfx
    k[0, j] = dfx
    k[1, j] = dfy
    k[2, j] = -dfx * w[0]
    k[3, j] = -dfy * w[0]
    k[4, j] = -(dfy * lever1[0] - dfx * lever1[1] + (1.0 - xi) * couple)
    k[5, j] = -dfx * w[2]
    k[6, j] = -dfy * w[2]
    k[7, j] = -(dfy * lever2[0] - dfx * lever2[1] + xi * couple)
