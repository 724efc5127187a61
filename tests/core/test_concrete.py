"""Concrete laws on first loading: marked points, tangent, continuity."""

import numpy as np
import pytest

from tests.core.fibres import EC, EPS_CR, FT, LAWS, TENSIONS, law, modulus, stress
from tests.core.numerics import central_slope

any_law = pytest.mark.parametrize("concrete_law", LAWS)
any_tension = pytest.mark.parametrize("tension_law", TENSIONS)


# Closed form: what the laws say, in their own words.
@pytest.mark.parametrize(
    ("concrete_law", "fc", "eps", "sigma"),
    [
        ("hognestad", 40.0, 2 * 40 / EC, 40.0),  # top of the parabola that starts with Ec
        ("hognestad", 40.0, 40 / EC, 30.0),  # half way: 3/4
        ("hognestad", 40.0, 0.0038, 34.0),  # 0.85 fc at the crushing strain
        ("hognestad", 40.0, 0.0060, 34.0),  # held beyond
        ("parabola-rectangle", 40.0, 0.001, 30.0),
        ("parabola-rectangle", 40.0, 0.002, 40.0),
        ("parabola-rectangle", 40.0, 0.0035, 40.0),
        (
            "parabola-rectangle",
            90.0,
            0.0013,
            90 * (1 - 0.5**1.4),
        ),  # EN 1992-1-1 table 3.1: eps_c2 0.26 %, n 1.4
        ("elastic", 40.0, 0.002, 0.002 * EC),
    ],
)
def test_compression_at_marked_points(concrete_law, fc, eps, sigma):
    # 2e-4: table 3.1 is rounded (0.26 % stands for 0.2600 %); the others are exact
    assert stress(-eps, law(concrete_law, fc=fc)) == pytest.approx(-sigma, rel=2e-4 if fc > 50 else 1e-12)


def test_popovics_peaks_at_fc_with_a_level_tangent():
    c = law("popovics")
    n = 0.8 + 40 / 17  # closed form, Collins and Mitchell
    eps_c = 40 / EC * n / (n - 1)
    assert stress(-eps_c, c) == pytest.approx(-40.0, rel=1e-12)
    assert modulus(-eps_c, c) == pytest.approx(0.0, abs=1e-9 * EC)


@pytest.mark.parametrize("concrete_law", ["hognestad", "popovics", "elastic"])
def test_laws_start_with_their_modulus(concrete_law):
    c = law(concrete_law)  # closed form; 1e-6 off the origin the tangent has dropped by 2e-6 / eps_c at most
    assert modulus(-1e-6, c) == pytest.approx(EC, rel=1e-3)


@pytest.mark.parametrize(
    ("tension_law", "multiple", "share"),
    [
        ("none", 0.5, 0.0),
        ("softening", 1.0, 1.0),
        ("softening", 5.5, 0.5),  # half way to 10 eps_cr
        ("softening", 10.0, 0.0),
        ("stiffening", 1.0, 1.0),
        (
            "stiffening",
            1.25,
            0.77,
        ),  # on the line from 0.8 at cracking to 0.45 at 4 eps_cr: 0.7708, written 0.77
        ("stiffening", 4.0, 0.45),  # Nayal and Rasheed
        ("stiffening", 10.0, 0.0),
        ("stiffening", 20.0, 0.0),
    ],
)
def test_tension_at_marked_points(tension_law, multiple, share):
    c = law(tension_law=tension_law)
    assert stress(multiple * EPS_CR, c) == pytest.approx(share * FT, rel=1e-9, abs=1e-12)  # closed form


@any_law
@any_tension
def test_tangent_is_the_derivative(concrete_law, tension_law):
    c = law(concrete_law, tension_law)
    for eps in (
        -0.0041,
        -0.0029,
        -0.0011,
        -3e-4,
        0.3 * EPS_CR,
        1.1 * EPS_CR,
        2 * EPS_CR,
        7 * EPS_CR,
        30 * EPS_CR,
    ):
        slope = modulus(eps, c)
        # the difference of stresses around 40 MPa over 2e-9 keeps 1e-14 * 40 / 2e-9 = 2e-4 MPa
        assert slope == pytest.approx(central_slope(lambda e: stress(e, c), eps, 1e-9), rel=1e-5, abs=0.01)


@any_law
@any_tension
def test_stress_is_a_continuous_function_of_strain(concrete_law, tension_law):
    c = law(concrete_law, tension_law)
    eps = np.linspace(-0.005, 0.002, 70001)
    step = eps[1] - eps[0]
    steepest = max(EC, c.exponent * c.fc / c.eps_c)  # of any branch here
    assert np.abs(np.diff([stress(e, c) for e in eps])).max() <= 1.001 * steepest * step
