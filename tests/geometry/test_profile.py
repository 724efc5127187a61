"""Tendon profiles: every expected number is closed form."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.geometry.curve import Profile
from ptbatch.geometry.profile import ideal_profile


def profile(span, dp, shape="parabola", *, harp=(1 / 3, 2 / 3), inflection=0.1, points=()) -> Profile:
    return ideal_profile(
        SimpleNamespace(
            span=span, profile=shape, dp=dp, harp=harp, inflection=inflection, profile_points=points
        )
    )


ALL = {
    "straight": profile((8000.0,), (250.0,), "straight"),
    "parabola": profile((20000.0,), (300.0, 858.0, 300.0)),
    "unsymmetric": profile((9000.0,), (200.0, 500.0, 350.0)),
    "three spans": profile((12000.0, 15000.0, 9000.0), (300.0, 500.0, 100.0, 520.0, 90.0, 400.0, 250.0)),
    "kinked at supports": profile((6000.0, 7000.1), (300.0, 500.0, 100.0, 500.0, 250.0), inflection=0.0),
    "reversed only": profile((6000.0, 7000.1), (300.0, 500.0, 100.0, 500.0, 250.0), inflection=0.5),
    "harped": profile((6000.0, 7000.1), (300.0, 500.0, 100.0, 450.0, 250.0), "harped"),
    "points": profile(
        (6000.0,), (), points=((0.0, 300.0), (1000.0, 350.0), (4000.0, 200.0), (6000.0, 300.0))
    ),
}
every_profile = pytest.mark.parametrize("p", ALL.values(), ids=ALL.keys())


def test_parabola_follows_its_equation():
    p, x = ALL["parabola"], np.linspace(0.0, 20000.0, 41)
    drape = 558.0 * 4.0 * (x / 20000.0) * (1.0 - x / 20000.0)
    assert_allclose(p.depth(x), 300.0 + drape, atol=1e-9)  # closed form
    assert_allclose(p.slope(x), 4.0 * 558.0 / 20000.0 * (1.0 - x / 10000.0), atol=1e-15)  # closed form


def test_parabola_arc_length_and_angle():
    p, u = ALL["parabola"], 4.0 * 558.0 / 20000.0
    half = 5000.0 * (np.hypot(1.0, u) + np.arcsinh(u) / u)
    assert_allclose(p.arc_length([10000.0, 20000.0]), [half, 2.0 * half], rtol=1e-14)  # closed form
    assert_allclose(p.angle([10000.0, 20000.0]), [np.arctan(u), 2.0 * np.arctan(u)], rtol=1e-14)
    assert (p.length, p.total_angle) == (p.arc_length(20000.0), p.angle(20000.0))
    assert p.kinks.size == 0


def test_outer_half_parabola_runs_straight_to_the_end():
    p = ALL["unsymmetric"]
    assert_allclose(p.breaks, [0.0, 4500.0, 9000.0])
    assert_allclose(p.slope([0.0, 4500.0, 9000.0]), [600.0 / 4500.0, 0.0, -300.0 / 4500.0], atol=1e-15)


def test_inner_support_is_a_level_peak_and_takes_its_share_of_the_fall():
    p, support = ALL["three spans"], 12000.0
    assert_allclose(p.depth([6000.0, support, 19500.0]), [500.0, 100.0, 520.0], rtol=1e-14)
    assert_allclose(p.slope(support), 0.0, atol=1e-15)
    # closed form: inflection / 0.5 of the fall, slope 2 D / (L / 2) at the inflection points
    assert_allclose(p.depth([support - 1200.0, support + 1500.0]), [180.0, 184.0], rtol=1e-14)
    steepest = [-800.0 / 6000.0, 840.0 / 7500.0]
    for side in ("left", "right"):
        assert_allclose(p.slope([support - 1200.0, support + 1500.0], side), steepest, rtol=1e-12)


def test_turned_angle_of_two_spans_is_counted_four_times_inside_a_span():
    p = profile((7620.0, 7620.0), (177.8, 273.05, 82.55, 273.05, 177.8), inflection=0.15)
    assert p.total_angle == pytest.approx(
        2.0 * (np.arctan(0.05) + 2.0 * np.arctan(0.1)), rel=1e-13
    )  # closed form


def test_inflection_at_its_limits_leaves_one_parabola_and_a_kink():
    assert_allclose(ALL["kinked at supports"].kinks, [6000.0])
    assert_allclose(ALL["reversed only"].kinks, [3000.0, 9500.05])
    assert_allclose(ALL["reversed only"].slope(6000.0), 0.0, atol=1e-15)


def test_harped_tendon_turns_at_its_points_and_supports():
    p = ALL["harped"]
    assert_allclose(p.kinks, [2000.0, 4000.0, 6000.0, 6000.0 + 7000.1 / 3.0, 6000.0 + 7000.1 / 1.5])
    assert_allclose([p.slope(2000.0, "left"), p.slope(2000.0)], [0.1, 0.0], atol=1e-15)
    assert_allclose(p.depth([1000.0, 3000.0, 5000.0]), [400.0, 500.0, 300.0])


def test_kink_counts_half_at_itself_and_wholly_beyond():
    p, kink = ALL["harped"], np.arctan(0.1)
    assert_allclose(p.angle([0.0, 1999.9, 2000.0, 2000.1]), [0.0, 0.0, kink / 2.0, kink], atol=1e-15)


def test_points_make_a_polyline_and_replace_the_shape():
    p = ALL["points"]
    assert_allclose(p.depth([500.0, 2500.0, 5000.0]), [325.0, 275.0, 250.0])
    assert_allclose(p.kinks, [1000.0, 4000.0])
    assert p.length == pytest.approx(np.hypot(1000, 50) + np.hypot(3000, 150) + np.hypot(2000, 100))


def test_straight_tendon_neither_turns_nor_lengthens():
    p = ALL["straight"]
    assert (p.total_angle, p.kinks.size) == (0.0, 0)
    assert p.length == pytest.approx(8000.0, rel=1e-14)
    assert_allclose(p.depth([0.0, 4000.0, 8000.0]), 250.0)


@every_profile
def test_depth_is_continuous_and_its_derivative_is_the_slope(p):
    inside = p.breaks[1:-1]
    assert_allclose(p.depth(np.nextafter(inside, 0.0)), p.depth(inside), atol=1e-9)
    x = (np.arange(1000) + 0.5) / 1000.0 * p.breaks[-1]  # no break is one of them
    difference = (p.depth(x + 1e-2) - p.depth(x - 1e-2)) / 2e-2
    assert_allclose(difference, p.slope(x), atol=1e-9)


@every_profile
def test_length_and_angle_are_those_of_a_fine_polygon(p):
    x = np.union1d(np.linspace(0.0, p.breaks[-1], 10001), p.breaks)
    chords = np.hypot(np.diff(x), np.diff(p.depth(x)))
    assert_allclose(p.arc_length(x[1:]), np.cumsum(chords), rtol=1e-8)
    middles = (x[1:] + x[:-1]) / 2.0
    slopes = np.column_stack([p.slope(x[:-1], "right"), p.slope(middles), p.slope(x[1:], "left")])
    turned = np.cumsum(np.abs(np.diff(np.arctan(slopes.ravel()))))
    assert_allclose(p.angle(middles), turned[::3], atol=1e-12)


@every_profile
def test_breaks_hold_the_extreme_depths(p):
    x = np.linspace(0.0, p.breaks[-1], 5001)
    assert p.depth(p.breaks).min() <= p.depth(x).min() + 1e-9
    assert p.depth(p.breaks).max() >= p.depth(x).max() - 1e-9


@every_profile
@pytest.mark.parametrize("shape", [(), (6,), (2, 3)])
def test_answers_have_the_shape_of_the_question(p, shape):
    x = np.full(shape, 2000.0)
    for answer in (p.depth(x), p.slope(x), p.arc_length(x), p.angle(x)):
        assert np.shape(answer) == shape


def test_faults_name_what_is_wrong():
    with pytest.raises(ValueError, match="'catenary' is none of straight, parabola, harped"):
        profile((6000.0,), (300.0,), "catenary")
    with pytest.raises(ValueError, match=r"dp: parabola, 2 span\(s\): 5 wanted, 3 given"):
        profile((6000.0, 6000.0), (300.0, 400.0, 300.0))
    with pytest.raises(ValueError, match="x must increase"):
        profile((6000.0,), (300.0, 400.0, 300.0), "harped", harp=(0.6, 0.4))
    with pytest.raises(ValueError, match="x must increase"):
        profile((6000.0,), (300.0, 400.0, 300.0), "harped", harp=(0.5, 0.5))
    with pytest.raises(ValueError, match="from x = 0 to x = 6000 mm, got 0 to 5000"):
        profile((6000.0,), (), points=((0.0, 300.0), (5000.0, 300.0)))
