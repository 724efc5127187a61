"""Analytic losses: published tendons, closed forms of a straight tendon, and what holds for any tendon."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.geometry.curve import Profile
from ptbatch.geometry.profile import ideal_profile
from ptbatch.losses import Losses, analytic_losses, fpj_for_mean

KSI = 6.894757293168
INCH, FOOT = 25.4, 304.8


def profile(span, dp, shape="parabola", inflection=0.1) -> Profile:
    return ideal_profile(
        SimpleNamespace(
            span=span, profile=shape, dp=dp, harp=(0.3, 0.6), inflection=inflection, profile_points=()
        )
    )


@dataclass(frozen=True)
class Table:
    """A tendon given by angles at stations, linear between; x is its arc length."""

    breaks: np.ndarray
    angles: np.ndarray

    def slope(self, x):
        return np.zeros_like(x)

    def angle(self, x):
        return np.interp(x, self.breaks, self.angles)

    def arc_length(self, x):
        return np.asarray(x)


# --- published tendons -------------------------------------------------------------------------------------


def test_imaginary_beam():
    beam = profile((15200.0,), (508.0, 508.0 + 279.0, 508.0))
    losses = analytic_losses(beam, 1407.0, 0.3, 0.0, 195000.0, 0.5, "left")
    assert beam.total_angle == pytest.approx(2.0 * np.arctan(4.0 * 279.0 / 15200.0), rel=1e-13)  # closed form
    assert losses.loss_fixed_end == pytest.approx(0.0430, abs=5e-5)  # closed form
    assert 0.0280 < losses.loss_jacking_end < 0.0285  # closed form 2.81 to 2.85 %
    assert losses.set_length == pytest.approx(4970.0, rel=0.01)  # closed form, "about"


def test_imaginary_beam_needs_another_set_for_the_published_loss():
    # The paper prints 3.5 % at the jack for a set of 0.5 mm; its own formula needs 0.78 mm for that.
    beam = profile((15200.0,), (508.0, 508.0 + 279.0, 508.0))
    losses = analytic_losses(beam, 1407.0, 0.3, 0.0, 195000.0, 0.78, "left")
    assert losses.loss_jacking_end == pytest.approx(0.035, abs=5e-4)  # published


@pytest.mark.parametrize(
    ("h", "wedge_set", "closed_jack", "closed_fixed", "paper_jack", "paper_fixed"),
    [
        (14.0, 1.27, 5.62, 8.15, 5.5, 8.2),
        (14.0, 3.18, 9.34, 8.15, 9.5, 8.2),
        (22.0, 1.27, 6.25, 11.51, 6.3, 11.5),
        (22.0, 3.18, 10.45, 11.51, 10.5, 11.5),
    ],
)
def test_specimens(h, wedge_set, closed_jack, closed_fixed, paper_jack, paper_fixed):
    dp = INCH * np.array([h / 2.0, h - 3.25, 3.25, h - 3.25, h / 2.0])
    specimen = profile((300 * INCH, 300 * INCH), tuple(dp), inflection=0.15)
    losses = analytic_losses(specimen, 202 * KSI, 0.07, 0.001 / FOOT, 29000 * KSI, wedge_set, "left")
    percent = 100.0 * losses.loss_jacking_end, 100.0 * losses.loss_fixed_end
    # The closed forms take slopes for angles, which is 1.2 % of the angle of the deeper specimen.
    assert percent == pytest.approx((closed_jack, closed_fixed), abs=0.06)  # closed form
    assert percent == pytest.approx((paper_jack, paper_fixed), abs=0.2)  # published


@pytest.mark.parametrize(("h", "slopes"), [(14.0, 0.500), (22.0, 1.0333)])
def test_angle_of_the_specimens(h, slopes):
    end, inner = 2.0 * (h / 2.0 - 3.25) / 150.0, 2.0 * (h - 6.5) / 150.0
    assert 2.0 * end + 4.0 * inner == pytest.approx(slopes, abs=1e-4)  # closed form, angles as slopes
    dp = INCH * np.array([h / 2.0, h - 3.25, 3.25, h - 3.25, h / 2.0])
    exact = 2.0 * np.arctan(end) + 4.0 * np.arctan(inner)
    assert profile((7620.0, 7620.0), tuple(dp), inflection=0.15).total_angle == pytest.approx(
        exact, rel=1e-12
    )


TWENTY = profile((20000.0,), (300.0, 858.0, 300.0))
QUARTERS = np.linspace(0.0, 20000.0, 5)


def twenty(mu=0.25, K=1.7e-6, wedge_set=5.0, jack="left", reversal="friction") -> Losses:
    return analytic_losses(TWENTY, 1239.0, mu, K, 195000.0, wedge_set, jack, reversal)


def test_parabola_of_20_m():
    jacked = [1239.000, 1211.579, 1184.694, 1158.405, 1132.768]  # closed form
    assert_allclose(twenty().stress_jacked(QUARTERS), jacked, atol=6e-4)
    assert twenty().elongation_before == pytest.approx(121.80, abs=0.005)  # closed form


def test_parabola_of_20_m_mirrored():
    losses = twenty(reversal="mirror")
    anchored = [1093.508, 1120.929, 1147.814, 1158.405, 1132.768]  # closed form
    assert_allclose(losses.stress_anchored(QUARTERS), anchored, atol=6e-4)
    assert losses.still["left"] == pytest.approx(13495.0, abs=0.5)  # closed form, along x
    assert losses.set_length == pytest.approx(float(TWENTY.arc_length(losses.still["left"])), rel=1e-13)
    force = losses.stress_anchored(QUARTERS[::2]) * 2.85
    assert_allclose(force, [3111.9, 3270.1, 3214.8], rtol=5e-3)  # published, with the curves made straight


def test_parabola_of_20_m_under_the_friction_of_the_lowered_force():
    anchored = twenty().stress_anchored(QUARTERS)
    still = float(twenty().stress_jacked(twenty().still["left"]))
    # closed form: the geometric mirror image, still^2 / jacked
    assert_allclose(anchored[:3], still**2 / twenty().stress_jacked(QUARTERS[:3]), rtol=1e-12)
    assert_allclose(
        anchored - twenty(reversal="mirror").stress_anchored(QUARTERS),
        [2.894, 0.287, -1.154, 0, 0],
        atol=1e-3,
    )


def test_set_that_reaches_the_far_end():
    losses = twenty(mu=0.10, K=1.7e-7, reversal="mirror")
    jacked = [1239.0, 1231.104, 1223.220, 1215.387, 1207.642]  # closed form
    anchored = [1158.859, 1166.754, 1174.638, 1182.472, 1190.217]  # closed form
    assert_allclose(losses.stress_jacked(QUARTERS), jacked, atol=6e-4)
    assert_allclose(losses.stress_anchored(QUARTERS), anchored, atol=6e-4)
    assert losses.set_length == TWENTY.length


def test_90_ft_tendon():
    # published: stations every 30 ft, the stress taken as linear between them; ksi and ft
    stress = 202.5 * np.exp(-(0.25 * 0.2 + 0.0002 * 30.0) * np.arange(4))
    assert_allclose(stress[1:], [191.47, 181.04, 171.18], atol=0.005)
    feet = np.linspace(0.0, 90.0, 901)
    linear = Table(feet, -np.log(np.interp(feet, [0, 30, 60, 90], stress) / 202.5))
    losses = analytic_losses(linear, 202.5, 1.0, 0.0, 28000.0, 0.375 / 12.0, "left", "mirror")
    assert losses.set_length == pytest.approx(49.65, abs=0.005)
    assert 202.5 * losses.loss_jacking_end == pytest.approx(35.72, abs=0.005)


def test_90_ft_tendon_with_its_own_exponential():
    tendon = Table(np.array([0.0, 30.0, 60.0, 90.0]), np.array([0.0, 0.2, 0.4, 0.6]))
    losses = analytic_losses(tendon, 202.5, 0.25, 0.0002, 28000.0, 0.375 / 12.0, "left")
    rate = 0.056 / 30.0
    exponent = -np.log(1.0 - np.sqrt(28000.0 * 0.375 / 12.0 * rate / 202.5))  # closed form
    assert losses.set_length == pytest.approx(exponent / rate, rel=1e-9)
    assert losses.loss_jacking_end == pytest.approx(1.0 - np.exp(-2.0 * exponent), rel=1e-9)
    assert_allclose(
        losses.stress_jacked([30.0, 60.0, 90.0]), [191.47, 181.04, 171.18], atol=0.005
    )  # closed form


# --- closed forms of a straight tendon, K alone -------------------------------------------------------------

STRAIGHT = profile((30000.0,), (250.0,), "straight")
K, FPJ, EP = 5e-6, 1400.0, 195000.0


def straight(wedge_set, jack="left", K=K) -> Losses:
    return analytic_losses(STRAIGHT, FPJ, 0.07, K, EP, wedge_set, jack)


@pytest.mark.parametrize("jack", ["left", "right", "both"])
def test_set_inside_a_straight_tendon(jack):
    losses, exponent = straight(2.0, jack), -np.log(1.0 - np.sqrt(EP * 2.0 * K / FPJ))
    assert losses.set_length == pytest.approx(exponent / K, rel=1e-9)  # closed form
    assert losses.loss_jacking_end == pytest.approx(1.0 - np.exp(-2.0 * exponent), rel=1e-9)
    dead = 1.0 - np.exp(-K * 30000.0)
    assert losses.loss_fixed_end == pytest.approx(
        losses.loss_jacking_end if jack == "both" else dead, rel=1e-9
    )


def test_set_through_a_whole_straight_tendon():
    f = K * 30000.0
    anchor = ((1.0 - np.exp(-f)) * FPJ - EP * 40.0 * K) / (np.exp(f) - 1.0)  # closed form
    assert_allclose(straight(40.0).stress_anchored([0.0, 30000.0]), [anchor, anchor * np.exp(f)], rtol=1e-12)
    assert straight(40.0).still == {"left": 30000.0}


def test_zones_of_two_live_ends_that_meet():
    losses, f, x = straight(8.0, "both"), K * 15000.0, np.linspace(0.0, 30000.0, 61)
    anchor = ((1.0 - np.exp(-f)) * FPJ - EP * 8.0 * K) / (np.exp(f) - 1.0)  # closed form
    assert_allclose(losses.stress_anchored([0.0, 15000.0]), [anchor, anchor * np.exp(f)], rtol=1e-12)
    assert_allclose(losses.stress_anchored(x), losses.stress_anchored(x[::-1]), rtol=1e-12)
    assert losses.set_length == pytest.approx(15000.0, rel=1e-12)


@pytest.mark.parametrize(("jack", "ends"), [("left", 1), ("right", 1), ("both", 2)])
def test_set_without_friction_is_felt_everywhere(jack, ends):
    losses = straight(6.0, jack, K=0.0)
    assert_allclose(losses.stress_jacked(QUARTERS), FPJ)
    assert_allclose(
        losses.stress_anchored(QUARTERS), FPJ - ends * EP * 6.0 / 30000.0, rtol=1e-13
    )  # closed form
    assert losses.set_length == pytest.approx(30000.0 / ends)


@pytest.mark.parametrize("jack", ["left", "right", "both"])
def test_no_set_moves_nothing(jack):
    losses = twenty(wedge_set=0.0, jack=jack)
    assert_allclose(losses.stress_anchored(QUARTERS), losses.stress_jacked(QUARTERS), rtol=1e-14)
    assert (losses.set_length, losses.loss_jacking_end) == (0.0, 0.0)


def test_set_that_ends_at_a_kink_gives_the_first_straight_part_a_uniform_stress():
    # 10 000 mm before a kink of 0.2 rad: mu turn = 0.2 leaves room for a drop up to 1 - exp(-0.4)
    tendon = Table(np.array([0.0, 10000.0, 10000.001, 30000.0]), np.array([0.0, 0.0, 0.2, 0.2]))
    losses = analytic_losses(tendon, FPJ, 1.0, 0.0, EP, 6.0, "left")
    drop = EP * 6.0 / 10000.0  # closed form
    assert_allclose(losses.stress_anchored([0.0, 9999.0]), FPJ - drop, rtol=1e-6)
    assert losses.stress_anchored(20000.0) == pytest.approx(FPJ * np.exp(-0.2), rel=1e-12)


# --- what holds for any tendon ------------------------------------------------------------------------------

TENDONS = {
    "parabola": TWENTY,
    "unsymmetric": profile((20000.0,), (500.0, 900.0, 100.0)),
    "three spans": profile((12000.0, 15000.0, 9000.0), (300.0, 500.0, 100.0, 520.0, 90.0, 400.0, 250.0)),
    "harped": profile((12000.0, 15000.0), (300.0, 500.0, 100.0, 520.0, 250.0), "harped"),
    "one kink": profile((12000.0,), (100.0, 500.0, 100.0), "parabola", 0.5),
}
any_tendon = pytest.mark.parametrize("tendon", TENDONS.values(), ids=TENDONS.keys())
any_jack = pytest.mark.parametrize("jack", ["left", "right", "both"])
any_set = pytest.mark.parametrize("wedge_set", [0.2, 3.0, 15.0])
any_friction = pytest.mark.parametrize(("mu", "K"), [(0.2, 1e-6), (0.3, 0.0), (0.05, 1e-7)])
any_reversal = pytest.mark.parametrize("reversal", ["friction", "mirror"])


def removed_area(losses: Losses, start: float, stop: float) -> float:
    """Area between the curves by the midpoint rule."""
    path = losses.friction.path
    inside = [at for at in (*path.breaks, *losses.still.values()) if start < at < stop]
    x = np.union1d(np.linspace(start, stop, 2001), inside)
    middle = (x[1:] + x[:-1]) / 2.0
    gap = losses.stress_jacked(middle) - losses.stress_anchored(middle)
    return float(gap @ np.diff(path.arc_length(x)))


@any_tendon
@any_jack
@any_set
@any_friction
@any_reversal
def test_each_end_loses_its_own_area_on_its_own_side(tendon, jack, wedge_set, mu, K, reversal):
    losses = analytic_losses(tendon, 1300.0, mu, K, EP, wedge_set, jack, reversal)
    for end, still in losses.still.items():
        start, stop = sorted((losses.friction.ends[end], still))
        assert removed_area(losses, start, stop) == pytest.approx(EP * wedge_set, rel=1e-5)
    total = removed_area(losses, 0.0, float(tendon.breaks[-1]))
    assert total == pytest.approx(EP * wedge_set * len(losses.still), rel=1e-5)


@any_tendon
@any_jack
@any_set
@any_friction
def test_stress_never_grows_faster_than_friction_allows(tendon, jack, wedge_set, mu, K):
    losses = analytic_losses(tendon, 1300.0, mu, K, EP, wedge_set, jack)
    x = np.linspace(0.0, tendon.breaks[-1], 503)
    x = x[~np.isin(x, tendon.breaks[1:-1])]
    limit = np.diff(mu * tendon.angle(x) + K * tendon.arc_length(x))
    for stress in (losses.stress_jacked(x), losses.stress_anchored(x)):
        assert np.all(np.abs(np.diff(np.log(stress))) <= limit + 1e-12)
    assert np.all(losses.stress_anchored(x) <= losses.stress_jacked(x))


@any_tendon
@any_jack
@any_set
def test_means_and_elongations(tendon, jack, wedge_set):
    losses = analytic_losses(tendon, 1300.0, 0.2, 1e-6, EP, wedge_set, jack)
    x = np.union1d(np.linspace(0.0, tendon.breaks[-1], 4001), tendon.breaks)
    mean = losses.stress_anchored((x[1:] + x[:-1]) / 2.0) @ np.diff(tendon.arc_length(x)) / tendon.length
    assert losses.mean_anchored == pytest.approx(mean, rel=1e-7)
    assert losses.elongation_after == pytest.approx(mean * tendon.length / EP, rel=1e-7)
    assert fpj_for_mean(tendon, mean, 0.2, 1e-6, EP, wedge_set, jack) == pytest.approx(1300.0, rel=1e-7)


@any_set
@any_reversal
def test_right_is_the_mirror_image_of_left(wedge_set, reversal):
    left, right = (twenty(wedge_set=wedge_set, jack=jack, reversal=reversal) for jack in ("left", "right"))
    assert_allclose(left.stress_anchored(QUARTERS), right.stress_anchored(QUARTERS[::-1]), rtol=1e-12)
    assert (right.set_length, right.loss_jacking_end, right.loss_fixed_end) == pytest.approx(
        (left.set_length, left.loss_jacking_end, left.loss_fixed_end), rel=1e-11
    )


def test_two_live_ends_of_an_unsymmetric_tendon_meet_off_the_middle():
    losses = analytic_losses(TENDONS["unsymmetric"], 1300.0, 0.05, 1e-7, EP, 6.0, "both")
    still = losses.still["left"]
    assert still == losses.still["right"] and abs(still - 10000.0) > 10.0
    left, right = (np.exp(losses.friction.exponent(still, end)) * losses.level[end] for end in losses.still)
    assert left == pytest.approx(right, rel=1e-9)
    assert np.ptp(losses.stress_anchored([0.0, 20000.0])) > 0.1


def test_least_stress_of_two_live_ends_with_little_set_is_where_the_jacks_balance():
    losses = analytic_losses(TENDONS["unsymmetric"], 1300.0, 0.3, 1e-6, EP, 0.5, "both")
    assert losses.loss_fixed_end == pytest.approx(1.0 - np.exp(-losses.friction.total / 2.0), rel=1e-12)


@any_jack
@any_reversal
def test_set_that_leaves_the_tendon_slack_is_refused(jack, reversal):
    with pytest.raises(ValueError, match=r"set: 130 mm at each live end leaves the tendon slack"):
        twenty(wedge_set=130.0, jack=jack, reversal=reversal)


def test_unknown_jack_is_refused():
    with pytest.raises(ValueError, match="'middle' is none of left, right, both"):
        twenty(jack="middle")


@pytest.mark.parametrize(
    ("span", "mu"), [((8000.0, 7000.0), 0.2), ((8040.0, 8010.0), 0.262), ((9610.0, 9040.0), 0.277)]
)
def test_two_jacks_that_pull_alike_at_a_kink(span, mu):
    """Closed form: straight parts without wobble, and the least stress beside the kink over the support. Half
    way through it there would be less, but that is the stress of no part of the tendon."""
    losses = analytic_losses(
        profile(span, (150.0, 240.0, 60.0, 240.0, 150.0), "harped"), 1300.0, mu, 0.0, EP, 0.0, "both"
    )
    parts = np.repeat(span, 3) * np.tile([0.3, 0.3, 0.4], 2)
    slopes = np.array([90.0, 0.0, -180.0, 180.0, 0.0, -90.0]) / parts
    kinks = np.abs(np.diff(np.arctan(slopes)))
    beside = max(kinks[:2].sum(), kinks[3:].sum())
    assert kinks.sum() / 2.0 > beside  # the jacks pull alike within the kink
    assert losses.loss_fixed_end == pytest.approx(1.0 - np.exp(-mu * beside), rel=1e-9)
