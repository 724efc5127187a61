"""What kernels take by reference is what Python holds: every field, down to the tuples within tuples."""

from typing import NamedTuple

import numba
import numpy as np
import pytest

from ptbatch.core.reference import Reference


class Plain(NamedTuple):
    """Without arrays: it goes into the kernel by value."""

    whole: int
    yes: bool
    pair: tuple


class Inner(NamedTuple):
    """Arrays of other kinds."""

    flags: np.ndarray
    turned: np.ndarray


class Outer(NamedTuple):
    """Everything that a case is made of."""

    number: float
    plain: Plain
    inner: Inner
    matrix: np.ndarray
    counts: np.ndarray


def values(columns=3):
    matrix = np.arange(2.0 * columns).reshape(2, columns)
    inner = Inner(np.array([True, False]), np.asfortranarray(matrix))
    return Outer(0.5, Plain(7, True, (1.5, 2)), inner, matrix, np.array([4, 5, 6]))


@numba.njit
def scalars(given):
    plain = given.plain
    return given.number, plain.whole, plain.yes, plain.pair[0], plain.pair[1], given.matrix.shape


@numba.njit
def elements(given):
    matrix, turned = given.matrix, given.inner.turned
    last = matrix.shape[1] - 1
    return matrix[1, last], turned[1, 0], turned[0, last], given.inner.flags[1], given.counts[-1]


@numba.njit
def fill(given):
    given.matrix[:] = given.number
    given.inner.turned[1, 1] = -1.0
    given.counts[0] += given.counts.size


@pytest.mark.parametrize("columns", [3, 5])
def test_a_kernel_reads_what_the_tuple_holds(columns):
    reference = Reference(values(columns))
    assert scalars(reference) == (0.5, 7, True, 1.5, 2, (2, columns))
    assert elements(reference) == (2.0 * columns - 1.0, float(columns), columns - 1.0, False, 6)


def test_arrays_are_shared_not_copied():
    given = values()
    fill(Reference(given))
    assert (given.matrix == 0.5).all()
    assert given.inner.turned[1, 1] == -1.0
    assert given.counts.tolist() == [7, 5, 6]


def test_arrays_live_as_long_as_the_reference():
    reference = Reference(values())
    others = [values() for _ in range(100)]  # would take the place of arrays that are gone
    fill(reference)
    assert scalars(reference)[0] == 0.5
    assert elements(reference)[0] == 0.5
    assert all(other.matrix[0, 1] == 1.0 for other in others)


def test_tuples_of_other_types_are_told_apart():
    given = values()
    other = given._replace(matrix=given.matrix.astype(np.int64))
    kinds = {Reference(each).kind for each in (given, values(5), other)}
    assert len(kinds) == 2
    assert elements(Reference(other))[0] == 5
    assert isinstance(elements(Reference(other))[0], int)


def test_there_is_no_other_field():
    with pytest.raises(numba.TypingError, match="nowhere"):
        numba.njit(lambda given: given.nowhere)(Reference(values()))
