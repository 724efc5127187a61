"""The bracketed root search."""

from math import cos, exp, sqrt

import pytest

from ptbatch.roots import root

CASES = {
    "square root": (lambda x: x * x - 2.0, 0.0, 2.0, sqrt(2.0)),
    "other way round": (lambda x: 2.0 - x * x, 2.0, 0.0, sqrt(2.0)),
    "fixed point": (lambda x: cos(x) - x, 0.0, 1.0, 0.7390851332151607),
    "flat": (lambda x: (x - 1.0) ** 9, -1.0, 4.0, 1.0),
    "steep": (lambda x: exp(50.0 * x) - 2.0, -1.0, 1.0, 0.013862943611198906),
    "step": (lambda x: 1.0 if x > 0.3 else -1.0, 0.0, 1.0, 0.3),
    "at the left end": (lambda x: x, 0.0, 1.0, 0.0),
    "at the right end": (lambda x: x - 1.0, 0.0, 1.0, 1.0),
}


@pytest.mark.parametrize(("f", "a", "b", "wanted"), CASES.values(), ids=CASES)
def test_it_is_found(f, a, b, wanted):
    calls = []
    assert root(lambda x: calls.append(x) or f(x), a, b) == pytest.approx(wanted, abs=1e-11)
    assert len(calls) < 60


def test_tolerance():
    rough = root(lambda x: cos(x) - x, 0.0, 1.0, xtol=1e-3)
    assert 0.0 < abs(rough - 0.7390851332151607) < 1e-3


def test_no_change_of_sign():
    with pytest.raises(ValueError, match="no change of sign between 1 and 2"):
        root(lambda x: x, 1.0, 2.0)
