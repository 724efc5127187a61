"""Cracked sections and crack widths: closed form."""

import pytest

from ptbatch.design.ec2 import cracks
from tests.design.test_checks import LIGHT, made

STRIPS = [(600.0, 300.0)]


def test_a_section_without_prestress():
    """b x^2 / 2 = n As (d - x); the lever arm is d - x / 3."""
    n, As, d = 200.0 / 30.0, 1500.0, 540.0
    x = (-n * As + ((n * As) ** 2 + 2 * 300 * n * As * d) ** 0.5) / 300
    found = cracks.cracked(STRIPS, [(As, d)], 30e3, 200e3, (500.0, 0.0), 1e-6, 150e6)
    assert found.x == pytest.approx(x, rel=1e-6)
    assert found.bar_stress == pytest.approx(150e6 / (As * (d - x / 3)), rel=1e-6)


def test_with_prestress_forces_and_moments_balance():
    """Statics of the triangle of compression, the bars, and the tendon's force."""
    P, M, As, d, dp = 500e3, 250e6, 1000.0, 550.0, 480.0
    found = cracks.cracked(STRIPS, [(As, d)], 30e3, 200e3, (dp, 0.0), P, M)
    top = found.bar_stress / 200e3 * found.x / (d - found.x) * 30e3
    compression = 0.5 * top * found.x * 300
    assert compression == pytest.approx(P + As * found.bar_stress, rel=1e-6)
    moment = P * (dp - found.x / 3) + As * found.bar_stress * (d - found.x / 3)
    assert moment == pytest.approx(M, rel=1e-6)


def test_a_compressed_section_is_not_cracked():
    assert cracks.cracked(STRIPS, [(1000.0, 550.0)], 30e3, 200e3, (300.0, 0.0), 500e3, 10e6) is None


def test_crack_width():
    """(7.9) and (7.11) with numbers: sigma,s 250, rho 0.02, c 30, 16 mm, C30."""
    strain = max((250 - 0.4 * 2.9 / 0.02 * (1 + 200 / 33 * 0.02)) / 200e3, 0.6 * 250 / 200e3)
    expected = (3.4 * 30 + 0.17 * 16 / 0.02) * strain
    assert cracks.width(250, 200e3, 33e3, 2.9, 0.02, 30, 16) == pytest.approx(expected)


@pytest.mark.parametrize(
    "bond, exposure, width",
    [("unbonded", "XC1", 0.4), ("unbonded", "XD1", 0.3), ("bonded", "XC3", 0.2), ("bonded", "XS1", None)],
)
def test_table_7_1n(bond, exposure, width):
    assert cracks.widest(bond, exposure) == width


def test_of_a_member():
    """Uncracked: nothing opens. Cracked: a width, and without bars a review."""
    code = dict(standard="EN 1992-1-1", live_sustained=0.3)
    assert made(**code)[2]["crack width, quasi-permanent"].demand == 0.0
    cracked = made(**code, w_live=80)[2]["crack width, quasi-permanent"]
    numbers = {value.symbol: value.value for value in cracked.values}
    rest = numbers["rho,p,eff"], numbers["c"], numbers["diameter"]
    wk = cracks.width(numbers["sigma,s"], 200e3, 22e3 * 4.8**0.3, numbers["fctm"], *rest)
    assert cracked.demand == pytest.approx(wk)
    assert (numbers["c"], numbers["fctm"]) == (600 - 550 - 8, pytest.approx(0.3 * 40 ** (2 / 3)))
    bare = made(LIGHT | dict(As=0, ds=0), **code, w_live=80)[2]["crack width, quasi-permanent"]
    assert bare.outcome == "review" and "without bars" in bare.reason
    wet = made(**code, exposure="XD1", bond="bonded")[2]
    assert wet["decompression, frequent"].outcome in ("pass", "review")
    assert "crack width, frequent" not in wet
