"""Jacking: one step from slack whichever end is live; two jacks pull alike, the tendon rests between."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.analysis import prepare
from ptbatch.core.contact import EXPECTED_BACKWARD, EXPECTED_FORWARD, GROUTED
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from ptbatch.stages import JACKING, jack
from tests.members import IMAGINARY, KINDS, SMALL, TWENTY, closed_form, jacked, specimen, stations

LOPSIDED = TWENTY | dict(dp=(300, 900, 500))
REAL = dict(Ec=35000)
MEMBERS = {
    "rigid": LOPSIDED,
    "real": LOPSIDED | REAL,
    "harped": LOPSIDED | REAL | dict(profile="harped", harp=(1 / 3, 2 / 3)),
    "straight but for its camber": TWENTY | REAL | dict(profile="straight", dp=700, K=0.0),
    "wobble alone": LOPSIDED | REAL | dict(mu=0.0),
    "two spans": specimen(22, 3.18) | dict(span=(7620, 7000)),
    "polygon": IMAGINARY | dict(dp=(508, 787, 300), sheathing="polygon"),
    "fixed": KINDS["fixed"],
}
any_member = pytest.mark.parametrize("values", MEMBERS.values(), ids=MEMBERS.keys())


@any_member
def test_two_jacks_pull_alike_in_one_step(values):
    run = jacked(values | dict(jack="both"))
    history = run.rig.case.history
    assert history.rows[0] == 1
    assert_allclose(history.anchor[0], run.fpj * run.setup.member.Aps, rtol=1e-8)


@any_member
def test_the_tendon_moves_out_on_both_sides_of_where_it_rests(values):
    run = jacked(values | dict(jack="both"))
    work, contact = run.rig.case.work, run.rig.case.model.contact
    moved = work.s - run.start.s
    out = np.concatenate([-moved[:1], moved[1:]])  # a left end's arc length falls as it comes out
    (rest,) = np.flatnonzero(work.motion == GROUTED)
    assert (moved[1:rest] < 0.0).all() and (moved[rest + 1 :] > 0.0).all() and out[0] > 0.0
    mean = 0.5 * (work.T[1:] + work.T[:-1])
    capacity = contact.mu * np.abs(work.normal[1:-1]) + work.rough[1:-1] * mean
    share = work.shear[1:-1] / run.rig.case.tolerance.force
    limit = capacity / run.rig.case.tolerance.force
    # closed form: Coulomb's law, all of it where the tendon slides
    assert abs(share[rest - 1]) <= limit[rest - 1] + 1e-8
    assert_allclose(share[: rest - 1], -limit[: rest - 1], atol=1e-7)
    assert_allclose(share[rest:], limit[rest:], atol=1e-7)
    just = abs(share[rest - 1]) == pytest.approx(limit[rest - 1], rel=1e-3)
    assert just or moved[rest] == pytest.approx(0.0, abs=0.05)  # mm, the friction spring's


def jacked_from(values, shift):
    """The member after jacking, where it is expected to rest that many nodes beside the usual one."""
    setup = set_up(Member(**values | dict(jack="both")))
    run = prepare(setup, setup.member.fpj)
    motion = run.rig.case.state.motion
    rest = int(np.flatnonzero(motion == GROUTED)[0]) + shift
    motion[:rest], motion[rest], motion[rest + 1 :] = EXPECTED_BACKWARD, GROUTED, EXPECTED_FORWARD
    jack(run.rig, run.fpj * setup.member.Aps, setup.self_weight)
    return run


@pytest.mark.parametrize("shift", [-4, 2, 5])
@pytest.mark.parametrize("name", ["rigid", "real", "two spans", "polygon"])
def test_where_it_is_expected_to_rest_does_not_matter(name, shift):
    usual, other = (jacked_from(MEMBERS[name], by).rig.case for by in (0, shift))
    assert_allclose(other.work.T, usual.work.T, rtol=1e-9)
    assert_allclose(other.state.u, usual.state.u, atol=1e-6)
    assert other.work.spent[0] > usual.work.spent[0]


@pytest.mark.parametrize("values", [TWENTY, TWENTY | REAL, IMAGINARY, SMALL], ids="abcd")
@pytest.mark.parametrize("elements", [6, 20])
def test_the_tendon_of_a_symmetric_member_lies_symmetrically(values, elements):
    """No node stands in its middle: either of the two beside it could rest, so that both slide."""
    run = jacked(values | dict(jack="both", elements=elements))
    work, u = run.rig.case.work, run.rig.case.state.u
    assert_allclose(work.T, work.T[::-1], rtol=1e-7)
    assert u[0] - run.start.gap[0] == pytest.approx(u[-2] - run.start.gap[1], rel=1e-4)


def test_without_friction_two_ends_share_the_elongation():
    run = jacked(TWENTY | dict(jack="both", mu=0.0, K=0.0))
    left, right = run.rig.case.state.u[[0, -2]] - run.start.gap
    assert left == pytest.approx(right, rel=0.1)  # a node beside the middle rests, of 20
    assert_allclose(stations(run, JACKING)[1], 1239.0, rtol=1e-8)  # closed form


@pytest.mark.parametrize("elements", [20, 60])
def test_two_jacks_leave_the_closed_form(elements):
    run = jacked(LOPSIDED | dict(jack="both", elements=elements))
    x, stress = stations(run, JACKING)
    assert_allclose(stress, closed_form(run).stress_jacked(x), atol=1.5)  # closed form, the issue's


@pytest.mark.parametrize(
    "values", [SMALL, specimen(22, 3.18), IMAGINARY, LOPSIDED], ids=lambda v: v["member"]
)
@pytest.mark.parametrize("jack", ["left", "right", "both"])
def test_jacking_converges_at_once_from_whatever_end(values, jack):
    """A slack tendon's tensions are round-off, which must not decide how it starts."""
    run = jacked(values | dict(jack=jack))
    assert run.rig.case.history.rows[0] == 1
    assert run.rig.case.work.spent[0] <= 12


@pytest.mark.parametrize("span", [3000, 4390, 7330, 12910, 29300])
@pytest.mark.parametrize("harp", [(1 / 3, 2 / 3), (0.4, 0.6), (0.1, 0.7)])
def test_the_duct_of_a_harped_tendon_is_straight_between_its_kinks(span, harp):
    """Closed form; a kink is where its node is, but for round-off."""
    harped = SMALL | dict(span=span, profile="harped", live="third-points")
    for shares in (harp, tuple(1.0 - share for share in harp[::-1])):
        duct = set_up(Member(**harped | dict(harp=shares))).duct
        chord = np.diff(duct.y) / np.diff(duct.x)
        assert_allclose(duct.slope, np.column_stack([chord, chord]), atol=1e-9)
