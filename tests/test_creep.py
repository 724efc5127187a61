"""Concrete that creeps and shrinks while time takes its part of the tendon's stress: closed form."""

import numpy as np
import pytest

from ptbatch import stages
from ptbatch.ageing import lose
from ptbatch.analysis import analyse, jacking_stress, prepare, stress
from ptbatch.core.failure import CRACK_SCALE, CRACKING, demands
from ptbatch.core.ramp import NO_ROOM
from ptbatch.design.longterm import TimeLoss, ec2
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from ptbatch.postprocess import recorded
from ptbatch.response import SERVICE
from ptbatch.stages import TIME, NoEquilibriumError
from tests.test_time import BEAM

# A tendon that stays straight: no friction, no set, no weight
PLAIN = dict(
    member="P", span=10_000, b=300, h=500, fc=40, Aps=800, dp=250, profile="straight", fpj=1200, mu=0, K=0,
    set=0, self_weight=False, concrete_law="elastic", elements=4, layers=40, w_live=1, deflection_limit=50,
)  # fmt: skip
H, A, INERTIA, AP, L = 500.0, 150e3, 300 * 500**3 / 12, 800.0, 10_000.0
PHI, SHRUNK, LOSS = 2.0, 4e-4, 120.0


def loss(total=LOSS, phi=PHI, shrunk=SHRUNK):
    return TimeLoss({"in all": total}, "", "", phi, shrunk)


def stressed(**values):
    member = Member(**PLAIN | values)
    setup = set_up(member)
    run = prepare(setup, jacking_stress(setup))
    stress(run)
    return member, run


def after(run, what, bonded=False):
    """Take what time takes, under no load."""
    lose(run.rig, run.setup.self_weight, what, bonded)


def test_a_centric_prism_shortens():
    """Creep by the whole coefficient for the first stress and by 0.8 of it for what comes off."""
    member, run = stressed()
    u, end = run.rig.case.state.u, 5 * 4 + 2
    before, short = run.rig.mean_stress, u[end] - u[2]
    pressed, less = before * AP / A, LOSS * AP / A
    after(run, loss())
    assert before - run.rig.mean_stress == pytest.approx(LOSS, rel=1e-5)
    strain = SHRUNK + PHI / member.Ec * (pressed - 0.8 * less) - less / member.Ec
    assert short - (u[end] - u[2]) == pytest.approx(strain * L, rel=2e-3)  # finite strains
    assert run.rig.concrete_stress()[0] == pytest.approx(-(pressed - less), rel=1e-3)


def test_the_tendon_is_left_with_the_relaxation_of_546():
    """(5.46) is the closed form of such a prism: beside the concrete nothing but 0.8 of the relaxation."""
    member, run = stressed()
    pressed, relaxed = run.rig.mean_stress * AP / A, 50.0
    found = ec2.losses(pressed, member.Ep, member.Ec, AP, A, INERTIA, 0.0, PHI, SHRUNK, relaxed)
    rest = run.rig.case.model.rest_length.copy()
    after(run, found)
    grown = float(np.mean(run.rig.case.model.rest_length / rest - 1.0)) * member.Ep
    assert grown == pytest.approx(0.8 * relaxed, abs=member.fpj / member.Ep * found.total)  # finite strains
    assert found.total > 180.0


def test_bars_take_over_from_the_concrete():
    """Constant moment, bars near the soffit: two equations for strain and curvature, with the concrete's
    age-adjusted modulus."""
    e, As, depth = 120.0, 1500.0, 450.0
    member, run = stressed(dp=H / 2 + e, As=As, ds=depth)
    Es, E, y = member.Es, member.Ec, H / 2 - depth  # y up
    P = run.rig.mean_stress * AP

    def plane(modulus, N, M):
        """(eps0, kappa) of concrete of this modulus with the bars; y up, sagging positive."""
        S = -y * Es * As
        return np.linalg.solve([[modulus * A + Es * As, S], [S, modulus * INERTIA + y * y * Es * As]], [N, M])

    eps, kappa = plane(E, -P, -P * e)
    before = run.rig.case.state.u[5 * 2 + 3]
    assert before == pytest.approx(-kappa * L**2 / 8, rel=5e-3)
    aged = E / (1 + 0.8 * PHI)
    free = PHI * eps - SHRUNK, PHI * kappa
    d_eps, d_kappa = plane(aged, LOSS * AP + aged * A * free[0], LOSS * AP * e + aged * INERTIA * free[1])
    after(run, loss())
    assert run.rig.case.state.u[5 * 2 + 3] == pytest.approx(-(kappa + d_kappa) * L**2 / 8, rel=5e-3)
    heights = run.rig.case.model.layer_y
    now = E * (eps - heights * kappa) + aged * (d_eps - free[0] - heights * (d_kappa - free[1]))
    found = run.rig.concrete_stress()[0]
    assert found[:, 2] == pytest.approx(now, abs=0.01)
    assert now[-1] > E * (eps - heights[-1] * kappa) + 1.5  # the soffit has lost much of its compression


