"""Embedding element in its rigid limit: the arm from a beam node to the duct turns with the node's section.

It ties u, v, theta of the beam node to the duct node exactly, so it adds no unknowns and no penalty, and an
arm of zero length is nothing special.
"""

from ptbatch.core.jit import kernel


@kernel
def arm(y, turn):
    """The duct node as seen from the beam node: (0, y) turned by the angle of this cosine and sine."""
    return -turn[1] * y, turn[0] * y


@kernel
def turned(x, y, turn):
    """Vector (x, y) turned by the angle of this cosine and sine."""
    return turn[0] * x - turn[1] * y, turn[1] * x + turn[0] * y
