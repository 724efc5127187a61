"""One step of a stage: try it, look at it, accept it. What the stages call, and all that they call."""

from typing import NamedTuple

from ptbatch.core.history import History, HistoryRef, commit, record, rewind
from ptbatch.core.jit import kernel
from ptbatch.core.model import Ends, EndsRef, Model, ModelRef, State, StateRef
from ptbatch.core.newton import CONVERGED, FLAT, PLAIN, SEARCH, Target, Tolerance, equilibrate
from ptbatch.core.reference import reference
from ptbatch.core.work import Work, WorkRef


class Case(NamedTuple):
    """One analysis: the member, its committed state and what drives its ends, scratch and record."""

    model: Model
    state: State
    ends: Ends
    work: Work
    history: History
    tolerance: Tolerance


CaseRef = reference(Case, "CaseRef")


@kernel
def open_case(model, state, ends, work, history, tolerance):
    """The case as the functions below take it; it shares the arrays that it was given."""
    return CaseRef(
        ModelRef(*model), StateRef(*state), EndsRef(*ends), WorkRef(*work), HistoryRef(*history), tolerance
    )


@kernel
def find_equilibrium(case, fixed, pattern, dof, value, factor, bonded):
    """Look for equilibrium from the committed state (see `Target`); returns (status, factor, iterations,
    relative residual).

    Whole Newton steps first, which is all that most steps need; then searched ones, for friction that turns
    round; then without the negative stiffness of softening fibres, which leads on slowly but surely where
    cracks choose their places.
    """
    target = Target(fixed, pattern, dof, value)
    spent = 0
    for way in (PLAIN, SEARCH, FLAT):
        rewind(case.state, case.work)
        status, reached, iterations, residual = equilibrate(
            case.model, case.state, target, factor, case.ends, bonded, way, case.work, case.tolerance
        )
        spent += iterations
        if status == CONVERGED:
            break
    return status, reached, spent, residual


@kernel
def accept(case, stage, factor, iterations, residual):
    """Make the step that was tried last the committed state and record it."""
    commit(case.model, case.state, case.ends, case.work)
    record(stage, factor, iterations, residual, case.model.rest_length, case.work, case.history)
