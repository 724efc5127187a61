"""The analysis of one member: jacking, wedge set, anchoring, service."""

from dataclasses import replace

from ptbatch import stages
from ptbatch.ageing import lose
from ptbatch.core.case import Case, Tolerance
from ptbatch.core.follow import Control
from ptbatch.core.history import new_history
from ptbatch.core.ramp import DONE
from ptbatch.core.work import new_work
from ptbatch.design.longterm import TimeLoss
from ptbatch.design.time_losses import takes_time, time_loss
from ptbatch.losses import Losses, fpj_for_mean
from ptbatch.member import Member
from ptbatch.model.arrays import Setup, half_bandwidth, model, set_up
from ptbatch.model.duct import TendonStart
from ptbatch.postprocess import anchored, finished, stopped
from ptbatch.response import Response
from ptbatch.run import Run
from ptbatch.tendon_losses import tendon_losses

ROWS = 1200  # most steps recorded of one member
FPE_TOLERANCE = 2e-8  # of the mean stress: some loads of cracking change by 40 times its error
BUDGET = 30_000  # iterations of one member at most
OTHER_STEPS = (1.1, 1.3)  # times as fine: where cracks open at once, steps decide on whether a way is found


def analyse(member: Member, *, refine: float = 1.0) -> Response:
    """Analyse a member through all its stages.

    refine: divide the steps of the live load by this. A member that finds no equilibrium under live load is
    analysed again with OTHER_STEPS; if it still finds none, nothing is raised: see Response.status.
    """
    response = through_the_stages(member, refine)
    for share in OTHER_STEPS:
        if response.status != "not converged" or response.curve is None:
            break
        again = through_the_stages(member, share * refine, response.newton_iterations)
        told = response if again.status == "not converged" else again
        response = replace(told, newton_iterations=again.newton_iterations)
    return response


def through_the_stages(member: Member, refine: float, spent: int = 0) -> Response:
    """Analyse a member once; spent: iterations of its budget that are gone already."""
    setup, loss = set_up(member), None
    run = prepare(setup, jacking_stress(setup))
    run.rig.case.work.spent[:] = spent
    try:
        stress(run)
        if member.fpe is not None:
            run = stress_to_mean(run, member.fpe)
        loss = time_loss(anchored(run)) if takes_time(member) else None
        ended = serve(run, refine, loss)
    except stages.NoEquilibriumError as none:
        return stopped(run, none.stage, str(none), loss)
    return finished(run, ended, loss)


def prepare(setup: Setup, fpj: float) -> Run:
    """A member with its tendon slack in the duct, placed for the jacking stress."""
    losses = tendon_losses(vars(setup.member), fpj)
    case, start = laid_out(setup, losses, fpj)
    return Run(setup, stages.Rig.of(case, setup.live), start, losses, fpj)


def laid_out(setup: Setup, losses: Losses, fpj: float) -> tuple[Case, TendonStart]:
    """All arrays of an analysis, and where its tendon starts."""
    member, n = setup.member, len(setup.mesh.x) - 1
    arrays, state, ends, start = model(setup, losses)
    case = Case(
        arrays,
        state,
        ends,
        new_work(n, half_bandwidth(setup, start)),
        new_history(ROWS, n),
        Tolerance(
            1e-9,
            1e-3,
            1e-6,
            fpj * member.intact_area,
            max(member.h, member.total_length / n),  # short elements turn round-off into moments
            1e-3 * max(member.span),
            BUDGET,
        ),
    )
    return case, start


def stress(run: Run) -> None:
    """Stages 1 to 3."""
    member, weight = run.setup.member, run.setup.self_weight
    stages.jack(run.rig, run.fpj * member.intact_area, weight)
    stages.set_wedges(run.rig, member.set, weight)
    stages.anchor(run.rig, weight)


def jacking_stress(setup: Setup) -> float:
    """The jacking stress: as given, or what would leave the mean stress `fpe` on a rigid member."""
    member = setup.member
    if member.fpe is None:
        assert member.fpj is not None  # a Member has exactly one of the two
        return member.fpj
    return rigid_jacking_stress(setup, member.fpe)


def rigid_jacking_stress(setup: Setup, fpe: float) -> float:
    """The jacking stress that leaves the mean stress fpe on a rigid member."""
    member = setup.member
    return fpj_for_mean(setup.ideal, fpe, member.mu, member.K, member.Ep, member.set, member.jack)


def stress_to_mean(run: Run, wanted: float) -> Run:
    """Repeat stages 1 to 3 with the jacking stress moved (secant) until the mean stress after anchoring is
    as `wanted`."""
    before = rigid_jacking_stress(run.setup, 0.0), 0.0  # all of it is lost in the set
    for _ in range(8):
        mean = run.rig.mean_stress
        if abs(mean - wanted) <= FPE_TOLERANCE * wanted:
            return run
        if mean == before[1]:  # more will not help
            break
        fpj = run.fpj + (wanted - mean) * (run.fpj - before[0]) / (mean - before[1])
        before = run.fpj, mean
        again = prepare(run.setup, fpj)
        again.rig.case.work.spent[:] = run.rig.case.work.spent  # one budget for all of them
        run = again
        stress(run)
    raise stages.NoEquilibriumError(stages.JACKING, stages.NO_MEAN, 1.0)


def serve(run: Run, refine: float, loss: TimeLoss | None = None) -> int:
    """Sustained load, long-term losses if anything is known of them, live load; how it ended. Where a
    material is past its limit strain before the live load the member has failed: what lies beyond need not be
    found, and it gets no live load."""
    setup, member = run.setup, run.setup.member
    bonded = bool(member.bond == "bonded")
    dof = 5 * setup.mesh.control + 3
    control = Control(
        dof,
        float(run.rig.case.state.u[dof]),
        setup.mesh.sense,
        member.deflection_limit,
        member.deflection_limit / (400 * refine),
        member.deflection_limit / (40 * refine),
    )
    full = setup.self_weight + setup.sustained
    try:
        stages.sustain(run.rig, (setup.self_weight, full), bonded)
        if loss is not None and not run.rig.failed:
            lose(run.rig, full, loss, bonded)
    except stages.NoEquilibriumError:
        if not run.rig.failed:
            raise
    if run.rig.failed:
        return DONE
    return stages.load_to_failure(run.rig, full, setup.pattern, control, bonded)
