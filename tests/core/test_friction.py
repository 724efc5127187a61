"""Friction at one tendon node: Coulomb's law, the kink formula and what the correction force is for."""

import numpy as np
import pytest

from ptbatch.core.contact import (
    BACKWARD,
    EXPECTED_BACKWARD,
    EXPECTED_FORWARD,
    FORWARD,
    GROUTED,
    HELD,
    STICKING,
    UNKNOWN,
    Segment,
    contact_forces,
    friction,
    masters,
    project,
)
from ptbatch.core.model import Contact
from tests.core.numerics import central_jacobian

MU, STIFF = 0.3, 1e5
SEGMENTS = {
    "polygon": Segment(500.0, 0.0, 0.0, 0.0, 0.0, 0.0, 500.0, False),
    "smooth": Segment(500.0, 0.0, 0.0, 0.05, -0.05, 0.0, 500.4, True),
}
LAW = Contact(STIFF, STIFF, 1e6, MU, 0.0, True, True)


def slide(slip, rub=0.0, N=1000.0, T=0.0, rough=0.0, was=UNKNOWN):
    """(friction force, motion)."""
    return friction(slip, rub, N, T, rough, was, LAW)


def force(*args, **kwargs):
    return slide(*args, **kwargs)[0]


def node(theta, slip, T1=1e6, T2=1e6, gap=-2.0, mu=MU, corrected=True, lean=0.0, duct="polygon"):
    """(left and right unit chord, force on the duct's spring) of a slave off its segment by the gap; the
    chords turn down by theta."""
    c = Contact(STIFF, STIFF, 1e6, mu, 0.0, True, corrected)
    left, right = lean + 0.5 * theta, lean - 0.5 * theta
    chords = np.array([[np.cos(left), np.sin(left)], [np.cos(right), np.sin(right)]])
    seg = SEGMENTS[duct]
    q = np.zeros(8)
    q[:2] = 250.0, gap + (500.0 / 8 * 0.1 if duct == "smooth" else 0.0)
    duct_x, duct_y = masters(q, (1.0, 0.0), (1.0, 0.0), seg)
    xi, f = project(q, duct_x, duct_y, 0.5, seg), np.zeros(8)
    s0 = seg.s + xi * seg.ds - slip
    unit = tuple(chords[0]), tuple(chords[1])
    contact_forces(q, duct_x, duct_y, xi, *unit, T1, T2, s0, 0.0, 0.0, UNKNOWN, seg, c, f)
    return chords, f[:2]


def tensions(theta, slip, T1=1e6, **values):
    """T1, T2 left and right of a node in equilibrium: T2 and the gap that its duct needs for it, to which
    the forces are in proportion."""

    def missing(z):
        chords, f = node(theta, slip, T1, z[0], z[1], **values)
        return f + T1 * chords[0] - z[0] * chords[1]

    z, step = np.array([T1, -T1 * theta / STIFF]), np.array([1e3, 1e-3])
    for _ in range(2):  # the second time to take off the round-off
        z -= np.linalg.solve(central_jacobian(missing, z, step), missing(z))
    assert np.abs(missing(z)).max() <= 1e-7
    return T1, z[0]


@pytest.mark.parametrize("duct", SEGMENTS)
@pytest.mark.parametrize("lean", [0.0, 0.01, -0.02])
@pytest.mark.parametrize("theta", [0.002, 0.05, 0.4])
@pytest.mark.parametrize("slip", [1e6, -1e6])
def test_a_kink_takes_its_share_of_the_tension(theta, slip, lean, duct):
    T1, T2 = tensions(theta, slip, lean=lean, duct=duct)
    m = MU * np.tan(0.5 * theta)
    less_over_more = (1.0 - m) / (1.0 + m)  # closed form; sliding right the tension grows to the right
    assert T1 / T2 == pytest.approx(less_over_more if slip > 0.0 else 1.0 / less_over_more, rel=1e-12)


@pytest.mark.parametrize("lean", [0.0, 0.01, -0.02])
def test_correction_lets_a_frictionless_kink_pass_the_tension_on(lean):
    T1, T2 = tensions(0.05, 1e6, mu=0.0, lean=lean)
    assert T1 == pytest.approx(T2, rel=1e-12)  # closed form: the force is along the bisector


def test_without_correction_a_leaning_kink_does_not():
    T1, T2 = tensions(0.05, 1e6, mu=0.0, lean=0.01, corrected=False)
    # closed form: the force along the duct's normal, T1 cos(lean + theta/2) = T2 cos(lean - theta/2)
    assert T1 / T2 == pytest.approx(np.cos(0.01 - 0.025) / np.cos(0.01 + 0.025), rel=1e-12)
    assert abs(T1 / T2 - 1.0) > 4e-4
    T1, T2 = tensions(0.05, 1e6, mu=0.0, lean=0.0, corrected=False)
    assert T1 == pytest.approx(T2, rel=1e-12)  # level with the duct there is nothing to correct


