"""Friction at one tendon node: Coulomb's law, the kink formula and what the correction force is for."""

import numpy as np
import pytest

from ptbatch.core.contact import Segment, contact_forces, friction, project
from ptbatch.core.model import Contact

MU, STIFF = 0.3, 1e5
SEGMENTS = {
    "polygon": Segment(500.0, 0.0, 0.0, 0.0, 0.0, 0.0, 500.0, False),
    "smooth": Segment(500.0, 0.0, 0.0, 0.05, -0.05, 0.0, 500.4, True),
}
LAW = Contact(STIFF, STIFF, 1e6, MU, 0.0, True, True)


def slide(slip, rub=0.0, N=1000.0, T=0.0, rough=0.0, bonded=False):
    return friction(slip, rub, N, T, rough, bonded, LAW)


def node(theta, slip, mu=MU, corrected=True, lean=0.0, duct="polygon"):
    """(left and right unit chord, force) of a slave 2 mm off its segment; the chords turn down by theta."""
    c = Contact(STIFF, STIFF, 1e6, mu, 0.0, True, corrected)
    left, right = lean + 0.5 * theta, lean - 0.5 * theta
    chords = np.array([[np.cos(left), np.sin(left)], [np.cos(right), np.sin(right)]])
    seg = SEGMENTS[duct]
    q = np.zeros(12)
    q[:2] = 250.0, -2.0 + (500.0 / 8 * 0.1 if duct == "smooth" else 0.0)
    q[8:10], q[10:12] = q[:2] - 300.0 * chords[0], q[:2] + 450.0 * chords[1]
    xi, f = project(q, 0.5, seg), np.zeros(8)
    s0 = seg.s + xi * seg.ds - slip
    contact_forces(q, xi, 0.0, 0.0, 0.0, 0.0, 300.0, 450.0, s0, 0.0, 0.0, False, seg, c, f)
    return chords, f[:2]


def tensions(chords, force):
    """T1, T2 left and right of a node in equilibrium under the force that the duct's spring takes from it."""
    return np.linalg.solve(np.column_stack([chords[0], -chords[1]]), -force)


@pytest.mark.parametrize("duct", SEGMENTS)
@pytest.mark.parametrize("lean", [0.0, 0.01, -0.02])
@pytest.mark.parametrize("theta", [0.002, 0.05, 0.4])
@pytest.mark.parametrize("slip", [1e6, -1e6])
def test_a_kink_takes_its_share_of_the_tension(theta, slip, lean, duct):
    T1, T2 = tensions(*node(theta, slip, lean=lean, duct=duct))
    m = MU * np.tan(0.5 * theta)
    less_over_more = (1.0 - m) / (1.0 + m)  # closed form; sliding right the tension grows to the right
    assert T1 / T2 == pytest.approx(less_over_more if slip > 0.0 else 1.0 / less_over_more, rel=1e-12)


@pytest.mark.parametrize("lean", [0.0, 0.01, -0.02])
def test_correction_lets_a_frictionless_kink_pass_the_tension_on(lean):
    T1, T2 = tensions(*node(0.05, 1e6, mu=0.0, lean=lean))
    assert T1 == pytest.approx(T2, rel=1e-12)  # closed form: the force is along the bisector


def test_without_correction_a_leaning_kink_does_not():
    T1, T2 = tensions(*node(0.05, 1e6, mu=0.0, lean=0.01, corrected=False))
    # closed form: the force along the duct's normal, T1 cos(lean + theta/2) = T2 cos(lean - theta/2)
    assert T1 / T2 == pytest.approx(np.cos(0.01 - 0.025) / np.cos(0.01 + 0.025), rel=1e-12)
    assert abs(T1 / T2 - 1.0) > 4e-4
    T1, T2 = tensions(*node(0.05, 1e6, mu=0.0, lean=0.0, corrected=False))
    assert T1 == pytest.approx(T2, rel=1e-12)  # level with the duct there is nothing to correct


def test_corrected_force_keeps_its_part_across_the_duct():
    """Eqs (18)-(20): P_n n + P_cor t with P_cor = P_n tan(alpha)."""
    _, force = node(0.05, 1e6, mu=0.0, lean=0.01)
    assert force[1] == pytest.approx(-2.0 * STIFF, rel=1e-12)  # closed form: P_n, penalty times gap
    assert abs(force[0]) == pytest.approx(2.0 * STIFF * np.tan(0.01), rel=1e-12)


def test_a_straight_tendon_needs_no_bisector():
    _, force = node(0.0, 1e6, mu=0.0)
    np.testing.assert_allclose(force, [0.0, -2.0 * STIFF], atol=1e-9)  # closed form: n' = n


def test_sticks_below_and_slides_at_the_capacity():  # closed form
    assert slide(0.5 * MU * 1000.0 / STIFF) == pytest.approx(0.5 * MU * 1000.0)
    assert slide(1.0) == MU * 1000.0
    assert slide(-1.0) == -MU * 1000.0


def test_reversal_starts_from_the_force_that_was_there():  # closed form
    capacity = MU * 1000.0
    assert slide(-0.5 * capacity / STIFF, rub=capacity) == pytest.approx(0.5 * capacity)
    assert slide(-1.5 * capacity / STIFF, rub=capacity) == pytest.approx(-0.5 * capacity)
    assert slide(-2.5 * capacity / STIFF, rub=capacity) == -capacity


def test_friction_falls_with_the_normal_force():
    assert slide(0.0, rub=300.0, N=500.0) == MU * 500.0  # closed form
    assert slide(0.0, rub=-300.0, N=0.0) == 0.0


def test_roughness_adds_capacity_by_the_tension():
    assert slide(1.0, T=2e5, rough=0.01) == pytest.approx(MU * 1000.0 + 0.01 * 2e5)  # closed form


def test_grout_sticks():
    assert slide(1.0, bonded=True) == STIFF
    assert slide(-1.0, rub=300.0, bonded=True) == 300.0 - STIFF  # closed form
