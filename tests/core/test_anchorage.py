"""The tendon's ends: equilibrium, tangent, the kink at the anchor, what each mode asks of the gap."""

import numpy as np
import pytest

from ptbatch.core.anchorage import Anchor, end_forces, end_friction, end_position
from ptbatch.core.jit import STEP
from ptbatch.core.model import ANCHORED, PRESCRIBED, PULLED, Contact
from tests.core.numerics import central_jacobian, turned_by

LAW = Contact(1e5, 1e5, 1e6, 0.3, 0.0, True, True)
SLOPE = -0.11
END = Anchor(
    -60.0, *(np.array([-1.0, -SLOPE]) / np.hypot(1.0, SLOPE))
)  # left end, the duct going down to the right
T, STIFF, ROUGH = 1.2e6, 3e5, 0.004
Q = np.array([-2.0, 1.5, -0.8, 0.02, 420.0, -115.0])  # gap; u, v, theta; neighbour
MODES = {"prescribed": PRESCRIBED, "pulled": PULLED, "anchored": ANCHORED}
SLIPS = {"stick": 0.0, "out": 30.0, "in": -30.0}
any_mode = pytest.mark.parametrize("mode", MODES.values(), ids=MODES.keys())
any_slip = pytest.mark.parametrize("slip", SLIPS.values(), ids=SLIPS.keys())


def chord(q):
    x, y, _, _ = end_position(q, END)
    return np.hypot(q[4] - x, q[5] - y)


def evaluate(q, mode, slip=0.0, rub=3000.0, value=0.0, rough=ROUGH):
    """(forces (6,), tan(theta/2)); tension T at Q, elastic with STIFF. Complex q about its real part."""
    now, f = chord(q.real.copy()), np.zeros(6, q.dtype)
    tension = T + STIFF * (now - chord(Q))
    half_tan = end_forces(
        q, mode, value, -2.5, tension, STIFF, now, Q[0] - slip, rub, rough, False, END, LAW, f
    )  # fmt: skip
    return f, half_tan


@any_mode
@any_slip
def test_self_equilibrium(mode, slip):
    f, _ = evaluate(Q, mode, slip)
    # closed form: the pull on the neighbour comes back on the beam node, with its moment about that node
    np.testing.assert_allclose(f[1:3] + f[4:6], 0.0, atol=1e-9)
    lever = Q[4:6] - Q[1:3]
    assert f[3] + lever[0] * f[5] - lever[1] * f[4] == pytest.approx(0.0, abs=1e-12 * T * 420.0)
    assert np.hypot(*f[4:6]) == pytest.approx(T, rel=1e-12)


@any_mode
@any_slip
def test_tangent_is_the_central_difference(mode, slip):
    exact = np.empty((6, 6))
    for i in range(6):
        z = Q.astype(complex)
        z[i] += 1j * STEP
        exact[:, i] = evaluate(z, mode, slip)[0].imag / STEP
    step = np.array([1e-5, 1e-5, 1e-5, 1e-7, 1e-5, 1e-5])
    difference = central_jacobian(lambda q: evaluate(q, mode, slip)[0], Q, step)
    scale = np.abs(exact).max(axis=1, keepdims=True)
    np.testing.assert_allclose(difference / scale, exact / scale, atol=1e-7)  # truncation and round-off 1e-8


@any_mode
@any_slip
def test_rigid_motion_turns_the_forces_and_makes_no_new_ones(mode, slip):
    f, half_tan = evaluate(Q, mode, slip)
    turn = turned_by(0.6)
    moved = np.concatenate([Q[:1], turn @ Q[1:3] + [30.0, -9.0], [Q[3] + 0.6], turn @ Q[4:6] + [30.0, -9.0]])
    after, half_tan_after = evaluate(moved, mode, slip)
    expected = [f[0], *turn @ f[1:3], f[3], *turn @ f[4:6]]
    np.testing.assert_allclose(after, expected, rtol=1e-9, atol=1e-9 * T)
    assert half_tan_after == pytest.approx(half_tan, rel=1e-9)


def test_kink_at_the_anchor():
    _, half_tan = evaluate(Q, PULLED)
    x, y, ox, oy = end_position(Q, END)
    theta = np.arccos(-(np.array([Q[4] - x, Q[5] - y]) @ [ox, oy]) / chord(Q))  # closed form
    assert half_tan == pytest.approx(np.tan(0.5 * theta), rel=1e-6)  # arccos near one loses half the digits


@pytest.mark.parametrize("rough", [0.0, ROUGH])
def test_jack_force_is_the_tension_over_its_friction(rough):
    """Closed form: T (1 + a) / (1 - a) while the tendon slides out, the inverse while it slides in."""
    f, half_tan = evaluate(Q, PULLED, slip=30.0, rough=rough)
    a = 0.3 * half_tan + 0.5 * rough
    assert f[0] == pytest.approx(T * (1 + a) / (1 - a), rel=1e-12)
    assert evaluate(Q, PULLED, slip=-30.0, rough=rough)[0][0] == pytest.approx(
        T * (1 - a) / (1 + a), rel=1e-12
    )


HALF_TAN = 0.05


def rub(slip, before=0.0, tension=T, expected=False):
    """J - T."""
    return end_friction(tension, HALF_TAN, slip, before, 0.0, expected, LAW)


def test_friction_at_the_anchor_sticks_and_turns_round():
    out, into = rub(30.0), rub(-30.0)
    assert rub(0.1) == pytest.approx(0.1 * LAW.tangential)  # closed form
    assert rub(-0.1, out) == pytest.approx(out - 0.1 * LAW.tangential)
    assert rub(-30.0, out) == into < 0.0 < out
    assert rub(30.0, tension=-T) == 0.0  # a slack tendon has no friction


def test_an_end_that_is_expected_to_slide_out_does_so_whatever_the_tension():
    a = LAW.mu * HALF_TAN
    for tension in (-1e-9, 0.0, 1e-9, T):  # closed form, as is its slope at a tendon that is still slack
        assert rub(0.0, tension=tension, expected=True) == 2.0 * a / (1.0 - a) * tension
        slope = rub(0.0, tension=complex(tension, STEP), expected=True).imag / STEP
        assert slope == pytest.approx(2.0 * a / (1.0 - a), rel=1e-12)


def test_what_each_mode_asks_of_the_gap():  # closed form
    assert evaluate(Q, PRESCRIBED, value=-5.0)[0][0] == pytest.approx(Q[0] + 5.0)
    jack = evaluate(Q, PULLED, slip=30.0)[0][0]
    assert evaluate(Q, PULLED, slip=30.0, value=jack)[0][0] == pytest.approx(0.0, abs=1e-6)
    # the anchorage is born at the gap -2.5 with the force it finds
    assert evaluate(Q, ANCHORED, value=T)[0][0] == pytest.approx(LAW.anchor * (Q[0] + 2.5), rel=1e-9)
