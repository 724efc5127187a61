"""Beam element in a deformed, cracked state: equilibrium, tangent, rigid rotation, history."""

import numpy as np
import pytest

from ptbatch.analysis import prepare
from ptbatch.core.beam import beam_forces, beam_strains, beam_tangent
from ptbatch.core.jit import njit
from ptbatch.core.section import commit_sections, section_tangent
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from tests.core.numerics import central_jacobian, turned_by
from tests.members import ELASTIC, SMALL

E, LENGTH = 2, 1000.0  # element under test of the small member
# Shortened by 0.04 % and bent: the lower half has cracked, the bars and the top fibre are at work.
BENT = np.array([0.3, -2.0, -0.004, -0.1, -4.5, 0.003])
TURN = 0.8


def arrays(**more):
    """A member before it is stressed."""
    setup = set_up(Member(**SMALL | more))
    return prepare(setup, setup.member.fpj).rig


def placed(d):
    """Displacements of the member's nodes with the element under test at d."""
    u = np.zeros(5 * SMALL["elements"] + 7)
    u[5 * E + 2 : 5 * E + 5], u[5 * E + 7 : 5 * E + 10] = d[:3], d[3:]
    return u


@njit
def force_of(case, u, f):
    beam_strains(case.model, u, case.work)
    section_tangent(case.model, case.state, 0.0, case.work)
    beam_forces(E, case.work, f)


@njit
def tangent_of(case, u, damping, f, k):
    beam_strains(case.model, u, case.work)
    section_tangent(case.model, case.state, damping, case.work)
    beam_tangent(E, case.model, case.work, f, k)


@njit
def commit_at(case, u):
    beam_strains(case.model, u, case.work)
    commit_sections(case.model, case.state, case.work)


def forces(rig, d):
    f = np.zeros(6)
    force_of(rig.handle, placed(d), f)
    return f


def tangent(rig, d, damping=0.0):
    f, k = np.zeros(6), np.zeros((6, 6))
    tangent_of(rig.handle, placed(d), damping, f, k)
    return f, k


def cracked():
    """A state with history: bent further than now, then back."""
    rig = arrays()
    commit_at(rig.handle, placed(BENT * 1.2))
    return rig


def rotated(d, phi):
    one, two = np.array([d[0:2], d[3:5] + [LENGTH, 0.0]]) @ turned_by(phi).T
    return np.array([*one, d[2] + phi, two[0] - LENGTH, two[1], d[5] + phi])


def test_self_equilibrium():
    f = forces(cracked(), BENT)
    x, y = np.array([BENT[0], BENT[3] + LENGTH]), BENT[[1, 4]]
    moment = (x * f[[1, 4]] - y * f[[0, 3]]).sum() + f[2] + f[5]
    assert np.abs(f).max() > 1e6
    np.testing.assert_allclose(
        [f[0] + f[3], f[1] + f[4], moment / LENGTH], 0.0, atol=1e-9
    )  # closed form, in N


@pytest.mark.parametrize("fresh", [True, False])
@pytest.mark.parametrize("phi", [0.0, TURN])
def test_tangent_is_the_central_difference(fresh, phi):
    rig = arrays() if fresh else cracked()
    d = rotated(BENT, phi)
    _, exact = tangent(rig, d)
    difference = central_jacobian(lambda p: forces(rig, p), d, np.tile([1e-5, 1e-5, 1e-8], 2))
    scale = np.abs(exact).max(axis=0)
    # steps of 1e-8 of strain; a fibre whose law has a corner within that would show, none of these has
    np.testing.assert_allclose(difference / scale, exact / scale, atol=1e-6)
    np.testing.assert_allclose(exact, exact.T, atol=1e-9 * np.abs(exact).max())  # closed form: symmetric


