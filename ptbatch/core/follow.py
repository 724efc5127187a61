"""Stage 4: the live pattern under displacement control, to the deflection limit or the rupture of the
tendon."""

from typing import NamedTuple

from ptbatch.core.case import Target
from ptbatch.core.failure import utilisation
from ptbatch.core.jit import kernel
from ptbatch.core.newton import CONVERGED
from ptbatch.core.ramp import DONE, NO_BUDGET, NO_EQUILIBRIUM, NO_ROOM
from ptbatch.core.step import accept, find_equilibrium

OVERSHOOT = 1.005  # of a limit strain: how near a step must land on it
EASY, HARD = 6, 12  # iterations of a step after which the next one may be longer, should be shorter
AFTER_FAILURE = 3000  # iterations that the curve beyond the first failure may take: it lends no capacity
SHORTER = 5  # step lengths that are tried, each a quarter of the one before


class Control(NamedTuple):
    """Displacement control: the degree of freedom, its value in the anchored state, the sense it is driven
    in, how far, and in what steps [mm]."""

    dof: int
    start: float
    sense: float
    limit: float
    first: float
    largest: float


class Trial(NamedTuple):
    """A step that was tried: whether it found equilibrium, at which load factor, and the largest limit
    strain's utilisation there."""

    step: float
    converged: bool
    factor: float
    iterations: int
    error: float
    demand: float
    tendon_broke: bool


@kernel
def follow(case, stage, fixed, pattern, control, bonded):
    """Load to failure; how it ended. Steps land on the first limit strain of a material."""
    state, history = case.state, case.history
    factor, step, taken = 0.0, control.first, 0.0
    concrete, bars, tendon = utilisation(case, state.u)
    used = max(concrete, bars, tendon)
    failed = used >= 1.0
    allowed = case.tolerance.budget
    while history.rows[0] < history.stage.size:
        left = control.limit - control.sense * (state.u[control.dof] - control.start)
        if left <= 1e-9 * control.limit:
            return DONE
        if case.work.spent[0] >= allowed:
            return NO_BUDGET
        trial = approach(case, fixed, pattern, control, bonded, factor, min(step, left), left, taken)
        if not trial.converged:
            return NO_EQUILIBRIUM
        if not failed and trial.demand > OVERSHOOT:
            trial = land(case, fixed, pattern, control, bonded, factor, trial, used)
        accept(case, stage, trial.factor, trial.iterations, trial.error)
        factor, used, taken = trial.factor, trial.demand, trial.step
        if not failed and used >= 1.0:
            failed = True
            allowed = min(allowed, case.work.spent[0] + AFTER_FAILURE)
        if trial.tendon_broke:
            return DONE
        growth = 1.5 if trial.iterations <= EASY else 1.1 if trial.iterations <= HARD else 0.7
        step = min(control.largest, max(control.first, trial.step * growth))
    return NO_ROOM


@kernel
def reach(case, fixed, pattern, control, bonded, factor, step, taken):
    """Try a further `step` of deflection from the committed state; taken: the last one, to look ahead by."""
    value = case.state.u[control.dof] + control.sense * step
    ahead = step / taken if taken > 0.0 else 0.0
    target = Target(fixed, pattern, control.dof, value, bonded)
    status, reached, iterations, error = find_equilibrium(case, target, factor, ahead)
    concrete, bars, tendon = utilisation(case, case.work.trial)
    demand = max(concrete, bars, tendon)
    return Trial(step, status == CONVERGED, reached, iterations, error, demand, tendon >= 1.0)


@kernel
def approach(case, fixed, pattern, control, bonded, factor, step, left, taken):
    """The first step that finds equilibrium: ever shorter ones, then, as a crack that opens at once passes
    its snap-back, longer ones."""
    size = step
    trial = reach(case, fixed, pattern, control, bonded, factor, size, taken)
    for _ in range(SHORTER - 1):
        if trial.converged:
            return trial
        size *= 0.25
        trial = reach(case, fixed, pattern, control, bonded, factor, size, taken)
    size = 0.5 * control.largest
    for _ in range(3):
        if trial.converged:
            return trial
        if step < size <= left:
            trial = reach(case, fixed, pattern, control, bonded, factor, size, 0.0)
        size *= 2.0
    return trial


@kernel
def land(case, fixed, pattern, control, bonded, factor, over, used):
    """A shorter step that ends on the limit strain that `over` passed; `over` itself where the response jumps
    across it."""
    last = over
    for _ in range(4):
        share = min(max((1.001 - used) / (last.demand - used), 0.1), 0.95)
        trial = reach(case, fixed, pattern, control, bonded, factor, last.step * share, 0.0)
        if not trial.converged or trial.demand < 1.0:
            break
        last = trial
        if last.demand <= OVERSHOOT:
            return last
    return reach(case, fixed, pattern, control, bonded, factor, last.step, 0.0)
