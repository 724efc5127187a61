"""What time takes of the tendon between the sustained and the live load."""

import numpy as np
import pytest

from ptbatch.ageing import lose
from ptbatch.analysis import analyse, jacking_stress, prepare, stress
from ptbatch.design.longterm import TimeLoss
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from ptbatch.response import ANCHORED, SERVICE
from ptbatch.tables import summary_row

BEAM = dict(
    member="B1", span=9000, b=300, h=600, fc=40, Aps=592, dp=(300, 500, 300), fpj=1300, As=603, ds=550,
    w_dead=5, w_live=10, elements=8, layers=12, deflection_limit=30,
)  # fmt: skip


@pytest.mark.parametrize("bond", ["unbonded", "bonded"])
def test_service_starts_from_the_effective_prestress(bond):
    """The mean stress has lost what was asked for, whatever the concrete gives back; the curve goes on from
    there."""
    without = analyse(Member(**BEAM, bond=bond))
    response = analyse(Member(**BEAM, bond=bond, long_term_loss=150))
    before = response.tendon[ANCHORED].mean
    assert before == pytest.approx(without.tendon[ANCHORED].mean, rel=1e-12)
    # the sustained load bends the member and stretches the tendon a little: that is not time's
    sustained = without.curve.stress_mean[np.flatnonzero(without.curve.factor == 0.0)[-1]]
    service = response.tendon[SERVICE].mean
    assert service == pytest.approx(sustained - 150.0, rel=1e-6)
    start = np.flatnonzero(response.curve.factor == 0.0)[-1]
    assert response.curve.stress_mean[start] == pytest.approx(service, rel=1e-9)
    assert SERVICE not in without.tendon
    assert response.event("cracking").load < without.event("cracking").load


def test_an_elastic_prism_grows_as_the_prestress_falls():
    """Closed form, a centric straight tendon: d P L / (Ec A), between the ends of the member."""
    plain = dict(
        member="P", span=10_000, b=300, h=300, fc=40, Aps=500, dp=150, profile="straight", fpj=1200, mu=0,
        K=0, set=0, self_weight=False, concrete_law="elastic", elements=4, layers=8, w_live=1,
    )  # fmt: skip
    member = Member(**plain)
    run = prepare(set_up(member), jacking_stress(set_up(member)))
    stress(run)
    before, u, loads = run.rig.mean_stress, run.rig.case.state.u, run.setup.self_weight
    short = u[5 * 4 + 2] - u[2]
    lose(run.rig, loads, TimeLoss({"lump sum": 200.0}, "", ""), bonded=False)
    assert before - run.rig.mean_stress == pytest.approx(200.0, rel=1e-6)
    grown = u[5 * 4 + 2] - u[2] - short
    assert grown == pytest.approx(200.0 * 500 * 10_000 / (member.Ec * 300 * 300), rel=2e-3)  # finite strains


def test_no_loss_is_a_loss_that_is_known():
    """Zero, given: the service state is there, and is the one under the sustained load."""
    response = analyse(Member(**BEAM, long_term_loss=0))
    start = np.flatnonzero(response.curve.factor == 0.0)[-1]
    assert response.tendon[SERVICE].mean == pytest.approx(response.curve.stress_mean[start], rel=1e-9)
    row = summary_row(response.member, response)
    assert row["stress_service_mean [MPa]"] == response.tendon[SERVICE].mean


def test_losses_by_time_need_no_standard():
    response = analyse(Member(**BEAM, RH=60))
    assert response.time_loss.clause.startswith("ACI 423.10R")
    assert set(response.time_loss.causes) == {"creep", "shrinkage", "relaxation"}
    assert analyse(Member(**BEAM, RH=60, standard="EN 1992-1-1")).time_loss.clause == "EN 1992-1-1 (5.46)"


def test_more_than_there_is_cannot_be_lost():
    response = analyse(Member(**BEAM, long_term_loss=1300))
    assert response.status == "not converged"
    assert "long-term losses: they exceed the stress of the tendon" in response.message
    checked = Member(**BEAM, long_term_loss=1300, standard="ACI 318-19")
    row = summary_row(checked, analyse(checked))
    assert {row[name] for name in ("checks", "stress_service_mean [MPa]")} == {"not converged: see message"}
