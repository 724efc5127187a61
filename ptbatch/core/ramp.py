"""Stages 1 to 3 and the sustained load: loads and the ends of the tendon move together from one place to
another."""

from ptbatch.core.case import still
from ptbatch.core.jit import kernel
from ptbatch.core.model import PRESCRIBED
from ptbatch.core.newton import CONVERGED
from ptbatch.core.step import SPENT, accept, find_equilibrium

DONE, NO_EQUILIBRIUM, NO_BUDGET, NO_ROOM = range(4)  # how a stage ended

SMALLEST = 1e-4  # of a stage: below this a step is given up
SHORT = 0.98  # of the expected movement of a second jack: where its force is looked at for the first time
SAME = 1e-7  # of the force: two jacks pull alike
RIGHT = 1


@kernel
def ramp(case, stage, load_from, load_to, end_from, end_to, bonded, first):
    """Move loads (ndof,) and end values (2,) from their first to their second in steps that are cut where
    they must be; returns (how it ended, share of the stage done)."""
    load = load_from.copy()
    target = still(load, bonded)
    done, step = 0.0, first
    while done < 1.0:
        if case.history.rows[0] >= case.history.stage.size:
            return NO_ROOM, done
        share = 1.0 if done + 1.1 * step > 1.0 else done + step
        for i in range(2):
            case.ends.value[i] = end_from[i] + share * (end_to[i] - end_from[i])
        for i in range(load.size):
            load[i] = load_from[i] + share * (load_to[i] - load_from[i])
        status, _, iterations, error = find_equilibrium(case, target, 0.0, 0.0)
        if status == CONVERGED:
            accept(case, stage, 0.0, iterations, error)
            done = share
            step *= 2.0
        elif status == SPENT:
            return NO_BUDGET, done
        else:
            step = 0.25 * (share - done)
            if step < SMALLEST:
                return NO_EQUILIBRIUM, done
    return DONE, 1.0


@kernel
def pull_second_end(case, stage, force, movement, weight, first):
    """Jacking from two ends: the left one is pulled to `force`; the right one is moved outward until its
    force is the same, a little less than its expected movement first, so that the force is approached from
    below, then by what is missing. Returns as `ramp` does."""
    case.ends.mode[RIGHT] = PRESCRIBED
    start = case.ends.value.copy()
    goal = case.ends.value.copy()
    start[0], goal[0] = 0.0, force
    start[RIGHT] = case.state.u[case.state.u.size - 2]
    goal[RIGHT] = start[RIGHT] + SHORT * movement
    ended, done = ramp(case, stage, 0.0 * weight, weight, start, goal, False, first)
    if ended != DONE:
        return ended, done
    slope = right_force(case) / (goal[RIGHT] - start[RIGHT])
    for _ in range(20):
        before = right_force(case)
        missing = force - before
        if abs(missing) <= SAME * force:
            return DONE, 1.0
        start[:] = goal
        goal[RIGHT] += missing / slope
        ended, done = ramp(case, stage, weight, weight, start, goal, False, 1.0)
        if ended != DONE:
            return ended, 1.0
        slope = (right_force(case) - before) / (goal[RIGHT] - start[RIGHT])
    return NO_EQUILIBRIUM, 1.0


@kernel
def right_force(case):
    """Force at the right anchor in the last recorded step."""
    return case.history.anchor[case.history.rows[0] - 1, RIGHT]
