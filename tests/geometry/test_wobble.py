"""Waves on tendon profiles: their angle, what they leave alone, and what refuses them."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.geometry.profile import ideal_profile, tendon_profile
from ptbatch.geometry.wobble import stretches

MU, K = 0.07, 3.3e-6


def member(span, dp, profile="parabola", **values) -> SimpleNamespace:
    rest = dict(
        harp=(1 / 3, 2 / 3), inflection=0.1, profile_points=(), wobble="sine", mu=MU, K=K, elements=20
    )
    return SimpleNamespace(**rest | dict(span=span, dp=dp, profile=profile) | values)


POINTS = ((0.0, 300.0), (1000.0, 350.0), (4000.0, 200.0), (6000.0, 300.0))
TWO = (6000.0, 7000.1), (300.0, 500.0, 100.0, 450.0, 250.0)
MEMBERS = {
    "straight": member((12000.0,), (300.0,), "straight"),
    "straight, two spans": member(TWO[0], (300.0,), "straight"),
    "parabola": member((20000.0,), (300.0, 858.0, 300.0)),
    "unsymmetric": member((9000.0,), (200.0, 500.0, 350.0)),
    "harped": member((12000.0,), (300.0, 500.0, 300.0), "harped"),
    "two spans": member(*TWO),
    "kinked at its support": member(*TWO, inflection=0.0),
    "strongly curved": member((7000.0, 7000.0), (280.0, 480.0, 80.0, 480.0, 280.0), mu=0.3, K=1e-6),
    "points": member((6000.0,), (), profile_points=POINTS),
}
every_member = pytest.mark.parametrize("values", MEMBERS.values(), ids=MEMBERS.keys())


def parts(values):
    """The stretches of its profile."""
    return stretches(ideal_profile(values), values.span, values.elements)


def ends(values) -> np.ndarray:
    """x of the ends of all stretches."""
    return np.array([0.0, *(part.stop for part in parts(values))])


def wanted(values, x):
    """(mu alpha + K x) / mu of the ideal profile."""
    ideal = ideal_profile(values)
    return ideal.angle(x) + values.K / values.mu * ideal.arc_length(x)


@every_member
def test_total_angle_is_that_of_curvature_and_wobble_friction(values):
    """(mu alpha + K x) / mu, the paper's; x is the ideal length, as in eq. (38)."""
    assert tendon_profile(values).total_angle == pytest.approx(wanted(values, sum(values.span)), rel=1e-12)


@every_member
def test_angle_follows_the_length(values):
    """Exactly by stretches; half wave by half wave but for the slope, whose square the angle feels."""
    wavy, x = tendon_profile(values), ends(values)
    assert_allclose(wavy.angle(x), wanted(values, x), rtol=1e-11)
    for part in parts(values):
        feet = part.start + np.cumsum(part.half_waves[:-1])
        x = np.append(np.nextafter(part.start, part.stop), feet)
        assert_allclose(np.diff(wavy.angle(x)), np.diff(wanted(values, x)), rtol=0.02)


@every_member
def test_depth_and_direction_stay_at_the_ends_of_stretches(values):
    ideal, wavy, x = ideal_profile(values), tendon_profile(values), ends(values)
    assert set(np.round(ideal.breaks, 6)) | set(np.cumsum(values.span)) <= set(np.round(x, 6))
    assert_allclose(wavy.depth(x), ideal.depth(x), atol=1e-9)
    for side in ("left", "right"):
        assert_allclose(wavy.slope(x, side), ideal.slope(x, side), atol=1e-12)
    assert_allclose(wavy.kinks, ideal.kinks)


@every_member
def test_the_curve_is_continuous_and_consistent(values):
    """Slope is the derivative of depth; length and angle are those of a fine polygon."""
    p = tendon_profile(values)
    middles = (np.arange(4001) + 0.5) / 4001 * p.breaks[-1]
    x = np.union1d(np.linspace(0.0, p.breaks[-1], 20001), p.breaks)
    assert_allclose((p.depth(middles + 1e-2) - p.depth(middles - 1e-2)) / 2e-2, p.slope(middles), atol=1e-7)
    assert_allclose(p.arc_length(x[1:]), np.cumsum(np.hypot(np.diff(x), np.diff(p.depth(x)))), rtol=1e-7)
    slopes = np.column_stack([p.slope(x[:-1], "right"), p.slope(x[1:], "left")]).ravel()
    assert np.abs(np.diff(np.arctan(slopes))).sum() == pytest.approx(p.total_angle, rel=1e-12)


@pytest.mark.parametrize("name", ["straight", "parabola", "unsymmetric", "harped"])
def test_waves_have_a_mean_of_zero_and_their_mirror_image(name):
    values = MEMBERS[name]
    end = sum(values.span)
    reflection = SimpleNamespace(**vars(values) | {"dp": values.dp[::-1]})
    x = np.linspace(0.0, end, 20001)
    wave = tendon_profile(values).depth(x) - ideal_profile(values).depth(x)
    assert abs(wave.mean()) <= 1e-4 * np.abs(wave).max()
    assert_allclose(tendon_profile(reflection).depth(end - x), tendon_profile(values).depth(x), atol=1e-8)


def test_more_elements_make_lower_waves_of_the_same_angle():
    coarse, fine = (member((12000.0,), (300.0, 500.0, 300.0), elements=n) for n in (20, 60))
    x = np.linspace(0.0, 12000.0, 5001)
    heights = [np.ptp(tendon_profile(m).depth(x) - ideal_profile(m).depth(x)) for m in (coarse, fine)]
    assert heights[1] == pytest.approx(heights[0] / 9.0, rel=0.2)  # with the square of the element
    assert tendon_profile(coarse).total_angle == pytest.approx(tendon_profile(fine).total_angle, rel=1e-12)


def test_a_straight_tendon_has_the_sine_of_closed_form():
    """Its curvature a has the mean 2 a / pi = K / mu, in the limit of small slopes."""
    values = member((12000.0,), (300.0,), "straight", K=1e-8)
    wavy = tendon_profile(values)
    h = 0.1
    x = np.linspace(1000.0, 11000.0, 20001)
    curvature = (wavy.depth(x + h) - 2.0 * wavy.depth(x) + wavy.depth(x - h)) / h**2
    assert np.abs(curvature).max() == pytest.approx(np.pi / 2.0 * 1e-8 / MU, rel=1e-3)


def test_no_wobble_or_direct_wobble_leave_the_profile_ideal():
    for values in (member((9000.0,), (300.0,), "straight", K=0.0), member(*TWO, wobble="direct")):
        assert_allclose(tendon_profile(values).breaks, ideal_profile(values).breaks)


def test_waves_that_no_tendon_has_are_refused():
    with pytest.raises(ValueError, match="without curvature friction mu"):
        tendon_profile(member(*TWO, mu=0.0))
    with pytest.raises(ValueError, match=r"steeper than 0\.5 at x = 0 mm"):
        tendon_profile(member(*TWO, mu=0.001))