def test_creep_alone_makes_no_secondary_moments():
    """Two spans of one concrete: reactions fall as the tendon's force does."""
    member, run = stressed(
        span=(10_000, 10_000), dp=(250, 370, 130, 370, 250), profile="parabola", elements=8
    )
    history, middle = run.rig.case.history, 5 * 8 + 3
    before, force = history.f[history.rows[0] - 1, middle], run.rig.mean_stress
    after(run, loss(shrunk=0.0))
    now = history.f[history.rows[0] - 1, middle]
    assert abs(before) > 9e3
    assert now / before == pytest.approx(run.rig.mean_stress / force, rel=5e-3)


def test_time_is_one_step_of_the_record():
    _, run = stressed()
    history = run.rig.case.history
    rows, spent = int(history.rows[0]), history.iterations[: history.rows[0]].sum()
    after(run, loss())
    assert history.rows[0] == rows + 1 and history.stage[rows] == stages.TIME
    assert history.u[rows] == pytest.approx(run.rig.case.state.u)
    assert history.iterations[rows] > 4 and run.rig.case.work.spent[0] >= spent + history.iterations[rows]


def test_what_the_concrete_does_by_itself_is_no_demand():
    """Shrinkage that nothing holds back neither crushes nor cracks, whatever the depth it is told at; strain
    that is held back cracks."""
    member, run = stressed(concrete_law="hognestad")
    case, layers = run.rig.case, run.rig.case.model.layer_y
    before = demands(run.rig.handle, case.state.u)[0]
    bend = 1e-3 * layers / H
    run.rig.own_strain[:] = bend[:, None]
    held = demands(run.rig.handle, case.state.u)[0]
    assert held[CRACKING] - before[CRACKING] == pytest.approx(0.5e-3 / CRACK_SCALE, rel=1e-6)
    steps = recorded(run, slice(int(case.history.rows[0])))
    steps.aged[-1] = True
    plain = recorded(run, slice(int(case.history.rows[0])))
    change = steps.face_strain()[:, -1] - plain.face_strain()[:, -1]
    assert change == pytest.approx(np.broadcast_to([[[-0.5e-3]], [[0.5e-3]]], change.shape))
    assert steps.layer_strain(slice(-1, None))[0] == pytest.approx(
        plain.layer_strain(slice(-1, None))[0] - bend
    )


@pytest.mark.parametrize("bond", ["unbonded", "bonded"])
@pytest.mark.parametrize("standard", ["ACI 318-19", "EN 1992-1-1"])
def test_a_beam_with_bars_cracks_earlier(bond, standard):
    """By more than the loss alone makes: bars have taken compression over. Its strength hardly changes."""
    beam = BEAM | dict(bond=bond, standard=standard, RH=50, deflection_limit=250)
    whole = analyse(Member(**beam))
    alone = analyse(Member(**beam, long_term_loss=whole.time_loss.total))
    assert whole.failure == alone.failure == "concrete crushing"
    assert whole.tendon[SERVICE].mean == pytest.approx(alone.tendon[SERVICE].mean, rel=2e-6)
    cracking, peak = ([r.event(name).load for r in (whole, alone)] for name in ("cracking", "peak"))
    assert 0.80 * cracking[1] < cracking[0] < 0.97 * cracking[1]
    assert peak[0] == pytest.approx(peak[1], rel=0.02)


def test_a_member_that_is_held_lengthwise_is_told_so(monkeypatch):
    """Whether shrinkage finds equilibrium between two fixed ends depends on the member: here it does not."""

    def none(*_):
        raise NoEquilibriumError(TIME, NO_ROOM, 0.0)

    fixed = dict(span=(6000, 6000), dp=(150, 300, 150, 300, 150), support_left="fixed", support_right="fixed")
    values = BEAM | fixed | dict(As=0, Aps=100, w_dead=0, w_live=2, h=400)
    assert analyse(Member(**values, long_term_loss=100)).status == "ok"
    monkeypatch.setattr("ptbatch.analysis.lose", none)
    response = analyse(Member(**values, RH=40))
    assert response.status == "not converged"
    assert "its supports hold the member lengthwise, so that shrinkage cracks it through" in response.message
    assert "of the stage" not in response.message
    response = analyse(Member(**values, long_term_loss=100))
    assert response.status == "not converged" and "lengthwise" not in response.message
