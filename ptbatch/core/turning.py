"""How much duct each tendon node stands for: its tributary length, and the turning in it that the node does
not feel.

A node's kink is the signed turning of the duct, weighted by the hat function between its neighbours. Where
curvature changes sign inside a hat the two signs cancel in the kink but not in the friction. The difference,
the hidden angle, is friction without a kink, like wobble.
"""

import numpy as np

from ptbatch.core.jit import kernel


@kernel
def place(s, stations):
    """(interval, weights (4,)) of the cubic Hermite value at s of what is tabulated at
    stations: see `integral`."""
    i = np.searchsorted(stations, s) - 1
    i = min(max(i, 0), stations.size - 2)
    h = stations[i + 1] - stations[i]
    t = (s - stations[i]) / h
    t2 = t * t
    t3 = t2 * t
    rise = 3.0 * t2 - 2.0 * t3
    return i, (1.0 - rise, (t - 2.0 * t2 + t3) * h, rise, (t3 - t2) * h)


@kernel
def integral(i, w, table):
    """Value of a tabulated first integral; the columns are value, slope to the right and slope to the
    left."""
    return w[0] * table[i, 0] + w[1] * table[i, 1] + w[2] * table[i + 1, 0] + w[3] * table[i + 1, 2]


@kernel
def roughness(s, model, rough):
    """Friction without a kink, per unit of tendon force, at each tendon node: mu times hidden angle + K times
    tributary length.

    s (n+2,) are the nodes' arc lengths, the ends' set to those of the anchors; the result goes to rough
    (n+2,).
    """
    last = s.size - 1
    stations = model.hat_s
    end = stations.size - 1
    turned_before = 0.0
    angle_before = model.hat_angle[0, 1]
    turn = model.hat_turn[0, 0]
    angle = model.hat_angle[0, 0]
    span_before = 0.0
    for j in range(last + 1):
        if j < last:
            span = s[j + 1] - s[j]
            i, w = place(s[j + 1], stations)
            next_turn = integral(i, w, model.hat_turn)
            next_angle = integral(i, w, model.hat_angle)
            turned = (next_turn - turn) / span
            direction = (next_angle - angle) / span
        else:
            span = 0.0
            next_turn = turn
            next_angle = angle
            turned = model.hat_turn[end, 2]
            direction = model.hat_angle[end, 2]
        hidden = (turned - turned_before) - abs(direction - angle_before)
        rough[j] = model.contact.mu * max(hidden, 0.0) + model.contact.K * 0.5 * (span + span_before)
        turned_before = turned
        angle_before = direction
        turn = next_turn
        angle = next_angle
        span_before = span
