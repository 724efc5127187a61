"""One stage's end is the next one's start."""

import pytest
from numpy import average
from numpy.testing import assert_allclose

from ptbatch.analysis import analyse
from ptbatch.core.newton import SETTLED
from ptbatch.member import Member
from ptbatch.stages import ANCHORING, SETTING, sustain
from tests.members import KINDS, SMALL, anchored, last_row, sustained

any_member = pytest.mark.parametrize("values", KINDS.values(), ids=KINDS.keys())


@any_member
def test_nothing_moves_at_anchoring(values):
    run = anchored(values)
    history = run.rig.case.history
    before, after = last_row(run, SETTING), last_row(run, ANCHORING)
    assert after == before + 1
    assert_allclose(history.u[after], history.u[before], atol=1e-6)  # mm; the solver's increment
    assert_allclose(history.T[after], history.T[before], rtol=1e-7)
    assert_allclose(history.anchor[after], history.anchor[before], rtol=1e-6)


@any_member
def test_a_stage_that_asks_for_nothing_changes_nothing(values):
    run = sustained(values)
    loads = run.setup.self_weight + run.setup.sustained
    before = run.rig.case.state.u.copy()
    sustain(run.rig, (loads, loads), run.setup.member.bond == "bonded")
    history = run.rig.case.history
    assert_allclose(run.rig.case.state.u, before, atol=1e-6)
    # round-off may keep a node that lies just where two segments of its duct meet from coming to rest
    assert history.iterations[: history.rows[0]][-1] <= 2 + SETTLED


def test_the_curve_begins_in_the_anchored_state():
    run = anchored(SMALL | dict(w_dead=5.0))
    row = last_row(run, ANCHORING)
    tendon = run.rig.case.history.T[row] / run.setup.member.Aps
    response = analyse(Member(**SMALL | dict(w_dead=5.0)))
    curve = response.curve
    assert (curve.factor[0], curve.load[0], curve.deflection[0]) == (0.0, 0.0, 0.0)
    assert curve.stress_mean[0] == pytest.approx(average(tendon, weights=run.start.rest), rel=1e-9)
    assert response.tendon["anchored"].stress == pytest.approx(tendon, rel=1e-9)
