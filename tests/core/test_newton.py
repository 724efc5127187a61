"""Newton's method: when a series of residuals is given up."""

import numpy as np
import pytest

from ptbatch.core.newton import repeats


def given_up(residuals) -> int | None:
    """The iteration in which they are; None where they never are."""
    norms = np.full(16, np.nan)
    return next((i for i, norm in enumerate(residuals) if repeats(norm, i, norms)), None)


@pytest.mark.parametrize(
    "cycle", [(1.0, 0.01), (1.7, 0.007, 3.1, 0.005), (1.5, 0.003, 4.1, 0.003, 0.4, 0.001)]
)
def test_a_series_that_comes_back_is_given_up_when_it_has_done_so_once(cycle):
    """After what leads into it, and the more exactly the later, as damping dies away."""
    lead = [0.02, 0.3, 0.09]
    series = [norm * (1.0 + 0.02 * 0.7**i) for i, norm in enumerate(10 * cycle)]
    assert given_up(lead + series) == len(lead) + 2 * len(cycle) - 1


@pytest.mark.parametrize(
    "residuals",
    [
        0.5 ** np.arange(40.0),
        0.97 ** np.arange(40.0),  # slow, but on its way
        0.6 ** np.arange(40.0) * np.tile([1.0, 30.0], 20),  # up and down, and on its way
    ],
)
def test_what_goes_on_is_not(residuals):
    assert given_up(residuals) is None
