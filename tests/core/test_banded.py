"""Banded LU against numpy's dense solver."""

import numpy as np
import pytest

from ptbatch.core.banded import factorise, substitute


def random_band(n, half, seed, weak_diagonal=True):
    """Dense matrix of that bandwidth; small diagonal terms, so that rows must be swapped."""
    rng = np.random.default_rng(seed)
    away = np.abs(np.subtract.outer(np.arange(n), np.arange(n)))
    dense = np.where(away <= half, rng.standard_normal((n, n)), 0.0)
    if weak_diagonal:
        dense[np.diag_indices(n)] *= 1e-6
    return dense


def banded(dense, half):
    """Rows as the kernels keep them: column j of row i at j - i + half, and room to the right."""
    n = len(dense)
    wide = np.pad(dense, ((0, 0), (half, 2 * half)))
    return np.array([wide[i, i : i + 3 * half + 1] for i in range(n)])


def solve(dense, half, *sides):
    """Whether it could be factorised, the pivots, and the solutions."""
    n = len(dense)
    a, weights, multipliers = banded(dense, half), np.zeros(n), np.zeros((n, half))
    pivots, reach = np.zeros((2, n), np.int64)
    if not factorise(a, weights, multipliers, pivots, reach):
        return False, pivots, []
    solutions = [sides[0].copy(), sides[-1].copy()]
    substitute(a, multipliers, pivots, reach, *solutions)
    return True, pivots, solutions[: len(sides)]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    ("n", "half"), [(1, 1), (2, 1), (9, 1), (12, 3), (40, 4), (107, 9), (107, 14), (10, 12)]
)
def test_against_a_dense_solver(n, half, seed):
    dense = random_band(n, half, seed)
    sides = np.random.default_rng(seed + 100).standard_normal((2, n))
    sound, pivots, found = solve(dense, half, *sides)
    assert sound
    assert n == 1 or np.any(pivots != np.arange(n))  # these matrices do need their rows swapped
    for b, x in zip(sides, found, strict=True):
        # both solvers leave round-off times the condition number, which is below 1e6 here
        np.testing.assert_allclose(x, np.linalg.solve(dense, b), rtol=1e-8, atol=1e-9 * np.abs(x).max())


def test_zeros_on_the_diagonal():
    dense = np.array([[0.0, 2.0, 0.0], [1.0, 0.0, 3.0], [0.0, 4.0, 0.0]]) + np.diag([0.0, 0.0, 1.0])
    sound, _, (x,) = solve(dense, 1, np.array([2.0, 7.0, 6.0]))
    assert sound
    np.testing.assert_allclose(x, [1.0, 1.0, 2.0], rtol=1e-14)  # closed form


def test_the_units_of_a_row_do_not_decide_on_swaps():
    dense = random_band(60, 5, 3, weak_diagonal=False)
    units = 10.0 ** np.random.default_rng(5).integers(-6, 7, 60)
    b = np.random.default_rng(6).standard_normal(60)
    _, pivots, (x,) = solve(dense, 5, b)
    _, pivots_in_units, (x_in_units,) = solve(units[:, None] * dense, 5, units * b)
    np.testing.assert_array_equal(pivots_in_units, pivots)
    np.testing.assert_allclose(x_in_units, x, rtol=1e-9)  # the same equations


def test_a_diagonal_that_is_large_enough_stays():
    _, pivots, _ = solve(np.array([[0.2, 1.0], [1.0, 0.2]]), 1, np.ones(2))
    assert pivots[0] == 0
    _, pivots, _ = solve(np.array([[0.05, 1.0], [1.0, 0.2]]), 1, np.ones(2))
    assert pivots[0] == 1


def test_unsymmetric_not_its_transpose():
    dense = np.array([[2.0, 1.0, 0.0], [0.0, 1.0, 5.0], [0.0, 0.0, 4.0]])
    _, _, (x,) = solve(dense, 1, np.array([3.0, 6.0, 4.0]))
    np.testing.assert_allclose(x, [1.0, 1.0, 1.0], rtol=1e-15)  # closed form


@pytest.mark.parametrize("wrong", ["zero column", "zero row", "nan", "inf"])
def test_singular_is_detected(wrong):
    dense = random_band(30, 4, 7)
    if wrong == "zero column":
        dense[:, 17] = 0.0
    elif wrong == "zero row":
        dense[29] = 0.0
    else:
        dense[12, 12] = float(wrong)
    assert not solve(dense, 4)[0]


def test_mechanism_is_detected():
    """A chain of springs that nothing holds; whole numbers, so that its last pivot is exactly zero."""
    chain = 2.0 * np.eye(8) - np.eye(8, k=1) - np.eye(8, k=-1)
    chain[0, 0] = chain[-1, -1] = 1.0
    assert not solve(chain, 1)[0]
    chain[0, 0] = 2.0
    assert solve(chain, 1, np.ones(8))[0]