def test_corrected_force_keeps_its_part_across_the_duct():
    """Eqs (18)-(20): P_n n + P_cor t with P_cor = P_n tan(alpha)."""
    _, f = node(0.05, 1e6, mu=0.0, lean=0.01)
    assert f[1] == pytest.approx(-2.0 * STIFF, rel=1e-12)  # closed form: P_n, penalty times gap
    assert abs(f[0]) == pytest.approx(2.0 * STIFF * np.tan(0.01), rel=1e-12)


def test_a_straight_tendon_needs_no_bisector():
    _, f = node(0.0, 1e6, mu=0.0)
    np.testing.assert_allclose(f, [0.0, -2.0 * STIFF], atol=1e-9)  # closed form: n' = n


def test_sticks_below_and_slides_at_the_capacity():  # closed form
    assert slide(0.5 * MU * 1000.0 / STIFF) == (pytest.approx(0.5 * MU * 1000.0), STICKING)
    assert slide(1.0) == (MU * 1000.0, FORWARD)
    assert slide(-1.0) == (-MU * 1000.0, BACKWARD)


def test_reversal_starts_from_the_force_that_was_there():  # closed form
    capacity = MU * 1000.0
    assert force(-0.5 * capacity / STIFF, rub=capacity) == pytest.approx(0.5 * capacity)
    assert force(-1.5 * capacity / STIFF, rub=capacity) == pytest.approx(-0.5 * capacity)
    assert force(-2.5 * capacity / STIFF, rub=capacity) == -capacity


def test_friction_falls_with_the_normal_force():
    assert force(0.0, rub=300.0, N=500.0) == MU * 500.0  # closed form
    assert force(0.0, rub=-300.0, N=0.0) == 0.0


def test_roughness_adds_capacity_by_the_tension():
    assert force(1.0, T=2e5, rough=0.01) == pytest.approx(MU * 1000.0 + 0.01 * 2e5)  # closed form


def test_grout_sticks():
    assert slide(1.0, was=GROUTED) == (STIFF, GROUTED)
    assert slide(-1.0, rub=300.0, was=GROUTED) == (300.0 - STIFF, GROUTED)  # closed form


MOTIONS = (BACKWARD, STICKING, FORWARD, HELD, UNKNOWN)
CAPACITY = MU * 1000.0


@pytest.mark.parametrize(("slid", "slip"), [(FORWARD, -1.0), (BACKWARD, 1.0)])
def test_a_node_that_is_pushed_back_is_held_once_and_then_slides(slid, slip):
    held, motion = slide(slip, was=slid)
    assert (held, motion) == (slip * STIFF, HELD)  # closed form: beyond the capacity
    after, motion = slide(slip, was=HELD)
    assert (after, motion) == (np.sign(slip) * CAPACITY, BACKWARD if slid == FORWARD else FORWARD)


@pytest.mark.parametrize("was", MOTIONS)
@pytest.mark.parametrize("slip", [-1.0, -1e-3, 0.0, 1e-3, 1.0])
def test_all_but_a_push_back_is_the_return_mapping(slip, was):
    trial = STIFF * slip
    if (was, np.sign(slip)) not in {(FORWARD, -1.0), (BACKWARD, 1.0)} or abs(trial) < CAPACITY:
        assert force(slip, was=was) == pytest.approx(np.clip(trial, -CAPACITY, CAPACITY))  # closed form


@pytest.mark.parametrize("slip", [-1.0, 0.0, 1.0])
def test_an_expected_motion_is_taken_as_given_once(slip):
    assert slide(slip, was=EXPECTED_FORWARD) == (CAPACITY, FORWARD)  # closed form
    assert slide(slip, was=EXPECTED_BACKWARD) == (-CAPACITY, BACKWARD)
    # and after that it is a motion like any other
    assert slide(slip, was=FORWARD)[1] == {-1.0: HELD, 0.0: STICKING, 1.0: FORWARD}[slip]


def test_a_penalty_far_from_equilibrium_does_not_move_the_capacity():
    """Closed form: mu times what the two tensions press across the bisector, whatever the gap."""
    for gap in (-2.0, 0.0, 50.0):
        chords, f = node(0.05, 1e6, T1=1e6, T2=9e5, gap=gap)
        bisector = chords.sum(axis=0) / np.hypot(*chords.sum(axis=0))
        assert f @ bisector == pytest.approx(MU * 1.9e6 * np.sin(0.025), rel=1e-9)
