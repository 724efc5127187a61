"""Where the tendon lies in its duct while the beam and the anchors stand still.

The tendon alone is a chain of elements between nodes that friction holds. Whether one node slides depends on
all others; Newton's method looks at each alone and turns them round one after the other, an iteration each.
Here all are found in one pass.

The further a node has moved, the larger the tension on its left, whatever lies to its right: a line in these
two, with two kinks for each node to the left, where that begins to slide back and forth. An element carries
the line on from one node to the next, which adds its own kinks, and at the right anchor, which stands still,
the line tells on which side of each kink the tendon is.
"""

from ptbatch.core.contact import BACKWARD, FORWARD, STICKING, UNKNOWN, bisector, friction
from ptbatch.core.jit import inlined, kernel

UNEVEN = 1e-5  # of the largest tension: what is less out of balance is left to Newton's method
ROUND_OFF = 1e-6  # of a friction force


@kernel
def turns_round(model, state, work):
    """Lay the chain out; whether a node has begun to move in another way since the last tangent, and more
    than next to nothing is out of balance."""
    n, contact = model.x.size - 1, model.contact
    lay_out(n, work, contact)
    return turns(n, state, work, contact)


@kernel
def slide(model, state, work):
    """Find how far the inner tendon nodes, as laid out, slide (work.ahead, along work.axis) until friction
    balances the tensions, if these grow with the elements' lengths as they do now, and the nodes' ways along
    the duct by work.pace; false where friction would have it otherwise."""
    n, contact = model.x.size - 1, model.contact
    find_senses(n, state, work, contact)
    solve(n, state, work, contact)
    return agrees(n, state, work, contact)


@inlined
def lay_out(n, work, contact):
    """The chain as it lies: directions, and how each node's friction grows with the tensions beside it."""
    for j in range(1, n + 1):
        e3, e4 = (work.chord[j - 1, 0], work.chord[j - 1, 1]), (work.chord[j, 0], work.chord[j, 1])
        ux, uy = bisector(e3, e4)
        into3, into4 = e3[0] * uy - e3[1] * ux, e4[1] * ux - e4[0] * uy
        mu = contact.mu if into3 + into4 >= 0.0 else -contact.mu
        work.axis[j, 0], work.axis[j, 1] = ux, uy
        work.along[j, 0], work.along[j, 1] = e3[0] * ux + e3[1] * uy, e4[0] * ux + e4[1] * uy
        work.grip[j, 0] = mu * into3 + 0.5 * work.rough[j]
        work.grip[j, 1] = mu * into4 + 0.5 * work.rough[j]


@inlined
def tension(e, work):
    """Tension of element e when the nodes at its ends have moved on."""
    far = work.ahead[e + 1] * work.along[e + 1, 0]
    return work.T[e] + work.slope[e] * (far - work.ahead[e] * work.along[e, 1])


@inlined
def stuck(j, state, work, contact):
    """Friction of a node that sticks, where it is now."""
    return state.rub[j] + contact.tangential * (work.s[j] - state.s[j])


@inlined
def turns(n, state, work, contact):
    """Whether a node moves in another way than at the last tangent, and a node is out of balance."""
    changes = False
    worst = largest = 0.0
    for j in range(1, n + 1):
        capacity = work.grip[j, 0] * work.T[j - 1] + work.grip[j, 1] * work.T[j]
        slip = work.s[j] - state.s[j]
        # the law makes the capacity of N and T; here it is known as a whole
        force, sense = friction(slip, state.rub[j], 0.0, capacity, 1.0, UNKNOWN, contact)
        changes = changes or sense != work.motion[j]
        rest = work.T[j] * work.along[j, 1] - work.T[j - 1] * work.along[j, 0] - force
        worst, largest = max(worst, abs(rest)), max(largest, work.T[j])
    return changes and worst > UNEVEN * largest


