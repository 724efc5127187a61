"""Stages 1 to 3 and the sustained load: loads and the ends of the tendon move together from one place to
another."""

from ptbatch.core.case import still
from ptbatch.core.contact import GROUTED
from ptbatch.core.equilibrium import imbalance_as_evaluated
from ptbatch.core.history import rewind
from ptbatch.core.jit import kernel
from ptbatch.core.newton import CONVERGED, equilibrate
from ptbatch.core.step import SPENT, WAYS, accept, find_equilibrium

DONE, NO_EQUILIBRIUM, NO_BUDGET, NO_ROOM = range(4)  # how a stage ended

SMALLEST = 1e-4  # of a stage: below this a step is given up
SAME = 1e-8  # of the force: nodes that friction holds but for so little rest


@kernel
def ramp(case, stage, load_from, load_to, end_from, end_to, bonded, first):
    """Move loads (ndof,) and end values (2,) from their first to their second in steps that are cut where
    they must be; returns (how it ended, share of the stage done)."""
    load = load_from.copy()
    target = still(load, bonded)
    done, step, rest = 0.0, first, held_node(case)
    while done < 1.0:
        if case.history.rows[0] >= case.history.stage.size:
            return NO_ROOM, done
        share = 1.0 if done + 1.1 * step > 1.0 else done + step
        for i in range(2):
            case.ends.value[i] = end_from[i] + share * (end_to[i] - end_from[i])
        for i in range(load.size):
            load[i] = load_from[i] + share * (load_to[i] - load_from[i])
        if rest > 0:
            status, iterations, error, rest = settle(case, target, rest)
        else:
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
def held_node(case):
    """The tendon node that is expected to rest while both ends are pulled; 0 where there is none."""
    for j in range(1, case.state.motion.size - 1):
        if case.state.motion[j] == GROUTED:
            return j
    return 0


@kernel
def settle(case, target, rest):
    """Equilibrium of a tendon that is pulled at both ends: by forces alone it could lie anywhere in its duct,
    so the node at rest is held as grout would do it, and the next one tried until friction alone can hold it;
    returns (status, iterations, largest imbalance, node at rest)."""
    motion = case.state.motion
    spent = 0
    for _ in range(motion.size):
        motion[rest] = GROUTED
        rewind(case.state, case.work)
        status, _, iterations, error = equilibrate(case, target, 0.0, WAYS[0])
        spent += iterations
        case.work.spent[0] += iterations
        if status != CONVERGED:
            break
        side = pushed(case, rest)
        if side == 0:
            error = max(error, imbalance_as_evaluated(case, target, 0.0))
            if error <= case.tolerance.statics:
                return CONVERGED, spent, error, rest
            break
        if not 0 < rest - side < motion.size - 1:
            break
        motion[rest] = motion[rest + side]  # it slides as its neighbours do
        rest -= side
    status, _, iterations, error = find_equilibrium(case, target, 0.0, 0.0)
    return status, spent + iterations, error, rest


@kernel
def pushed(case, j):
    """The sense (1 to the right) in which a held node would slide; 0 if friction can hold it."""
    work, contact = case.work, case.model.contact
    capacity = contact.mu * abs(work.normal[j]) + work.rough[j] * 0.5 * (work.T[j - 1] + work.T[j])
    if abs(work.shear[j]) <= capacity + SAME * case.tolerance.force:
        return 0
    return 1 if work.shear[j] > 0.0 else -1
