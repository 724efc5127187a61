"""EN 1992-1-1: the tables' own marks, and bending by the stress block."""

import pytest

from ptbatch.design.ec2.flexure import block, fctm, least_reinforcement, unbonded_stress
from ptbatch.design.ec2.stress_limits import after_transfer, jacking
from ptbatch.design.flexure import Steel, constant, elastic_plastic, strength


@pytest.mark.parametrize(
    ("fck", "expected"), [(20, 2.2), (30, 2.9), (40, 3.5), (50, 4.1), (60, 4.4), (90, 5.0)]
)
def test_tensile_strength(fck, expected):
    assert fctm(fck) == pytest.approx(expected, abs=0.05)  # published: table 3.1, rounded


@pytest.mark.parametrize(
    ("fck", "strain", "share", "eta"),
    [(30, 0.0035, 0.8, 1.0), (50, 0.0035, 0.8, 1.0), (70, 0.0027, 0.75, 0.9), (90, 0.0026, 0.7, 0.8)],
)
def test_stress_block(fck, strain, share, eta):
    found = block(fck)
    assert found.strain == pytest.approx(strain, abs=5e-5)  # published: table 3.1, rounded
    assert found.share == pytest.approx(share) and found.stress == pytest.approx(eta * fck / 1.5)


def test_bending_resistance_of_a_rectangle():
    """Closed form: 300 x 550, As 1500 mm2, fyd 435, fcd 20: x = 1500 * 435 / (0.8 * 300 * 20)."""
    found = strength([(600.0, 300.0)], block(30.0), [Steel(550.0, 1500.0, elastic_plastic(2e5, 435.0))])
    assert found.c == pytest.approx(1500 * 435 / (0.8 * 300 * 20), rel=1e-9)
    assert found.moment == pytest.approx(1500 * 435 * (550 - 0.4 * found.c), rel=1e-9)


def test_no_strength_without_steel_and_none_beyond_the_concrete():
    assert strength([(600.0, 300.0)], block(30.0), [Steel(550.0, 0.0, constant(1000.0))]) is None
    assert strength([(600.0, 300.0)], block(30.0), [Steel(550.0, 1e6, constant(1000.0))]) is None


def test_stress_limits():
    assert jacking(1860, 1640) == pytest.approx(1476)  # closed form: 0.9 fp0.1k
    assert after_transfer(1860, 1640) == pytest.approx(1394)  # 0.85 fp0.1k
    assert jacking(1860, 1800) == pytest.approx(1488)  # 0.8 fpk


def test_unbonded_tendons_and_least_reinforcement():
    assert unbonded_stress(1100.0) == 1200.0  # closed form, as below
    assert least_reinforcement(30, 500, 300, 550) == pytest.approx(0.26 * fctm(30) / 500 * 300 * 550)
    assert least_reinforcement(12, 500, 300, 550) == pytest.approx(0.0013 * 300 * 550)
