"""A member that finds no equilibrium under live load is analysed again with other steps."""

from types import SimpleNamespace

import pytest

from ptbatch import analysis, stages
from ptbatch.analysis import OTHER_STEPS, analyse
from ptbatch.member import Member
from ptbatch.response import Response
from tests.members import SMALL


@pytest.fixture
def analysed(monkeypatch):
    """analysed(statuses, loaded) puts these outcomes in turn in place of the analysis: what `analyse` makes
    of them, and the steps that it asked for."""
    asked = []

    def replace_by(statuses, loaded=True):
        left = iter(statuses)

        def once(member, refine, spent=0):
            asked.append(refine)
            curve = SimpleNamespace() if loaded else None
            status = next(left)
            message = f"{status} at {refine:g}"
            return Response(member, status, message, 1e3, None, curve=curve, newton_iterations=spent + 10)

        monkeypatch.setattr(analysis, "through_the_stages", once)
        return analyse(Member(**SMALL), refine=2.0), asked

    return replace_by


def test_the_first_that_converges_counts(analysed):
    response, asked = analysed(["not converged", "ok"])
    assert (response.status, response.message) == ("ok", "ok at 2.2")
    assert asked == [2.0, 2.2]
    assert response.newton_iterations == 20  # all that were spent


def test_where_none_does_the_first_is_told(analysed):
    response, asked = analysed(["not converged"] * 3)
    assert (response.status, response.message) == ("not converged", "not converged at 2")
    assert asked == pytest.approx([2.0, *(2.0 * share for share in OTHER_STEPS)])
    assert response.newton_iterations == 30


@pytest.mark.parametrize("status", ["ok", "warning"])
def test_one_that_converges_is_analysed_once(analysed, status):
    assert analysed([status])[1] == [2.0]


def test_one_budget_is_for_all_of_them(monkeypatch):
    """The second analysis begins with what the first has spent, and ends as soon as there is none left."""

    def stuck(run, refine, loss):
        run.rig.case.work.spent[:] += analysis.BUDGET
        return stages.NO_BUDGET

    alone = analyse(Member(**SMALL)).newton_iterations
    monkeypatch.setattr(analysis, "serve", stuck)
    response = analyse(Member(**SMALL))
    assert response.status == "not converged" and response.curve is not None
    assert analysis.BUDGET < response.newton_iterations < analysis.BUDGET + alone


def test_one_that_is_never_loaded_is_analysed_once(analysed):
    assert analysed(["not converged"], loaded=False)[1] == [2.0]
