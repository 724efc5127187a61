"""Stage 4: the live pattern is followed to the deflection limit or the rupture of the tendon.

The deflection of the control point drives the load. Where a section that cracks or crushes turns the path
back (the member springs up as one hinge opens), no further deflection may have an equilibrium near by: then
the rotation of that hinge drives the load until the deflection grows again.
"""

from typing import NamedTuple

import numpy as np

from ptbatch.core.case import Target, driven
from ptbatch.core.failure import LIMIT, demands, demands_as_evaluated
from ptbatch.core.jit import inlined, kernel
from ptbatch.core.model import beam_dof
from ptbatch.core.newton import CONVERGED
from ptbatch.core.ramp import DONE, NO_BUDGET, NO_EQUILIBRIUM, NO_ROOM
from ptbatch.core.step import accept, find_equilibrium

AIM, OVERSHOOT = 1.001, 1.005  # of what is looked for: where a step is to land, how near it must
LEAST = 0.05  # of a step: it is not shortened further
LANDINGS = 6  # steps tried to do so
EASY, HARD = 6, 12  # iterations of a step after which the next one may be longer, should be shorter
# The curve beyond the first failure lends no capacity: iterations that it may take, how much longer its steps
# may be
AFTER_FAILURE, COARSER = 300, 2.0
SHORTER = 3  # step lengths that are tried, each a quarter of the one before
LONGER = 3  # and after these, for what drives the load cannot turn back but jump: each twice the one before
HINGE_STEPS = 80  # that a hinge may drive the load before the member is given up,
LOST = 0.1  # of the largest load so far: and the load below which it is


class Control(NamedTuple):
    """The control point: its degree of freedom, its value in the anchored state, the sense it is driven in,
    how far, and in what steps [mm]."""

    dof: int
    start: float
    sense: float
    limit: float
    first: float
    largest: float


class Load(NamedTuple):
    """Forces (ndof,) that stay and forces that are scaled, and whether the tendon is grouted."""

    fixed: object
    pattern: object
    bonded: bool


class Drive(NamedTuple):
    """What drives the load, see `Target`, and in which sense."""

    dof: int
    other: int
    sense: float


class Trial(NamedTuple):
    """A step that was tried: its length, whether it started ahead (see `reach`) and found equilibrium, at
    which load factor, and the `demands` there."""

    step: float
    ahead: bool
    converged: bool
    factor: float
    iterations: int
    error: float
    demand: tuple
    tendon_broke: bool


class Way(NamedTuple):
    """How far the load has come: its factor and the largest so far, the length of the last step (zero after a
    change of what drives), the `demands` now and before that step, which of them have been met, and the
    iterations allowed."""

    factor: float
    most: float
    taken: float
    used: tuple
    earlier: tuple
    met: tuple
    allowed: int


@kernel
def follow(case, stage, fixed, pattern, control, bonded):
    """Load to failure; how it ended. Steps land on the first crack, on yield, on the first limit strain."""
    load = Load(fixed, pattern, bonded)
    deflect = Drive(control.dof, -1, control.sense)
    used, _ = demands(case, case.state.u)
    way = Way(0.0, 0.0, 0.0, used, used, met(used), case.tolerance.budget)
    step = control.first
    while case.history.rows[0] < case.history.stage.size:
        left = control.limit - deflection(case, control)
        if left <= 1e-9 * control.limit:
            return DONE
        if case.work.spent[0] >= way.allowed:
            return NO_BUDGET
        trial = approach(case, load, deflect, foreseen(way, min(step, left)), way)
        if not trial.converged:
            trial = jump(case, load, deflect, step, control, left, way)
        if trial.converged:
            trial, way = take(case, stage, load, deflect, trial, way)
            largest = COARSER * control.largest if way.met[LIMIT] else control.largest
            step = min(largest, max(control.first, next_step(trial)))
        else:
            trial, way = turn_hinge(case, stage, load, control, way)
            step = control.first
        if not trial.converged:
            return NO_EQUILIBRIUM
        if trial.tendon_broke:
            return DONE
    return NO_ROOM


@kernel
def met(demand):
    """Which demands have reached what they look for."""
    return demand[0] >= 1.0, demand[1] >= 1.0, demand[2] >= 1.0


@kernel
def deflection(case, control):
    """Deflection of the control point since the anchored state."""
    return control.sense * (case.state.u[control.dof] - control.start)


@kernel
def next_step(trial):
    return trial.step * (1.5 if trial.iterations <= EASY else 1.1 if trial.iterations <= HARD else 0.7)


@kernel
def foreseen(way, step):
    """A step, shortened to end where the first demand is met if all goes on as in the last step."""
    if way.taken > 0.0:
        for i in range(3):
            pace = (way.used[i] - way.earlier[i]) / way.taken
            if not way.met[i] and way.used[i] + step * pace > OVERSHOOT:
                step = max((AIM - way.used[i]) / pace, LEAST * step)
    return step


