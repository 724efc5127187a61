"""The tendon's ends: jack, wedge set and anchorage element, eqs (24)-(32).

The end node sits on the duct's end tangent at `gap` (outward positive) from the anchor, which turns with the
end section; what pulls it reacts on the embedding node there. Degrees of freedom q (6,): gap; u, v, theta of
the beam node; tendon neighbour (x, y), positions relative to the beam node. Between the anchor and the first
tendon element stands a kink like that of any other node, so the force at the anchor is

    J = T (1 + a) / (1 - a) while the tendon slides out, T (1 - a) / (1 + a) while it slides in,

with a = mu tan(theta/2) + rough/2, which is what makes the tendon feel the whole angle of its profile.
"""

from typing import NamedTuple

from ptbatch.core.contact import ALMOST
from ptbatch.core.embedding import arm, turned
from ptbatch.core.jit import cos_sin, kernel, root
from ptbatch.core.model import ANCHORED, PRESCRIBED


class Anchor(NamedTuple):
    """Arm of the anchor above the beam node and the unit tangent that points out of the member, at rest."""

    y: float
    out_x: float
    out_y: float


@kernel
def anchor(side, model):
    n = model.x.size - 1
    if side == 0:
        slope = model.duct_slope[0, 0]
        norm = root(1.0 + slope * slope)
        return Anchor(model.duct_y[0], -1.0 / norm, -slope / norm)
    slope = model.duct_slope[n - 1, 1]
    norm = root(1.0 + slope * slope)
    return Anchor(model.duct_y[n], 1.0 / norm, slope / norm)


@kernel
def end_position(q, a):
    """The tendon's end node relative to the beam node's place at rest, and the current outward tangent."""
    turn = cos_sin(q[3])
    ax, ay = arm(a.y, turn)
    ox, oy = turned(a.out_x, a.out_y, turn)
    return q[1] + ax + q[0] * ox, q[2] + ay + q[0] * oy, ox, oy


@kernel
def end_friction(T, half_tan, slip, rub, rough, expected, c):
    """J - T after an outward slip that starts with the difference `rub`.

    expected: it slides out, whatever T says, which at the start of jacking is round-off.
    """
    trial = rub + c.tangential * slip
    a = c.mu * half_tan + 0.5 * rough
    out = 2.0 * a / (1.0 - a) * T
    into = -2.0 * a / (1.0 + a) * T
    if expected:
        return out
    if T.real <= 0.0:
        return 0.0 * T
    if trial.real > ALMOST * out.real:
        return out
    if trial.real < ALMOST * into.real:
        return into
    return trial


@kernel
def end_forces(q, mode, value, born, T, slope, length, slid, rub, rough, expected, a, c, f):
    """Forces f (6,); also returned: tan(theta/2) of the kink at the anchor.

    The row of the gap holds, by mode: PRESCRIBED gap - value; PULLED the jack force's balance; ANCHORED the
    anchorage spring, born at gap `born` with the force `value` of that moment, so that nothing moves when it
    takes over.
    """
    x, y, ox, oy = end_position(q, a)
    dx = q[4] - x
    dy = q[5] - y
    now = root(dx * dx + dy * dy)
    ex = dx / now
    ey = dy / now
    T = T + slope * (now - length)
    cross = ox * ey - oy * ex
    half_tan = (cross if cross.real >= 0.0 else -cross) / (1.0 - ox * ex - oy * ey)
    if mode == PRESCRIBED:
        f[0] = q[0] - value
    elif mode == ANCHORED:
        f[0] = T - value + c.anchor * (q[0] - born)
    else:
        f[0] = T + end_friction(T, half_tan, q[0] - slid, rub, rough, expected, c) - value
    f[1] = -T * ex
    f[2] = -T * ey
    f[3] = T * ((y - q[2]) * ex - (x - q[1]) * ey)
    f[4] = T * ex
    f[5] = T * ey
    return half_tan
