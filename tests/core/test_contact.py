"""One contact element in random deformed positions: equilibrium, tangent, rigid motion, energy."""

import numpy as np
import pytest

from ptbatch.core.contact import UNKNOWN, Segment, contact_forces, masters, project, projection_step
from ptbatch.core.jit import STEP, cos_sin
from ptbatch.core.model import Contact
from tests.core.numerics import central_jacobian, turned_by

H = 500.0
DUCTS = {
    "polygon": Segment(H, -100.0, -140.0, -0.08, -0.08, 1000.0, np.hypot(H, 40.0), False),
    "smooth": Segment(H, -100.0, -140.0, -0.13, -0.04, 1000.0, 501.9, True),
}
T3, T4, SLOPE3, SLOPE4 = 1.3e6, 1.2e6, 400.0, 500.0  # tensions [N] in position(0) and their slopes by length
any_duct = pytest.mark.parametrize("duct", DUCTS)
any_slip = pytest.mark.parametrize("slip", [0.0, 10.0, -10.0], ids=["stick", "slide right", "slide left"])
any_normal = pytest.mark.parametrize("corrected", [True, False])


def law(corrected=True, mu=0.3):
    return Contact(1e5, 1e5, 1e6, mu, 0.0, True, corrected)


def position(seed):
    """Random masters; a slave within millimetres of the duct; neighbours that make a kink."""
    rng = np.random.default_rng(seed)
    masters = rng.standard_normal(6) * [8.0, 12.0, 0.03, 8.0, 12.0, 0.03]
    slave = np.array([250.0, -120.0]) + 0.5 * (masters[:2] + masters[3:5])
    left, right = slave + [-430.0, 45.0], slave + [460.0, 8.0]
    return np.concatenate([slave, masters, left, right]) + np.pad(rng.standard_normal(4), (8, 0))


def lengths(q):
    return np.array([np.hypot(q[0] - q[i], q[1] - q[i + 1]) for i in (8, 10)])


def duct_of(q, seg):
    """The masters' duct."""
    return masters(q, cos_sin(q[4]), cos_sin(q[7]), seg)


def projected(q, first, seg):
    """xi of the slave's projection."""
    return project(q, *duct_of(q, seg), first, seg)


def tendon(q):
    """Unit vectors of the two chords, and their tensions; q may be complex."""
    chords = np.array([q[0:2] - q[8:10], q[10:12] - q[0:2]])
    now = np.sqrt((chords**2).sum(axis=1))
    left, right = chords / now[:, None]
    tensions = np.array([T3, T4]) + np.array([SLOPE3, SLOPE4]) * (now - lengths(position(0)))
    return tuple(left), tuple(right), *tensions


def slid(duct, slip):
    """The arc length that the slave of position(0) has come from."""
    seg = DUCTS[duct]
    return seg.s + projected(position(0), 0.5, seg) * seg.ds - slip


def evaluate(q, duct, slip, c, rough=0.01):
    """(forces (8,), N, T_t, s, motion). Of a complex q one step of the projection carries the derivative."""
    f, seg = np.zeros(8, q.dtype), DUCTS[duct]
    xi = projection_step(q, *duct_of(q, seg), projected(q.real.copy(), 0.5, seg), seg)
    return f, *contact_forces(
        q[:8], *duct_of(q, seg), xi, *tendon(q), slid(duct, slip), 500.0, rough, UNKNOWN, seg, c, f
    )


@any_duct
@any_slip
@any_normal
@pytest.mark.parametrize("seed", range(4))
def test_self_equilibrium(duct, slip, corrected, seed):
    q = position(seed)
    f, N, *_ = evaluate(q, duct, slip, law(corrected))
    x, y = np.array([q[0], q[2], q[5] + H]), q[[1, 3, 6]]
    across, up = f[[0, 2, 5]], f[[1, 3, 6]]
    moment = (x * up - y * across).sum() + f[4] + f[7]
    assert abs(N) > 10.0
    # closed form: two forces and one moment are zero, up to round-off of the largest
    np.testing.assert_allclose([across.sum(), up.sum(), moment / H], 0.0, atol=1e-12 * np.abs(f).max())


