"""Equilibrium of whole members: nodal deflections, reactions, section moments."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.analysis import serve
from ptbatch.member import Load
from ptbatch.model.beam_theory import nodal_loads
from ptbatch.stages import ANCHORING, LIVE, SUSTAINED
from ptbatch.statics import node_values, section_moments
from tests.members import ELASTIC, KINDS, SMALL, TWENTY, anchored, last_row, sustained

B, H, L, E, LAYERS = 300.0, 600.0, 9000.0, 30000.0, 100
EI = E * B * H**3 / 12.0 * (1.0 - 1.0 / LAYERS**2)  # closed form, of the layers' centres
# A tendon that is hardly there, and loads for deflections of hundredths of a millimetre: the linear limit.
BARE = ELASTIC | dict(
    member="bare", span=L, b=B, h=H, fc=30, Ec=E, layers=LAYERS, Aps=1.0, fpj=1.0, set=0.0, mu=0.0, K=0.0,
    profile="straight", dp=H / 2, elements=9,
)  # fmt: skip
P, W = 100.0, 0.02
POINT = Load("dead", "point", L / 3, L / 3, P)


def uniform(x):
    return W * x / (24 * EI) * (L**3 - 2 * L * x**2 + x**3)


def point(x):
    a, b = L / 3, 2 * L / 3
    left = P * b * x / (6 * EI * L) * (L**2 - b**2 - x**2)
    return np.where(x <= a, left, P * a * (L - x) / (6 * EI * L) * (2 * L * x - a**2 - x**2))


def fixed_fixed(x):
    return W * x**2 * (L - x) ** 2 / (24 * EI)


def cantilever(x):
    return W * x**2 / (24 * EI) * (6 * L**2 - 4 * L * x + x**2)


def two_spans(x):
    x = np.minimum(x, 2 * L - x)
    return W * x / (48 * EI) * (L**3 - 3 * L * x**2 + 2 * x**3)


CASES = {
    "simple, uniform": (dict(w_dead=W), uniform),
    "simple, point": (dict(loads=(POINT,)), point),
    "fixed": (dict(support_left="fixed", support_right="fixed", w_dead=W), fixed_fixed),
    "cantilever": (dict(support_left="fixed", support_right="free", w_dead=W), cantilever),
    "two spans": (dict(span=(L, L), w_dead=W), two_spans),
}


@pytest.mark.parametrize("case", CASES)
def test_elastic_deflections_are_exact_at_the_nodes(case):
    values, deflection = CASES[case]
    run = sustained(BARE | values)
    history, x = run.rig.case.history, run.setup.mesh.x
    before, after = last_row(run, ANCHORING), last_row(run, SUSTAINED)
    down = node_values(history.u[before] - history.u[after], len(x), 1)
    exact = deflection(x)  # closed form, beam theory
    assert_allclose(down, exact, rtol=1e-5, atol=1e-5 * exact.max())


@pytest.mark.parametrize(
    ("start", "end"), [(0.0, 10.0), (1.0, 6.0), (0.5, 0.75), (2.0, 2.5), (5.5, 10.0), (0.0, 1.0)]
)
def test_nodal_loads_of_a_part_of_the_member(start, end):
    """Closed form: force, moment and the shares of a whole element, wherever the load begins and ends."""
    x = np.array([0.0, 1.0, 3.0, 6.0, 10.0])
    nodal = nodal_loads(x, [Load("live", "uniform", start, end, 7.0)])
    size = 7.0 * (end - start)
    assert nodal[:, 0].sum() == pytest.approx(-size)
    assert (nodal[:, 0] * x + nodal[:, 1]).sum() == pytest.approx(-size * 0.5 * (start + end))
    if (start, end) == (0.0, 1.0):  # all of the first element, whose ends would be held by q h^2 / 12
        assert_allclose(nodal[:2], [[-3.5, -7.0 / 12.0], [-3.5, 7.0 / 12.0]])
    assert not nodal[x > x[np.searchsorted(x, end)]].any() and not nodal[x < x[x <= start].max()].any()
    middle = 0.3 * start + 0.7 * end
    parts = [Load("live", "uniform", start, middle, 7.0), Load("live", "uniform", middle, end, 7.0)]
    assert_allclose(nodal_loads(x, parts), nodal, atol=1e-13 * size)


def reactions(run, row, loads):
    """(horizontal, vertical, moment) (nodes,) of the supports: what the elements take less the loads."""
    missing, nodes = run.rig.case.history.f[row] - loads, len(run.setup.mesh.x)
    return [node_values(missing, nodes, i) for i in range(3)]


any_member = pytest.mark.parametrize("values", KINDS.values(), ids=KINDS.keys())


@any_member
def test_reactions_carry_the_loads(values):
    run = sustained(values)
    row, setup = last_row(run, SUSTAINED), run.setup
    loads = setup.self_weight + setup.sustained
    across, up, turn = reactions(run, row, loads)
    total = -node_values(loads, len(setup.mesh.x), 1).sum()
    tolerance = 1e-6 * run.fpj * setup.member.Aps  # what the solver leaves at each of some dozen nodes
    assert up.sum() == pytest.approx(total, abs=tolerance)  # closed form: equilibrium
    assert across.sum() == pytest.approx(0.0, abs=tolerance)
    held = run.rig.case.model.held
    for i, forces in enumerate((across, up, turn)):
        free = ~node_values(held, len(setup.mesh.x), i)
        assert np.abs(forces[free]).max() <= tolerance * (500.0 if i == 2 else 1.0)


@any_member
def test_reactions_to_the_tendon_balance_each_other(values):
    run = anchored(values)
    row, setup = last_row(run, ANCHORING), run.setup
    _, up, turn = reactions(run, row, setup.self_weight)
    x = setup.mesh.x + node_values(run.rig.case.history.u[row], len(setup.mesh.x), 0)
    weight = -node_values(setup.self_weight, len(setup.mesh.x), 1)
    # closed form: forces and moments of weight and reactions balance, whatever the tendon does inside
    assert up.sum() == pytest.approx(weight.sum(), rel=1e-6)
    moment = (up - weight) @ x + turn.sum() + node_values(setup.self_weight, len(x), 2).sum()
    assert moment == pytest.approx(0.0, abs=1e-5 * weight.sum() * x[-1])


def test_a_free_member_has_no_moment_from_its_tendon_alone():
    """Closed form: statically determinate, no load, so that no outside force bends it."""
    run = anchored(TWENTY | dict(Ec=30000.0))
    history, row = run.rig.case.history, last_row(run, ANCHORING)
    moments = section_moments(run.setup.mesh.x, history.u[row], history.f[row])
    assert np.abs(moments).max() <= 1e-6 * 1239 * 2850 * 558


def test_live_load_and_reactions_agree_to_the_end_of_the_curve():
    run = sustained(SMALL)
    serve(run, 1)
    history, setup = run.rig.case.history, run.setup
    rows = np.flatnonzero(history.stage[: history.rows[0]] == LIVE)
    assert len(rows) > 30
    for row in rows[::5]:
        loads = setup.self_weight + history.factor[row] * setup.pattern
        _, up, _ = reactions(run, row, loads)
        applied = -node_values(loads, len(setup.mesh.x), 1).sum()
        assert up.sum() == pytest.approx(applied, rel=1e-5)  # closed form: equilibrium
