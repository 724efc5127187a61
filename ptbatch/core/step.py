"""One step of a stage: find it, check it, accept it."""

import numpy as np

from ptbatch.core.equilibrium import imbalance_as_evaluated
from ptbatch.core.history import commit, record, rewind
from ptbatch.core.jit import kernel
from ptbatch.core.newton import CONVERGED, Way, equilibrate, pulled

# What is tried in turn. Whole Newton steps are all that most steps need. A section that cracks at once may
# leave no equilibrium near by: damped steps lead on to the next one, slowly where they must. Searched steps
# are for what turns to and fro.
WAYS = (
    Way(20, 4, 0.0, 1.0, False),
    Way(40, 40, 0.2, 0.7, False),
    Way(30, 4, 0.0, 1.0, True),
)
# While a jack pulls, one tendon node may turn round after the other before the residual falls.
PULLING = Way(100, 40, 0.0, 1.0, False)
SPENT = 3  # a status beside those of `equilibrate`: the budget of iterations is used up
UNBALANCED = 4  # and: the iteration converged to what statics does not confirm


@kernel
def find_equilibrium(case, target, factor, ahead):
    """Look for equilibrium from the committed state; returns (status, factor, iterations, largest imbalance).

    ahead: of the last recorded change of displacements, what to start the first way with.
    """
    spent = 0
    status = SPENT
    reached = factor
    error = np.inf
    for k in range(len(WAYS)):
        if case.work.spent[0] >= case.tolerance.budget:
            return SPENT, factor, spent, np.inf
        rewind(case.state, case.work)
        guess = factor
        if k == 0 and ahead > 0.0:
            guess += extrapolate(ahead, case)
        way = PULLING if k == 0 and pulled(case.ends) else WAYS[k]
        status, reached, iterations, error = equilibrate(case, target, guess, way)
        spent += iterations
        case.work.spent[0] += iterations
        if status == CONVERGED:
            error = max(error, imbalance_as_evaluated(case, target, reached))
            if error <= case.tolerance.statics:
                return CONVERGED, reached, spent, error
            status = UNBALANCED
    return status, reached, spent, error


@kernel
def extrapolate(ahead, case):
    """Move the trial on by a share of the last change; returns that of the factor."""
    history, trial = case.history, case.work.trial
    last = history.rows[0] - 1
    for i in range(trial.size):
        trial[i] += ahead * (history.u[last, i] - history.u[last - 1, i])
    return ahead * (history.factor[last] - history.factor[last - 1])


@kernel
def accept(case, stage, factor, iterations, error):
    """Make the step that was tried last the committed state and record it."""
    commit(case.model, case.state, case.ends, case.work)
    record(stage, factor, iterations, error, case.work, case.history)
