"""Tendon element on its chord."""

import numpy as np
import pytest

from ptbatch.core.tendon import BILINEAR, ELASTIC_TENDON, Strand, tendon_stress
from ptbatch.core.truss import stretch, tensions, truss_tangent, unit
from tests.core.numerics import central_jacobian, turned_by

REST = 700.0
STRAND = Strand(500.0, BILINEAR, 195000.0, 1600.0, 1860.0, 0.035, 0.0, 1.0, 1.0)
STATES = {"elastic": 0.005, "yielding": 0.012, "slack": -0.0002}  # strains
any_state = pytest.mark.parametrize("strain", STATES.values(), ids=STATES.keys())
any_worst = pytest.mark.parametrize("worst", [0.0, 0.015], ids=["first loading", "unloading"])


def chord(strain, angle=-0.1):
    return turned_by(angle) @ [REST * (1.0 + strain), 0.0]


def force(vector, worst=0.0):
    """What the element asks of its far node."""
    length, ex, ey = unit(*vector)
    return tension(stretch(REST, length), worst) * np.array([ex, ey])


def tension(strain, worst):
    """In N."""
    return STRAND.Aps * tendon_stress(strain, worst, STRAND.law, STRAND)


def tension_and_slope(strain, worst, rest, strand):
    """Of one element."""
    found = np.zeros((2, 1))
    tensions(*np.array([[strain], [worst], [rest]]), strand, *found)
    (T,), (slope,) = found
    return T, slope


def test_several_elements_are_each_its_own():
    strains, worst = np.array([0.005, 0.012, -0.0002, 0.009]), np.array([0.0, 0.015, 0.0, 0.009])
    found, slopes = np.zeros((2, 4))
    tensions(strains, worst, REST * np.ones(4), STRAND, found, slopes)
    expected = [tension_and_slope(*pair, REST, STRAND) for pair in zip(strains, worst, strict=True)]
    np.testing.assert_array_equal(np.column_stack([found, slopes]), expected)


@any_state
@any_worst
def test_tangent_is_the_central_difference(strain, worst):
    vector = chord(strain)
    length, ex, ey = unit(*vector)
    T, slope = tension_and_slope(stretch(REST, length), worst, REST, STRAND)
    k = np.empty((2, 2))
    truss_tangent(T, slope, ex, ey, length, k)
    assert T == tension(stretch(REST, length), worst)
    difference = central_jacobian(lambda v: force(v, worst), vector, 1e-4)
    # 1e-4 mm: round-off 1e6 N * 1e-13 / 1e-4 = 1e-3 N/mm of about 1e5
    np.testing.assert_allclose(difference, k, rtol=1e-6, atol=0.01)


def test_force_in_the_elastic_range():
    assert force(chord(0.005, 0.0)) == pytest.approx([500 * 195000 * 0.005, 0.0], rel=1e-12)  # closed form
    assert force(chord(0.0)) == pytest.approx([0.0, 0.0], abs=1e-6)


@pytest.mark.parametrize("angle", [0.9, -3.0])
def test_rigid_rotation_turns_the_force(angle):
    expected = turned_by(angle) @ force(chord(0.005, 0.0))
    np.testing.assert_allclose(force(chord(0.005, angle)), expected, rtol=1e-10, atol=1e-6)


def test_stress_across_the_chord_is_stiffness_of_the_force_alone():
    """A taut string: T / length across itself (closed form), whatever the steel."""
    elastic = STRAND._replace(law=ELASTIC_TENDON)
    T, slope = tension_and_slope(0.005, 0.0, REST, elastic)
    k = np.empty((2, 2))
    truss_tangent(T, slope, 1.0, 0.0, REST * 1.005, k)
    np.testing.assert_allclose(k, np.diag([500 * 195000 / REST, T / (REST * 1.005)]), rtol=1e-12)
