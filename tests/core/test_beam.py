"""Beam element in a deformed, cracked state: equilibrium, tangent, rigid rotation, history."""

import numpy as np
import pytest

from ptbatch.analysis import prepare
from ptbatch.core.beam import beam_forces, beam_tangent, commit_beam, section_forces
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from tests.core.numerics import central_jacobian, turned_by
from tests.members import ELASTIC, SMALL

E, LENGTH = 2, 1000.0  # element under test of the small member
# Shortened by 0.04 % and bent: the lower half has cracked, the bars and the top fibre are at work.
BENT = np.array([0.3, -2.0, -0.004, -0.1, -4.5, 0.003])
TURN = 0.8


def arrays(**more):
    """Model and state in their own classes: one of ours would end up in the compile cache of all users."""
    setup = set_up(Member(**SMALL | more))
    return prepare(setup, setup.member.fpj).rig.case[:2]


def fibre(model):
    """Scratch for the layers of a section."""
    return np.zeros((2, len(model.layer_y)))


def forces(model, state, d):
    f = np.zeros(6)
    beam_forces(E, model, state, d, fibre(model), f)
    return f


def tangent(model, state, d, damping=0.0):
    f, k = np.zeros(6), np.zeros((6, 6))
    beam_tangent(E, model, state, d, damping, fibre(model), f, k)
    return f, k


def cracked():
    """A state with history: bent further than now, then back."""
    model, state = arrays()
    commit_beam(E, model, state, BENT * 1.2)
    return model, state


def rotated(d, phi):
    one, two = np.array([d[0:2], d[3:5] + [LENGTH, 0.0]]) @ turned_by(phi).T
    return np.array([*one, d[2] + phi, two[0] - LENGTH, two[1], d[5] + phi])


def test_self_equilibrium():
    f = forces(*cracked(), BENT)
    x, y = np.array([BENT[0], BENT[3] + LENGTH]), BENT[[1, 4]]
    moment = (x * f[[1, 4]] - y * f[[0, 3]]).sum() + f[2] + f[5]
    assert np.abs(f).max() > 1e6
    np.testing.assert_allclose(
        [f[0] + f[3], f[1] + f[4], moment / LENGTH], 0.0, atol=1e-9
    )  # closed form, in N


@pytest.mark.parametrize("fresh", [True, False])
@pytest.mark.parametrize("phi", [0.0, TURN])
def test_tangent_is_the_central_difference(fresh, phi):
    model, state = arrays() if fresh else cracked()
    d = rotated(BENT, phi)
    f, exact = tangent(model, state, d)
    np.testing.assert_array_equal(f, forces(model, state, d))
    difference = central_jacobian(lambda p: forces(model, state, p), d, np.tile([1e-5, 1e-5, 1e-8], 2))
    scale = np.abs(exact).max(axis=0)
    # steps of 1e-8 of strain; a fibre whose law has a corner within that would show, none of these has
    np.testing.assert_allclose(difference / scale, exact / scale, atol=1e-6)
    np.testing.assert_allclose(exact, exact.T, atol=1e-9 * np.abs(exact).max())  # closed form: symmetric


@pytest.mark.parametrize("damping", [0.1, 1.0])
@pytest.mark.parametrize("phi", [0.0, TURN])
def test_damping_adds_its_share_of_the_uncracked_stiffness(damping, phi):
    model, state = cracked()
    d = rotated(BENT, phi)
    f, k = tangent(model, state, d)
    same, damped = tangent(model, state, d, damping)
    np.testing.assert_array_equal(f, same)
    plain = arrays(concrete_law="elastic", Ec=model.concrete.E0, As=0, ds=0, As_top=0, ds_top=0)
    at_rest = rotated(np.zeros(6), phi)
    uncracked = tangent(*plain, at_rest)[1]
    # the chord is 0.04 % shorter and 0.3 % off that of the element at rest
    np.testing.assert_allclose(damped - k, damping * uncracked, atol=3e-3 * damping * np.abs(uncracked).max())
    work = d - at_rest
    assert work @ (damped - k) @ work > 0.0


@pytest.mark.parametrize("phi", [TURN, -2.5])
def test_rigid_rotation_makes_no_force(phi):
    model, state = arrays()
    EA = model.layer_area.sum() * model.concrete.Ec
    # closed form: zero; 1e-13 of strain from round-off of the length
    np.testing.assert_allclose(forces(model, state, rotated(np.zeros(6), phi)), 0.0, atol=1e-10 * EA)


def test_rigid_rotation_turns_the_forces():
    model, state = cracked()
    f, after = forces(model, state, BENT), forces(model, state, rotated(BENT, TURN))
    expected = [*turned_by(TURN) @ f[:2], f[2], *turned_by(TURN) @ f[3:5], f[5]]
    np.testing.assert_allclose(after, expected, rtol=1e-9, atol=1e-9 * np.abs(f).max())


def test_elastic_stiffness_is_that_of_the_layers():
    model, state = arrays(**ELASTIC, As=0, ds=0, As_top=0, ds_top=0)
    _, k = tangent(model, state, np.zeros(6))
    EA = model.concrete.Ec * model.layer_area.sum()
    EI = model.concrete.Ec * (model.layer_area * model.layer_y**2).sum()
    assert k[0, 0] == pytest.approx(EA / LENGTH, rel=1e-12)  # closed form
    assert k[1, 1] == pytest.approx(12 * EI / LENGTH**3, rel=1e-12)
    assert (k[2, 2], k[2, 5]) == pytest.approx((4 * EI / LENGTH, 2 * EI / LENGTH), rel=1e-12)


def test_commit_changes_nothing_where_it_stands():
    model, state = arrays()
    f = forces(model, state, BENT)
    commit_beam(E, model, state, BENT)
    np.testing.assert_allclose(forces(model, state, BENT), f, rtol=1e-12)
    before = [array.copy() for array in (state.concrete, state.bar)]
    commit_beam(E, model, state, BENT)
    for old, new in zip(before, (state.concrete, state.bar), strict=True):
        np.testing.assert_allclose(new, old, rtol=1e-12, atol=1e-18)
    assert not state.concrete[:E].any() and not state.concrete[E + 1 :].any()


def test_cracked_element_is_softer_on_its_way_back():
    f, before = forces(*cracked(), 0.3 * BENT), forces(*arrays(), 0.3 * BENT)
    assert abs(f[2]) < 0.9 * abs(before[2])


def test_ruptured_bars_carry_nothing():
    model, state = arrays()
    at = 0.0, 1e-6, model, state.concrete[E, 0]
    plain = section_forces(*at, np.zeros(3), np.zeros(3), fibre(model))
    assert section_forces(*at, np.full(3, np.nan), model.bar_area[E], fibre(model)) == plain
    assert section_forces(*at, np.zeros(3), model.bar_area[E], fibre(model))[1] > plain[1] + 1e4