@pytest.mark.parametrize("damping", [0.1, 1.0])
@pytest.mark.parametrize("phi", [0.0, TURN])
def test_damping_adds_its_share_of_the_uncracked_stiffness(damping, phi):
    rig = cracked()
    d = rotated(BENT, phi)
    f, k = tangent(rig, d)
    same, damped = tangent(rig, d, damping)
    np.testing.assert_array_equal(f, same)
    plain = arrays(concrete_law="elastic", Ec=rig.case.model.concrete.E0, As=0, ds=0, As_top=0, ds_top=0)
    at_rest = rotated(np.zeros(6), phi)
    uncracked = tangent(plain, at_rest)[1]
    # the chord is 0.04 % shorter and 0.3 % off that of the element at rest
    np.testing.assert_allclose(damped - k, damping * uncracked, atol=3e-3 * damping * np.abs(uncracked).max())
    work = d - at_rest
    assert work @ (damped - k) @ work > 0.0


@pytest.mark.parametrize("phi", [TURN, -2.5])
def test_rigid_rotation_makes_no_force(phi):
    rig = arrays()
    model = rig.case.model
    EA = model.layer_area.sum() * model.concrete.Ec
    # closed form: zero; 1e-13 of strain from round-off of the length
    np.testing.assert_allclose(forces(rig, rotated(np.zeros(6), phi)), 0.0, atol=1e-10 * EA)


def test_rigid_rotation_turns_the_forces():
    rig = cracked()
    f, after = forces(rig, BENT), forces(rig, rotated(BENT, TURN))
    expected = [*turned_by(TURN) @ f[:2], f[2], *turned_by(TURN) @ f[3:5], f[5]]
    np.testing.assert_allclose(after, expected, rtol=1e-9, atol=1e-9 * np.abs(f).max())


def test_elastic_stiffness_is_that_of_the_layers():
    rig = arrays(**ELASTIC, As=0, ds=0, As_top=0, ds_top=0)
    model = rig.case.model
    _, k = tangent(rig, np.zeros(6))
    EA = model.concrete.Ec * model.layer_area.sum()
    EI = model.concrete.Ec * (model.layer_area * model.layer_y**2).sum()
    assert k[0, 0] == pytest.approx(EA / LENGTH, rel=1e-12)  # closed form
    assert k[1, 1] == pytest.approx(12 * EI / LENGTH**3, rel=1e-12)
    assert (k[2, 2], k[2, 5]) == pytest.approx((4 * EI / LENGTH, 2 * EI / LENGTH), rel=1e-12)


def test_commit_changes_nothing_where_it_stands():
    rig = arrays()
    state, u = rig.case.state, placed(BENT)
    f = forces(rig, BENT)
    commit_at(rig.handle, u)
    np.testing.assert_allclose(forces(rig, BENT), f, rtol=1e-12)
    before = [array.copy() for array in (state.concrete, state.bar)]
    commit_at(rig.handle, u)
    for old, new in zip(before, (state.concrete, state.bar), strict=True):
        np.testing.assert_allclose(new, old, rtol=1e-12, atol=1e-18)
    beside = 2 * (E - 1), 2 * (E + 2)  # the sections of this element and of those that share its nodes
    assert not state.concrete[..., : beside[0]].any() and not state.concrete[..., beside[1] :].any()


def test_cracked_element_is_softer_on_its_way_back():
    f, before = forces(cracked(), 0.3 * BENT), forces(arrays(), 0.3 * BENT)
    assert abs(f[2]) < 0.9 * abs(before[2])


def test_ruptured_bars_carry_nothing():
    rig, d = arrays(), np.array([0.0, 0.0, -1e-3, 0.0, 0.0, 1e-3])
    bars = forces(rig, d)
    rig.case.state.bar[:] = np.nan
    ruptured = forces(rig, d)
    np.testing.assert_array_equal(tangent(rig, d)[0], ruptured)
    rig.case.state.bar[:] = 0.0
    rig.case.model.bar_area[:] = 0.0
    np.testing.assert_array_equal(forces(rig, d), ruptured)
    assert bars[5] > ruptured[5] + 1e4
