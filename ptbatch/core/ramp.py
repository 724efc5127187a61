"""Stages 1 to 3 and the sustained load: loads and the ends of the tendon move together from one place to
another."""

from typing import NamedTuple

from ptbatch.core.case import still
from ptbatch.core.contact import GROUTED
from ptbatch.core.equilibrium import imbalance_as_evaluated
from ptbatch.core.history import rewind
from ptbatch.core.jit import inlined, kernel
from ptbatch.core.newton import CONVERGED, equilibrate
from ptbatch.core.step import SPENT, WAYS, accept, find_equilibrium

DONE, NO_EQUILIBRIUM, NO_BUDGET, NO_ROOM = range(4)  # how a stage ended

SMALLEST = 1e-4  # of a stage: below this a step is given up
SAME = 1e-8  # of the force: nodes that friction holds but for so little rest
SURELY = 0.97  # of its friction: a node that needs less to rest has no neighbour that might as well


class Held(NamedTuple):
    """Equilibrium with one tendon node held: how it ended, iterations and residual; the friction to spare
    [N], the sense (1 to the right) in which the node would slide, and whether it surely would not."""

    status: int
    iterations: int
    error: float
    spare: float
    side: int
    surely: bool


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


@inlined
def hold(case, target, j):
    """Equilibrium with tendon node j held as grout would do it."""
    work, contact, motion = case.work, case.model.contact, case.state.motion
    motion[j] = GROUTED
    rewind(case.state, work)
    status, _, iterations, error = equilibrate(case, target, 0.0, WAYS[0])
    work.spent[0] += iterations
    capacity = contact.mu * abs(work.normal[j]) + work.rough[j] * 0.5 * (work.T[j - 1] + work.T[j])
    needed = abs(work.shear[j]) - SAME * case.tolerance.force
    side = 1 if work.shear[j] > 0.0 else -1
    return Held(status, iterations, error, capacity - needed, side, needed < SURELY * capacity)


@inlined
def settle(case, target, rest):
    """Equilibrium of a tendon that is pulled at both ends: by forces alone it could lie anywhere in its duct,
    so the node that rests is held, and the next one tried until friction alone can hold it; returns (status,
    iterations, largest imbalance, node at rest).

    Between two nodes that could both rest, as in a symmetric member, both slide: the tendon then lies where
    friction is just enough for that.
    """
    state, work = case.state, case.work
    motion, place = state.motion, state.s.copy()
    held = hold(case, target, rest)
    spent = held.iterations
    for _ in range(motion.size):
        other = rest - held.side
        if held.status != CONVERGED or held.surely or not 0 < other < motion.size - 1:
            break
        away = work.s[other] - state.s[other]
        motion[rest] = motion[rest + held.side]  # it slides as its neighbours do
        beside = hold(case, target, other)
        spent += beside.iterations
        tied = beside.side != held.side and (beside.spare >= 0.0) == (held.spare >= 0.0)
        if beside.status != CONVERGED or tied or held.spare >= 0.0:
            if beside.status == CONVERGED and tied:
                state.s[rest] -= away * held.spare / (held.spare + beside.spare)
            motion[other] = motion[other - held.side]
            held = hold(case, target, rest)
            spent += held.iterations
            break
        rest, held = other, beside
    status, error = held.status, held.error
    if status == CONVERGED:
        error = max(error, imbalance_as_evaluated(case, target, 0.0))
    if status != CONVERGED or error > case.tolerance.statics:
        status, _, iterations, error = find_equilibrium(case, target, 0.0, 0.0)
        spent += iterations
    state.s[:] = place
    return status, spent, error, rest
