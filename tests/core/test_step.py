"""One step: looking ahead, what it costs, and the budget of a whole analysis."""

import numpy as np
import pytest

from ptbatch import analysis
from ptbatch.core.case import Target
from ptbatch.core.follow import Control, follow
from ptbatch.core.newton import CONVERGED
from ptbatch.core.ramp import NO_BUDGET
from ptbatch.core.step import SPENT, WAYS, accept, find_equilibrium
from ptbatch.member import Member
from ptbatch.stages import LIVE
from ptbatch.tables import summary_row
from tests.members import KINDS, SMALL, anchored, sustained


class Loading:
    """A member under sustained load that is deflected step by step."""

    def __init__(self, values, steps=200):
        self.run = sustained(values)
        self.case, self.handle = self.run.rig.case, self.run.rig.handle
        setup = self.run.setup
        self.dof = 5 * setup.mesh.control + 3
        self.step = setup.mesh.sense * setup.member.deflection_limit / steps
        self.start, self.factor = self.case.state.u[self.dof], 0.0

    def target(self, steps) -> Target:
        setup = self.run.setup
        bonded = setup.member.bond == "bonded"
        full = setup.self_weight + setup.sustained
        return Target(full, setup.pattern, bonded, self.dof, -1, self.start + steps * self.step)

    def reach(self, steps, ahead=0.0):
        """(status, factor, iterations, imbalance) of a try, which is not accepted."""
        return find_equilibrium(self.handle, self.target(steps), self.factor, ahead)

    def accept(self, found):
        status, self.factor, iterations, error = found
        assert status == CONVERGED
        accept(self.handle, LIVE, self.factor, iterations, error)


@pytest.mark.parametrize("kind", ["imaginary", "cracked", "grouted", "fixed"])
def test_looking_ahead_saves_iterations_and_changes_nothing(kind):
    loading, spent = Loading(KINDS[kind]), np.zeros(2)
    work, force, live = loading.case.work, loading.case.tolerance.force, loading.run.setup.live_total
    for i in range(1, 13):
        plain = loading.reach(i)
        u, T = work.trial.copy(), work.T.copy()
        ahead = loading.reach(i, 1.0 if i > 2 else 0.0)
        # as near as the residual of 1e-9 lets them be
        assert abs(ahead[1] - plain[1]) * live <= 1e-9 * force
        np.testing.assert_allclose(work.T, T, atol=1e-9 * force)
        np.testing.assert_allclose(work.trial, u, atol=1e-8)  # mm
        spent += plain[2], ahead[2]
        loading.accept(ahead)
    # the imaginary beam takes three iterations a step either way
    assert spent[1] <= spent[0] - (0 if kind == "imaginary" else 4)


def test_looking_ahead_moves_the_trial_by_the_last_change():
    loading = Loading(SMALL)
    for i in (1, 2):
        loading.accept(loading.reach(i))
    history = loading.case.history
    last = history.rows[0] - 1
    change = history.u[last] - history.u[last - 1]
    assert change[loading.dof] == pytest.approx(loading.step, rel=1e-6)
    status, factor, iterations, _ = loading.reach(3, 1.0)
    expected = history.factor[last] + (history.factor[last] - history.factor[last - 1])
    # SMALL is all but linear here, so that its third step is where the first two point
    assert (status, iterations) == (CONVERGED, 2)
    assert factor == pytest.approx(expected, rel=0.02)
    expected = history.u[last] + change
    np.testing.assert_allclose(loading.case.work.trial, expected, atol=0.05 * abs(loading.step))


def test_a_try_that_fails_is_paid_for():
    loading = Loading(SMALL | dict(w_dead=45.0))
    work, rows = loading.case.work, loading.case.history.rows[0]
    before, state = work.spent[0], loading.case.state.u.copy()
    status, _, iterations, _ = loading.reach(1e6)  # no member deflects by kilometres
    assert status != CONVERGED and iterations >= len(WAYS)
    assert work.spent[0] == before + iterations
    assert loading.case.history.rows[0] == rows
    np.testing.assert_array_equal(loading.case.state.u, state)


def test_iterations_of_a_member_are_those_of_all_tries():
    """More than those of the accepted steps: this one tries steps that lead nowhere."""
    values = KINDS["cracked"] | dict(live="midspan")
    run = anchored(values)
    analysis.serve(run, 1)
    history = run.rig.case.history
    recorded = history.iterations[: history.rows[0]].sum()
    assert analysis.analyse(Member(**values)).newton_iterations == run.rig.case.work.spent[0] > recorded


def test_iterations_of_a_member_are_those_of_all_its_jackings():
    """A mean stress is met by jacking again; the last time alone costs what the stress it ends at costs."""
    mean = SMALL | dict(fpj=None, fpe=1000)
    response = analysis.analyse(Member(**mean))
    once = analysis.analyse(Member(**SMALL | dict(fpj=response.fpj)))
    assert response.event("peak").load == pytest.approx(once.event("peak").load, rel=1e-6)
    assert response.newton_iterations >= once.newton_iterations + 10


def test_no_try_is_begun_beyond_the_budget():
    loading = Loading(SMALL)
    work = loading.case.work
    work.spent[0] = loading.case.tolerance.budget
    assert loading.reach(1)[:3] == (SPENT, 0.0, 0)
    target = loading.target(0)
    control = Control(loading.dof, loading.start, np.sign(loading.step), 10.0, 0.1, 1.0)
    ended = follow(loading.handle, LIVE, target.fixed, target.pattern, control, False)
    assert ended == NO_BUDGET and work.spent[0] == loading.case.tolerance.budget


HEADERS = ("load_peak [kN]", "load_factor_peak", "moment_peak [kN m]", "failure", "failure_load [kN]")


@pytest.mark.parametrize(("budget", "stage"), [(1, "wedge set"), (5, "anchoring"), (40, "live load")])
@pytest.mark.parametrize("live", ["uniform", "midspan"])
def test_a_budget_that_is_spent_ends_without_a_capacity(monkeypatch, budget, stage, live):
    monkeypatch.setattr(analysis, "BUDGET", budget)
    response = analysis.analyse(Member(**SMALL | dict(live=live)))
    assert response.status == "not converged"
    assert response.message.startswith(f"{stage}: the iterations allowed did not lead beyond")
    row = summary_row(response.member, response)
    assert {row[header] for header in HEADERS} == {"not converged: see message"}
    assert response.newton_iterations >= budget


def test_every_budget_up_to_the_one_that_is_needed_ends_without_a_capacity(monkeypatch):
    """Wherever it runs out: a load that has fallen is not yet a peak."""
    member = Member(**KINDS["cracked"])
    whole = analysis.analyse(member)
    assert whole.status == "ok"
    failed = None
    for budget in np.linspace(5, whole.newton_iterations, 25).astype(int)[:-1]:
        monkeypatch.setattr(analysis, "BUDGET", int(budget))
        response = analysis.analyse(member)
        if response.failure:  # a material has reached its limit: what follows lends no capacity
            assert response.failure == whole.failure
            assert response.event("peak").load == pytest.approx(whole.event("peak").load, rel=1e-9)
            failed = failed or budget
        else:
            assert failed is None and response.status == "not converged"
            assert "iterations allowed" in response.message
