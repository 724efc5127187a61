"""Embedding element in its rigid limit: the arm from a beam node to the duct turns with the node's section.

It ties u, v, theta of the beam node to the duct node exactly, so it adds no unknowns and no penalty, and an
arm of zero length is nothing special.
"""

from ptbatch.core.jit import cos_sin, kernel


@kernel
def arm(y, theta):
    """The duct node as seen from the beam node: (0, y) turned by theta."""
    c, s = cos_sin(theta)
    return -s * y, c * y


@kernel
def turned(x, y, theta):
    """Vector (x, y) turned by theta."""
    c, s = cos_sin(theta)
    return c * x - s * y, s * x + c * y
