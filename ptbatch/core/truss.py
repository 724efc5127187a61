"""Tendon element: a two-node truss on its current chord."""

import numpy as np

from ptbatch.core.jit import STEP, inlined, kernel
from ptbatch.core.tendon import RAMBERG_OSGOOD, tendon_stress


@kernel
def stretch(rest, length):
    """Strain of an element."""
    return (length - rest) / rest


@kernel
def tensions(strain, worst, rest, strand, T, slope):
    """Axial forces T (k,) of k elements and how they grow with the length, by the complex step."""
    if strand.law == RAMBERG_OSGOOD:
        evaluate(strain, worst, rest, strand, RAMBERG_OSGOOD, T, slope)
    else:
        evaluate(strain, worst, rest, strand, strand.law, T, slope)


@inlined
def evaluate(strain, worst, rest, strand, law, T, slope):
    """`tensions` under a law; with one that is known when this is compiled, several elements at a time."""
    for e in range(strain.size):
        found = strand.Aps * tendon_stress(complex(strain[e], STEP), worst[e], law, strand)
        T[e] = found.real
        slope[e] = found.imag / STEP / rest[e]


@kernel
def truss_tangent(T, slope, ex, ey, length, k):
    """Tangent block k (2, 2) of the force on the far node by its own position: material along the chord, T /
    length across."""
    across = T / length
    k[0, 0] = slope * ex * ex + across * ey * ey
    k[0, 1] = (slope - across) * ex * ey
    k[1, 0] = k[0, 1]
    k[1, 1] = slope * ey * ey + across * ex * ex


@kernel
def unit(x, y):
    """(length, ex, ey)."""
    length = np.sqrt(x * x + y * y)
    return length, x / length, y / length
