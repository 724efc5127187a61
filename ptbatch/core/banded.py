"""Unsymmetric banded matrices: row i holds its columns i - half .. i + half."""

from ptbatch.core.jit import kernel


@kernel
def factorise(a, half, multipliers, pivots):
    """LU with partial pivoting, in place.

    a (n, 2 half + 1): column j of row i at a[i, j - i + half] on entry. On return U of row i starts at a[i,
    0]; the multipliers (n, half) and the pivots (n,) hold L. False where a pivot is zero or not finite.
    """
    n = a.shape[0]
    width = 2 * half + 1
    for i in range(min(half, n)):  # left-align the first rows, which have no columns before 0
        shift = half - i
        for j in range(width - shift):
            a[i, j] = a[i, j + shift]
        for j in range(width - shift, width):
            a[i, j] = 0.0
    last = min(half, n)
    for k in range(n):
        if last < n:
            last += 1
        p = k
        big = abs(a[k, 0])
        for i in range(k + 1, last):
            if abs(a[i, 0]) > big:
                big = abs(a[i, 0])
                p = i
        pivots[k] = p
        if not (0.0 < big < 1e300):
            return False
        if p != k:
            for j in range(width):
                a[k, j], a[p, j] = a[p, j], a[k, j]
        inverse = 1.0 / a[k, 0]
        for i in range(k + 1, last):
            m = a[i, 0] * inverse
            multipliers[k, i - k - 1] = m
            if m != 0.0:
                for j in range(1, width):
                    a[i, j - 1] = a[i, j] - m * a[k, j]
            else:
                for j in range(1, width):
                    a[i, j - 1] = a[i, j]
            a[i, width - 1] = 0.0
    return True


@kernel
def substitute(a, half, multipliers, pivots, b, c):
    """Solve for two right-hand sides b and c (n,), in place: a second one costs next to nothing, since each
    number waits for the one before."""
    n = a.shape[0]
    width = 2 * half + 1
    for k in range(n):
        p = pivots[k]
        if p != k:
            b[k], b[p] = b[p], b[k]
            c[k], c[p] = c[p], c[k]
        for i in range(min(half, n - 1 - k)):
            b[k + 1 + i] -= multipliers[k, i] * b[k]
            c[k + 1 + i] -= multipliers[k, i] * c[k]
    for k in range(n - 1, -1, -1):
        most = min(width, n - k)
        b_odd, b_even, c_odd, c_even = b[k], 0.0, c[k], 0.0
        for j in range(1, most - 1, 2):
            b_odd -= a[k, j] * b[k + j]
            c_odd -= a[k, j] * c[k + j]
            b_even -= a[k, j + 1] * b[k + j + 1]
            c_even -= a[k, j + 1] * c[k + j + 1]
        if most % 2 == 0:
            b_odd -= a[k, most - 1] * b[k + most - 1]
            c_odd -= a[k, most - 1] * c[k + most - 1]
        b[k] = (b_odd + b_even) / a[k, 0]
        c[k] = (c_odd + c_even) / a[k, 0]