@inlined
def find_senses(n, state, work, contact):
    """work.sense of all nodes in equilibrium, from the line that the kinks (work.kinks, work.turner: how far
    and the tension there; whose, less than zero where that slides back) are on, from the lowest to the
    highest."""
    x, T, whose = kinks(0, work)
    x[0], T[0], whose[0] = 0.0, work.T[0], 0  # a point of the first line, which has no kink
    size = 1
    before = (1.0, work.slope[0] * work.along[1, 0])  # how the line goes on below the lowest kink
    beyond = before  # and above the highest
    for j in range(1, n + 1):
        a3, a4, g3, g4 = work.along[j, 0], work.along[j, 1], work.grip[j, 0], work.grip[j, 1]
        # T4 of a node that slides back, slides on, sticks: back * T3, on * T3, by_0 + by_t * T3 + by_x * x
        back, on = (a3 - g3) / (a4 + g4), (a3 + g3) / (a4 - g4)
        by_0, by_t = stuck(j, state, work, contact) / a4, a3 / a4
        by_x = contact.tangential * work.pace[j] / a4
        # kinks below where the node ceases to slide back, and below where it begins to slide on
        low = kinks_below(0, size, x, T, by_0, by_t - back, by_x)
        high = kinks_below(low, size, x, T, by_0, by_t - on, by_x)
        low_x, low_t = crossing(low, size, x, T, before, beyond, by_0, by_t - back, by_x)
        high_x, high_t = crossing(high, size, x, T, before, beyond, by_0, by_t - on, by_x)
        to_x, to_t, to_whose = kinks(j, work)
        for i in range(low):
            to_x[i], to_t[i], to_whose[i] = x[i], T[i] * back, whose[i]
        to_x[low], to_t[low], to_whose[low] = low_x, low_t * back, -j
        for i in range(low, high):
            to_x[i + 1], to_t[i + 1] = x[i], by_0 + by_t * T[i] + by_x * x[i]
            to_whose[i + 1] = whose[i]
        to_x[high + 1], to_t[high + 1], to_whose[high + 1] = high_x, high_t * on, j
        for i in range(high, size):
            to_x[i + 2], to_t[i + 2], to_whose[i + 2] = x[i], T[i] * on, whose[i]
        x, T, whose = to_x, to_t, to_whose
        size += 2
        # over the element to the next node, or to the anchor, which nothing has turned away from
        cosine = work.along[j + 1, 0] if j < n else 1.0
        turned, stretched, rest = a4 / cosine, 1.0 / (work.slope[j] * cosine), work.T[j]
        for i in range(size):
            x[i] = x[i] * turned + (T[i] - rest) * stretched
        before = (before[0] * turned + before[1] * back * stretched, before[1] * back)
        beyond = (beyond[0] * turned + beyond[1] * on * stretched, beyond[1] * on)
        work.sense[j] = STICKING
    for i in range(size):
        if x[i] <= 0.0 and whose[i] > 0:
            work.sense[whose[i]] = FORWARD
        elif x[i] > 0.0 and whose[i] < 0:
            work.sense[-whose[i]] = BACKWARD


@inlined
def kinks(j, work):
    """Where there is room for the line beyond node j; that before it stays."""
    side = j % 2
    return work.kinks[side, 0], work.kinks[side, 1], work.turner[side]


@inlined
def kinks_below(first, size, x, T, by_0, by_t, by_x):
    """How many kinks, `first` or more, lie before by_0 + by_t T + by_x x, which grows along the line, passes
    zero."""
    low, high = first, size
    while low < high:
        i = (low + high) // 2
        if by_0 + by_t * T[i] + by_x * x[i] <= 0.0:
            low = i + 1
        else:
            high = i
    return low


@inlined
def crossing(i, size, x, T, before, beyond, by_0, by_t, by_x):
    """Where by_0 + by_t T + by_x x passes zero on the line below kink i."""
    if i == 0:
        share = (by_0 + by_t * T[0] + by_x * x[0]) / (by_t * before[1] + by_x * before[0])
        return x[0] - share * before[0], T[0] - share * before[1]
    below = by_0 + by_t * T[i - 1] + by_x * x[i - 1]
    if i == size:
        share = -below / (by_t * beyond[1] + by_x * beyond[0])
        return x[i - 1] + share * beyond[0], T[i - 1] + share * beyond[1]
    share = below / (below - (by_0 + by_t * T[i] + by_x * x[i]))
    return x[i - 1] + share * (x[i] - x[i - 1]), T[i - 1] + share * (T[i] - T[i - 1])


@inlined
def solve(n, state, work, contact):
    """work.ahead of nodes that move as work.sense says: a tridiagonal system, whose diagonal and upper side
    are left in work.diagonal and work.upper."""
    for j in range(1, n + 1):
        a3, a4, k3, k4 = work.along[j, 0], work.along[j, 1], work.slope[j - 1], work.slope[j]
        by3, by4, spring, force = a3, a4, 0.0, 0.0
        if work.sense[j] == STICKING:
            spring, force = contact.tangential * work.pace[j], stuck(j, state, work, contact)
        else:
            sign = 1.0 if work.sense[j] == FORWARD else -1.0
            by3 += sign * work.grip[j, 0]
            by4 -= sign * work.grip[j, 1]
        diagonal = -by4 * k4 * a4 - by3 * k3 * a3 - spring
        right = force + by3 * work.T[j - 1] - by4 * work.T[j]
        if j > 1:
            multiplier = by3 * k3 * work.along[j - 1, 1] / work.diagonal[j - 1]
            diagonal -= multiplier * work.upper[j - 1]
            right -= multiplier * work.ahead[j - 1]
        work.diagonal[j], work.ahead[j] = diagonal, right
        work.upper[j] = by4 * k4 * work.along[j + 1, 0]
    for j in range(n, 0, -1):
        work.ahead[j] = (work.ahead[j] - work.upper[j] * work.ahead[j + 1]) / work.diagonal[j]


@inlined
def agrees(n, state, work, contact):
    """Whether the law says the same as work.sense where the nodes have moved on to, but for round-off: it
    does not where the tendon would be slack."""
    for j in range(1, n + 1):
        capacity = work.grip[j, 0] * tension(j - 1, work) + work.grip[j, 1] * tension(j, work)
        trial = stuck(j, state, work, contact) + contact.tangential * work.pace[j] * work.ahead[j]
        near = ROUND_OFF * (abs(capacity) + UNEVEN * abs(work.T[j]))
        if work.sense[j] == STICKING:
            if not abs(trial) <= capacity + near:
                return False
        elif not (trial if work.sense[j] == FORWARD else -trial) >= capacity - near:
            return False
    return True
