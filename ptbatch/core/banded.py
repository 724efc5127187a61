"""Unsymmetric banded matrices (n, 3 half + 1): row i holds its columns i - half .. i + half, and room for
half as many more to the right of these, which the swaps of rows may fill.

Indices are unsigned: numba would look at each of the others twice, should it count from the end.
"""

import numpy as np

from ptbatch.core.jit import inlined, kernel

GOOD = 0.1  # of the largest pivot: a diagonal as large as this need not be swapped, rows weighed alike


@kernel
def half_width(a):
    return a.shape[1] // 3


@kernel
def weigh_rows(a, weights):
    """One over the largest number of each row, zero for a row without any."""
    for i in range(a.shape[0]):
        largest = 0.0
        for j in range(2 * half_width(a) + 1):
            size = abs(a[i, j])
            largest = size if size > largest else largest
        weights[i] = 1.0 / largest if largest > 0.0 else 0.0


@inlined
def pivot_row(a, k, below, weights):
    """The row to eliminate column k with, out of k and so many below it, and whether there is one."""
    half, one = np.uint64(half_width(a)), np.uint64(1)
    p, own = k, abs(a[k, half]) * weights[k]
    largest = own
    for i in range(one, below + one):
        size = abs(a[k + i, half - i]) * weights[k + i]
        largest = size if size > largest else largest
    if not own >= GOOD * largest:
        for i in range(one, below + one):
            if abs(a[k + i, half - i]) * weights[k + i] == largest:
                p = k + i
    return p, 0.0 < largest < np.inf


@kernel
def factorise(a, weights, multipliers, pivots, reach):
    """LU in place, with partial pivoting by a threshold; false where a pivot is zero or not finite.

    On return U of row i stands in its columns i .. reach[i], in place of its diagonal one over that; the
    multipliers (n, half) and the pivots (n,) hold L. weights (n,) is scratch.
    """
    n, one = np.uint64(a.shape[0]), np.uint64(1)
    half = np.uint64(half_width(a))
    weigh_rows(a, weights)
    last = np.uint64(0)
    for k in range(n):
        below = min(half, n - one - k)
        p, sound = pivot_row(a, k, below, weights)
        if not sound:
            return False
        pivots[k] = p
        last = max(last, min(p + half, n - one))
        reach[k] = last
        right = last - k
        if p != k:
            weights[k], weights[p] = weights[p], weights[k]
            at = half + k - p
            for j in range(right + one):
                a[k, half + j], a[p, at + j] = a[p, at + j], a[k, half + j]
        a[k, half] = inverse = 1.0 / a[k, half]
        for i in range(one, below + one):
            row, at = k + i, half - i
            m = a[row, at] * inverse
            multipliers[k, i - one] = m
            if m != 0.0:
                for j in range(one, right + one):
                    a[row, at + j] -= m * a[k, half + j]
    return True


@kernel
def substitute(a, multipliers, pivots, reach, b, c):
    """Solve for two right-hand sides b and c (n,), in place: a second one costs next to nothing, since each
    number waits for the one before."""
    n, half, one, two = np.uint64(a.shape[0]), np.uint64(half_width(a)), np.uint64(1), np.uint64(2)
    for k in range(n):
        p = np.uint64(pivots[k])
        if p != k:
            b[k], b[p] = b[p], b[k]
            c[k], c[p] = c[p], c[k]
        b_k, c_k = b[k], c[k]
        for i in range(min(half, n - one - k)):
            b[k + one + i] -= multipliers[k, i] * b_k
            c[k + one + i] -= multipliers[k, i] * c_k
    for done in range(n):
        row = n - one - done
        right = np.uint64(reach[row]) - row
        b_odd, b_even, c_odd, c_even = b[row], 0.0, c[row], 0.0
        for j in range(one, right, two):
            b_odd -= a[row, half + j] * b[row + j]
            c_odd -= a[row, half + j] * c[row + j]
            b_even -= a[row, half + j + one] * b[row + j + one]
            c_even -= a[row, half + j + one] * c[row + j + one]
        if right % two == one:
            b_odd -= a[row, half + right] * b[row + right]
            c_odd -= a[row, half + right] * c[row + right]
        b[row] = (b_odd + b_even) * a[row, half]
        c[row] = (c_odd + c_even) * a[row, half]