@any_duct
@any_slip
@any_normal
def test_tangent_is_the_central_difference(duct, slip, corrected):
    c, q, exact = law(corrected), position(0), np.empty((8, 12))
    for i in range(12):
        z = q.astype(complex)
        z[i] += 1j * STEP
        exact[:, i] = evaluate(z, duct, slip, c)[0].imag / STEP
    difference = central_jacobian(lambda p: evaluate(p, duct, slip, c)[0], q, 1e-5)
    scale = np.abs(exact).max(axis=1, keepdims=True)
    # truncation and round-off of a difference over 1e-5 mm or rad are near 1e-7 of a row's largest term
    np.testing.assert_allclose(difference / scale, exact / scale, atol=2e-6)


@any_duct
@any_slip
@any_normal
def test_rigid_motion_turns_the_forces_and_makes_no_new_ones(duct, slip, corrected):
    q, phi, c = position(0), 0.7, law(corrected)
    f, *scalars = evaluate(q, duct, slip, c)
    points = np.array([q[0:2], q[2:4], q[5:7] + [H, 0.0], q[8:10], q[10:12]])
    slave, one, two, left, right = points @ turned_by(phi).T + [120.0, -340.0]
    moved = np.concatenate([slave, one, [q[4] + phi], two - [H, 0.0], [q[7] + phi], left, right])
    after, *scalars_after = evaluate(moved, duct, slip, c)
    for at in (slice(0, 2), slice(2, 4), slice(5, 7)):
        f[at] = turned_by(phi) @ f[at]
    # a gap of a millimetre is a difference of positions of hundreds: round-off 1e-13, times 1e5 N/mm
    np.testing.assert_allclose(after, f, rtol=1e-9, atol=1e-9 * np.abs(f).max())
    np.testing.assert_allclose(scalars_after, scalars, rtol=1e-9)


@any_duct
def test_uncorrected_frictionless_force_is_the_gradient_of_a_spring_across_the_gap(duct):
    c, q = law(corrected=False, mu=0.0), position(0)

    def energy(p):
        return np.array([0.5 * evaluate(p, duct, 0.0, c, rough=0.0)[1] ** 2 / c.normal])

    f = evaluate(q, duct, 0.0, c, rough=0.0)[0]
    gradient = central_jacobian(energy, q, 1e-5)[0]
    np.testing.assert_allclose(gradient[:8], f, atol=1e-6 * np.abs(f).max())  # closed form
    np.testing.assert_allclose(gradient[8:], 0.0, atol=1e-6 * np.abs(f).max())


def test_projection_on_a_polygon_is_eq_2():
    q, seg = position(2), DUCTS["polygon"]
    x1 = np.array([q[2], q[3]]) + turned_by(q[4]) @ [0.0, seg.y1]
    x2 = np.array([H + q[5], q[6]]) + turned_by(q[7]) @ [0.0, seg.y2]
    chord = x2 - x1
    xi = (q[:2] - x1) @ chord / (chord @ chord)  # closed form
    assert projected(q, 0.9, seg) == pytest.approx(xi, rel=1e-12)


def test_projection_on_a_smooth_duct_is_its_nearest_point():
    q, seg = position(2), DUCTS["smooth"]
    q[2:8] = 0.0
    xi = np.linspace(0.4, 0.6, 20001)
    x, t = H * xi, xi - 1.0
    y = (
        seg.y1 * (1 + 2 * xi) * t**2
        + seg.y2 * xi**2 * (3 - 2 * xi)
        + H * (seg.slope1 * xi * t**2 + seg.slope2 * xi**2 * t)
    )
    q[:2] = 251.0, -123.0
    nearest = xi[np.argmin((x - q[0]) ** 2 + (y - q[1]) ** 2)]  # by search, on a grid of 1e-5
    assert projected(q, 0.9, seg) == pytest.approx(nearest, abs=1.1e-5)