@inlined
def reach(case, load, drive, step, way, ahead):
    """Try a further `step` from the committed state; ahead: start from the last step, extrapolated."""
    value = driven(case.state.u, drive.dof, drive.other) + drive.sense * step
    target = Target(load.fixed, load.pattern, load.bonded, drive.dof, drive.other, value)
    share = step / way.taken if ahead and way.taken > 0.0 else 0.0
    status, factor, iterations, error = find_equilibrium(case, target, way.factor, share)
    demand, tendon = demands_as_evaluated(case)
    return Trial(step, ahead, status == CONVERGED, factor, iterations, error, demand, tendon >= 1.0)


@inlined
def approach(case, load, drive, step, way):
    """The first step that finds equilibrium, ever shorter ones being tried."""
    trial = reach(case, load, drive, step, way, True)
    for _ in range(SHORTER - 1):
        if trial.converged:
            break
        trial = reach(case, load, drive, 0.25 * trial.step, way, True)
    return trial


@inlined
def jump(case, load, drive, step, control, left, way):
    """The first longer step that finds equilibrium, across the snap-back of a crack that opens at once."""
    size = 0.5 * control.largest
    trial = Trial(0.0, False, False, 0.0, 0, 0.0, (0.0, 0.0, 0.0), False)
    for _ in range(LONGER):
        if step < size <= left and not trial.converged:
            trial = reach(case, load, drive, size, way, False)
        size *= 2.0
    return trial


@inlined
def land(case, load, drive, over, way):
    """A shorter step that ends on the first of what `over` passed, found by interpolation; where the response
    jumps across it, the first step beyond that was found."""
    before, below = 0.0, way.used
    here = True  # whether `over` was tried last
    for _ in range(LANDINGS):
        share = first_passed(way, below, over.demand)
        if share == 1.0:
            break
        here = False
        width = over.step - before
        size = before + width * min(max(share, 0.05), 0.95)
        trial = reach(case, load, drive, size, way, False)
        if not trial.converged:
            break
        if news(way, trial.demand):
            over, here = trial, True
        else:
            before, below = size, trial.demand
    return over if here else reach(case, load, drive, over.step, way, over.ahead)  # which converges again


@kernel
def first_passed(way, below, demand):
    """Share of the way from `below` to `demand` after which the first is met that has not been before; all of
    it if what is met is just so."""
    share = 1.0
    for i in range(3):
        if not way.met[i] and demand[i] > OVERSHOOT:
            share = min(share, (AIM - below[i]) / (demand[i] - below[i]))
    return share


@kernel
def news(way, demand):
    """Whether a demand is met that has not been before."""
    now = met(demand)
    return (now[0] and not way.met[0]) or (now[1] and not way.met[1]) or (now[2] and not way.met[2])


@inlined
def take(case, stage, load, drive, trial, way):
    """Accept a trial, the first one beyond what is looked for on that; returns what was accepted and how far
    the load has come."""
    if first_passed(way, way.used, trial.demand) < 1.0:
        trial = land(case, load, drive, trial, way)
    if not trial.converged:
        return trial, way
    accept(case, stage, trial.factor, trial.iterations, trial.error)
    now = met(trial.demand)
    so_far = (way.met[0] or now[0], way.met[1] or now[1], way.met[2] or now[2])
    allowed = way.allowed
    if so_far[LIMIT] and not way.met[LIMIT]:
        allowed = min(allowed, case.work.spent[0] + AFTER_FAILURE)
    most = max(way.most, trial.factor)
    return trial, Way(trial.factor, most, trial.step, trial.demand, way.used, so_far, allowed)


@inlined
def turn_hinge(case, stage, load, control, way):
    """Let the element that turns fastest drive the load until the deflection grows beyond where it was."""
    furthest = deflection(case, control)
    drive, step = fastest(case)
    way = Way(way.factor, way.most, 0.0, way.used, way.used, way.met, way.allowed)
    trial = Trial(0.0, False, False, way.factor, 0, 0.0, way.used, False)
    for _ in range(HINGE_STEPS):
        if case.history.rows[0] >= case.history.stage.size or case.work.spent[0] >= way.allowed:
            break
        before = deflection(case, control)
        trial = approach(case, load, drive, step, way)
        if not trial.converged or trial.factor < LOST * way.most:
            trial = Trial(0.0, False, False, way.factor, 0, 0.0, way.used, False)
            break
        trial, way = take(case, stage, load, drive, trial, way)
        now = deflection(case, control)
        if trial.tendon_broke or now >= control.limit or (now > before and now > furthest):
            break
        step = next_step(trial)
        turning, turned = fastest(case)
        if turning.dof != drive.dof:
            drive, step = turning, turned
            way = Way(way.factor, way.most, 0.0, way.used, way.used, way.met, way.allowed)
    return trial, Way(way.factor, way.most, 0.0, way.used, way.used, way.met, way.allowed)


@kernel
def fastest(case):
    """The element whose ends turned most against each other in the last step, as a drive, and by how much."""
    history = case.history
    last = history.rows[0] - 1
    most = 0.0
    element = 0
    for e in range(case.model.x.size - 1):
        dof, other = beam_dof(e + 1) + 2, beam_dof(e) + 2
        turned = driven(history.u[last], dof, other) - driven(history.u[last - 1], dof, other)
        if abs(turned) > abs(most):
            most = turned
            element = e
    return Drive(beam_dof(element + 1) + 2, beam_dof(element) + 2, np.sign(most)), abs(most)
