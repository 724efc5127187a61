"""Where an iteration's time goes: the real kernels in small loops, on a member in its last state."""

from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np

from benchmarks.stagewise import stressed
from benchmarks.table import Table
from ptbatch.analysis import serve
from ptbatch.core.assembly import add_beam, bend_beam, tangent
from ptbatch.core.case import Target
from ptbatch.core.equilibrium import imbalance_as_evaluated
from ptbatch.core.failure import demands_as_evaluated
from ptbatch.core.history import commit
from ptbatch.core.jit import kernel
from ptbatch.core.newton import factorise_tangent, residual_alone
from ptbatch.core.newton import step as increment
from ptbatch.core.placement import place_tendon
from ptbatch.member import Member

LOOP, REPEATS = 50, 9


@kernel
def beams(case, bonded, times):
    """Force and tangent of all beam elements."""
    for _ in range(times):
        case.work.f[:] = 0.0
        case.work.matrix[:] = 0.0
        bend_beam(case.model, case.state, case.work.trial, 0.0, case.work)
        for e in range(case.model.x.size - 1):
            add_beam(e, case.model, case.work)


@kernel
def assembled(case, bonded, times):
    """Force and tangent of the member."""
    for _ in range(times):
        place_tendon(case.model, case.state, case.work.trial, case.work)
        bend_beam(case.model, case.state, case.work.trial, 0.0, case.work)
        tangent(case.model, case.state, case.work.trial, case.ends, bonded, case.work)


@kernel
def solved(case, target, times):
    """The same, with an increment by displacement control."""
    for _ in range(times):
        place_tendon(case.model, case.state, case.work.trial, case.work)
        bend_beam(case.model, case.state, case.work.trial, 0.0, case.work)
        tangent(case.model, case.state, case.work.trial, case.ends, target.bonded, case.work)
        factorise_tangent(case)
        increment(case, target)


@kernel
def looked_at(case, target, times):
    """The residual alone."""
    for _ in range(times):
        residual_alone(case, target, 0.0)


@kernel
def accepted(case, target, times):
    """What an accepted step takes besides: the check by statics, limit strains, the commitment."""
    for _ in range(times):
        imbalance_as_evaluated(case, target, 0.0)
        demands_as_evaluated(case)
        commit(case.model, case.state, case.ends, case.work)


def microseconds(work: Callable[[int], Any]) -> float:
    """Least time of one turn of a loop."""
    work(1)  # compiles
    times = []
    for _ in range(REPEATS):
        start = perf_counter()
        work(LOOP)
        times.append(perf_counter() - start)
    return 1e6 * min(times) / LOOP


def parts(member: Member) -> tuple[float, ...]:
    """Microseconds of (beam, contact and tendon, solution, a look at the residual, acceptance)."""
    run = stressed(member)
    serve(run, 1)
    case, handle, setup = run.rig.case, run.rig.handle, run.setup
    bonded = bool(member.bond == "bonded")
    fixed = setup.self_weight + setup.sustained
    dof = 5 * setup.mesh.control + 3
    target = Target(fixed, setup.pattern, bonded, dof, -1, float(case.state.u[dof]))
    case.work.trial[:] = case.state.u
    case.work.residual[:] = np.zeros_like(case.state.u)
    beam = microseconds(lambda times: beams(handle, bonded, times))
    both = microseconds(lambda times: assembled(handle, bonded, times))
    every = microseconds(lambda times: solved(handle, target, times))
    look = microseconds(lambda times: looked_at(handle, target, times))
    step = microseconds(lambda times: accepted(handle, target, times))
    return beam, both - beam, every - both, look, step


def part_table(members: dict[str, Member]) -> Table:
    """A row for each member."""
    table = Table(
        "Parts of an iteration [us], one thread",
        ["member", "beam", "contact, tendon, ends", "solution", "sum", "residual alone", "acceptance"],
        note="An iteration is the sum, or where its tangent is still good, a solution with the residual "
        "alone; a step ends with a residual and its acceptance. Timed at the end of the live load.",
    )
    for name, member in members.items():
        beam, contact, solution, look, step = parts(member)
        table.add(name, beam, contact, solution, beam + contact + solution, look, step)
    return table
