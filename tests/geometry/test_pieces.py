"""Smooth pieces by their values at Gauss points: integrals and zeros in closed form."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.geometry.curve import GAUSS_POINTS
from ptbatch.geometry.pieces import first_rise, running_integral

EDGES = np.array([0.0, 1.0, 1.5, 4.0])
WIDTH = np.diff(EDGES)[:, None]
X = EDGES[:-1, None] + WIDTH * GAUSS_POINTS


@pytest.mark.parametrize(("end", "exact"), [("left", np.sin(X)), ("right", np.sin(4.0) - np.sin(X))])
def test_integrals_run_up_to_every_point(end, exact):
    assert_allclose(running_integral(WIDTH * np.cos(X), end), exact, atol=1e-14)  # closed form


@pytest.mark.parametrize(
    ("function", "end", "zero"),
    [
        (lambda x: np.exp(x) - 2.0, "left", np.log(2.0)),
        (lambda x: np.exp(x) - np.exp(1.2), "left", 1.2),
        (lambda x: np.exp(-x) - np.exp(-3.3), "right", 3.3),
        (lambda x: np.exp(-x) - np.exp(-0.1), "right", 0.1),
        (lambda x: np.sin(x - 0.4), "left", 0.4),  # the first of its zeros
    ],
)
def test_first_place_above_zero(function, end, zero):
    assert first_rise(EDGES, function(X), 1e-12, end) == pytest.approx(zero, abs=1e-11)  # closed form


@pytest.mark.parametrize("end", ["left", "right"])
def test_a_function_that_stays_below_zero(end):
    assert first_rise(EDGES, -np.exp(X), 1e-12, end) is None


@pytest.mark.parametrize(("end", "edge"), [("left", 1.5), ("right", 1.0)])
def test_a_jump_is_at_its_edge(end, edge):
    values = np.where((X > 1.5) == (end == "left"), 2.0 + X, -3.0 + 0.1 * X)
    values[1] = -1.0
    assert first_rise(EDGES, values, 1e-12, end) == edge


@pytest.mark.parametrize("end", ["left", "right"])
def test_a_zero_at_an_edge(end):
    sense = 1.0 if end == "left" else -1.0
    assert first_rise(EDGES, sense * (X - 1.5), 1e-12, end) == pytest.approx(1.5, abs=1e-14)
