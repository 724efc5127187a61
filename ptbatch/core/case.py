"""One analysis as the kernels take it: the member, its committed state, what drives its ends, scratch and
record."""

from typing import NamedTuple

from ptbatch.core.history import History
from ptbatch.core.jit import kernel
from ptbatch.core.model import Ends, Model, State
from ptbatch.core.work import Work


class Tolerance(NamedTuple):
    """Convergence: largest residual over `force` (moments over force * arm) and largest increment over
    `length`; equilibrium of an accepted step, checked by statics; most iterations of a whole analysis."""

    residual: float
    increment: float
    statics: float
    force: float
    arm: float
    length: float
    budget: int


class Case(NamedTuple):
    """What an analysis works on."""

    model: Model
    state: State
    ends: Ends
    work: Work
    history: History
    tolerance: Tolerance


class Target(NamedTuple):
    """External forces `fixed + factor * pattern`, of which the factor is free if something is driven: then
    the displacement `dof`, less the one at `other` if that is not negative, is to reach `value`. The tendon
    sticks to its duct where it is bonded."""

    fixed: object  # (ndof,)
    pattern: object  # (ndof,)
    bonded: bool
    dof: int
    other: int
    value: float


@kernel
def still(load, bonded):
    """The target of a given load."""
    return Target(load, load, bonded, -1, -1, 0.0)  # under a factor of zero


@kernel
def driven(u, dof, other):
    """What is driven, taken from a vector of displacements."""
    return u[dof] - u[other] if other >= 0 else u[dof]
