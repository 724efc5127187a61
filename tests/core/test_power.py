"""Powers of positive numbers against those of the library, and their derivative."""

import numpy as np
import pytest

from ptbatch.core.power import MOST, exp2, log2, positive_power, power
from tests.core.numerics import complex_slope


def test_logarithm_and_power_of_two():
    x = np.geomspace(1e-300, 1e300, 20_001)
    np.testing.assert_allclose([log2(v) for v in x], np.log2(x), rtol=2e-15, atol=2e-16)
    y = np.linspace(-999.0, 999.0, 20_001)
    np.testing.assert_allclose([exp2(v) for v in y], np.exp2(y), rtol=2e-15)
    whole = np.arange(-60.0, 61.0)
    assert [exp2(v) for v in whole] == [2.0**v for v in whole]  # closed form, to the last digit
    assert [log2(2.0**v) for v in whole] == whole.tolist()


@pytest.mark.parametrize("exponent", [1.4, 2.43, 4.33, -0.1, 10.0])
def test_powers_are_those_of_the_library(exponent):
    x = np.concatenate([np.linspace(1e-9, 3.0, 10_001), np.geomspace(1e-15, 1e3, 1_001)])
    # an error of 1e-16 in log2 counts by exponent * log2(x) in the power: up to 500 of them here
    np.testing.assert_allclose([positive_power(v, exponent) for v in x], x**exponent, rtol=1e-13)


def test_what_is_beyond_any_number_stays_finite():
    assert positive_power(1e-200, 3.0) == 2.0**-MOST
    assert positive_power(1e200, 3.0) == 2.0**MOST


@pytest.mark.parametrize("x", [1e-3, 0.5, 1.0, 1.9])
def test_derivative(x):
    assert complex_slope(lambda z: power(z, 2.43), x) == pytest.approx(
        2.43 * x**1.43, rel=1e-13
    )  # closed form
