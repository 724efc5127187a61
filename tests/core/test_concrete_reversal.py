"""Concrete on reversal: cracks stay open, what is crushed stays crushed, and stress stays continuous."""

import numpy as np
import pytest

from tests.core.fibres import EC, EPS_CR, FT, LAWS, TENSIONS, commit, history, law, modulus, stress

any_curved = pytest.mark.parametrize("concrete_law", LAWS[:3])
any_tension = pytest.mark.parametrize("tension_law", TENSIONS)


@pytest.mark.parametrize("tension_law", ["softening", "stiffening"])
def test_an_opened_crack_never_carries_ft_again(tension_law):
    c = law(tension_law=tension_law)
    past = history(c, 3 * EPS_CR)
    worst = stress(3 * EPS_CR, c)
    back = [stress(e, c, past) for e in np.linspace(0.0, 3 * EPS_CR, 50)]
    assert back[0] == 0.0 and max(back) == pytest.approx(worst, rel=1e-12)
    assert stress(1.5 * EPS_CR, c, past) == pytest.approx(0.5 * worst, rel=1e-12)  # closed form: the secant
    assert stress(5 * EPS_CR, c, past) == stress(5 * EPS_CR, c)  # beyond the worst: first loading
    assert stress(EPS_CR, c, history(c, 20 * EPS_CR)) == 0.0  # open for good


@any_curved
@pytest.mark.parametrize("worst", [0.0006, 0.0030])
def test_crushed_concrete_regains_no_strength(concrete_law, worst):
    c = law(concrete_law)
    past = history(c, -worst)
    residual, top = past[4], stress(-worst, c)
    back = [stress(-e, c, past) for e in np.linspace(residual, worst, 50)]
    np.testing.assert_allclose(
        back, np.linspace(0.0, top, 50), rtol=1e-12, atol=1e-12
    )  # closed form: straight
    assert modulus(-0.9 * worst, c, past) <= c.E0 * (1 + 1e-12)
    assert stress(-1.1 * worst, c, past) == stress(-1.1 * worst, c)  # beyond the worst: first loading


@pytest.mark.parametrize(
    ("concrete_law", "ratio", "residual"),
    [("hognestad", 1.2, 0.3648), ("hognestad", 0.2, 0.02), ("parabola-rectangle", 1.5, 0.52125)],
)
def test_residual_strain(concrete_law, ratio, residual):
    # Published: Karsan and Jirsa's 0.145 r^2 + 0.13 r of eps_c. Closed form where that unloads too steeply
    # (r = 0.2): a parabola left with its initial modulus keeps r^2 / 2.
    c = law(concrete_law)
    assert history(c, -ratio * c.eps_c)[4] == pytest.approx(residual * c.eps_c, rel=1e-12)


@any_curved
def test_tension_counts_from_the_residual_strain(concrete_law):
    c = law(concrete_law, "softening")
    past = history(c, -0.0010)
    assert stress(-past[4], c, past) == 0.0
    assert stress(EPS_CR - past[4], c, past) == pytest.approx(FT, rel=1e-9)  # closed form
    assert stress(3 * EPS_CR - past[4], c, past) == pytest.approx(stress(3 * EPS_CR, c), rel=1e-9)


@any_curved
@any_tension
def test_stress_stays_continuous_and_within_the_laws_through_any_history(concrete_law, tension_law):
    c, past, before = law(concrete_law, tension_law), np.zeros(6), 0.0
    turns = [0.0, -0.0006, 3 * EPS_CR, -0.0012, -0.0002, 5 * EPS_CR, -0.0031, 15 * EPS_CR, -0.0036, 0.0]
    steepest = max(EC, c.E0)
    for start, stop in zip(turns, turns[1:], strict=False):
        path = np.linspace(start, stop, 2000)
        for eps in path:
            now = stress(eps, c, past)
            assert abs(now - before) <= 1.001 * steepest * abs(path[1] - path[0])
            assert -c.fc <= now <= FT
            before = now
            commit(eps, past, c)


def test_a_crack_that_has_closed_under_compression_is_still_a_crack():
    c = law(tension_law="softening")
    past = history(c, 5.5 * EPS_CR, -0.0030)
    opened = [stress(e - past[4], c, past) for e in np.linspace(0.0, 5.5 * EPS_CR, 50)]
    assert max(opened) == pytest.approx(0.5 * FT, rel=1e-9)  # closed form: half way down, never above


def test_elastic_law_is_straight_on_reversal():
    c = law("elastic")
    past = history(c, -0.002, 0.002)
    for eps in (-0.001, 0.0005, 0.001):
        assert stress(eps, c, past) == pytest.approx(EC * eps, rel=1e-12)  # closed form
