"""Tangent of one contact element: complex steps in what its force depends on, and kinematics.

The force on the duct depends on seven quantities: the tendon's two chords (x, y each), the gap, the direction
of the duct and the slip. A complex step in each of them gives its derivatives by these. How gap, direction
and slip follow the twelve degrees of freedom is kinematics, eqs (4) and (5), carried to the curved duct: with
e the movement of the slave against the duct point under it, p' and p'' the derivatives of the duct by xi and
r the gap as a vector,

    d gap = e . n,   d xi (p' . p' - r . p'') = e . p' + r . dp',   d direction = n . (dp' + p'' d xi) / |p'|.
"""

import numpy as np

from ptbatch.core.contact import chords, dot4, masters, node_force, shape
from ptbatch.core.jit import STEP, kernel


@kernel
def step_in(x, here):
    """x with a complex step if this is the quantity to differentiate by."""
    return complex(x, STEP if here else 0.0)


@kernel
def force_derivatives(a, b, gap, t, slip, T, slope, rub, rough, was, c, d):
    """(fx, fy, N, T_t, motion), and in d (7, 2) the derivatives of (fx, fy) by a, b, gap, direction, slip.

    T, slope: tensions left and right and their slopes by length.
    """
    at_rest = complex(gap, 0.0), (complex(t[0], 0.0), complex(t[1], 0.0)), complex(slip, 0.0)
    for i in range(4):
        za = step_in(a[0], i == 0), step_in(a[1], i == 1)
        zb = step_in(b[0], i == 2), step_in(b[1], i == 3)
        e3, e4, u = chords(za, zb)
        # a chord grows by its unit vector times the step of its end
        T3 = complex(T[0], slope[0] * e3[i].real * STEP if i < 2 else 0.0)
        T4 = complex(T[1], slope[1] * e4[i - 2].real * STEP if i > 1 else 0.0)
        fx, fy, _, _, _ = node_force(e3, e4, u, *at_rest, T3, T4, rub, rough, was, c)
        d[i, 0] = fx.imag / STEP
        d[i, 1] = fy.imag / STEP
    e3, e4, u = chords(a, b)
    for i in range(4, 7):
        turned = complex(t[0], -t[1] * STEP if i == 5 else 0.0), complex(t[1], t[0] * STEP if i == 5 else 0.0)
        moved = step_in(gap, i == 4), turned, step_in(slip, i == 6)
        fx, fy, _, _, _ = node_force(e3, e4, u, *moved, T[0], T[1], rub, rough, was, c)
        d[i, 0] = fx.imag / STEP
        d[i, 1] = fy.imag / STEP
    return node_force(e3, e4, u, gap, t, slip, T[0], T[1], rub, rough, was, c)


@kernel
def contact_tangent(q, xi, T, slope, s0, rub, rough, was, seg, c, d, f, k):
    """Forces f (8,) and tangent k (8, 12); also returned: (N, T_t, s, motion). Arguments as of
    `contact_forces`, all real; d (7, 2) is scratch."""
    px, py = masters(q, seg)
    w, w1, w2 = shape(xi, seg.smooth)
    rx, ry = q[0] - dot4(w, px), q[1] - dot4(w, py)
    vx, vy = dot4(w1, px), dot4(w1, py)  # p'
    cx, cy = dot4(w2, px), dot4(w2, py)  # p''
    speed = np.sqrt(vx * vx + vy * vy)
    tx, ty = vx / speed, vy / speed
    a = (q[0] - q[8], q[1] - q[9])
    b = (q[10] - q[0], q[11] - q[1])
    s = seg.s + xi * seg.ds
    gap = ry * tx - rx * ty
    fx, fy, N, Tt, motion = force_derivatives(a, b, gap, (tx, ty), s - s0, T, slope, rub, rough, was, c, d)
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
