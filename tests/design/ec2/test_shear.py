"""Shear of EN 1992-1-1: closed form by the printed expressions."""

import pytest

from ptbatch.design.ec2 import shear
from tests.design.test_checks import LIGHT, made


def test_without_stirrups():
    """C30, 300 x 500, rho 1 %: 0.12 k (100 rho fck)^(1/3), no less than 0.035 k^1.5 sqrt(fck); 0.15 of the
    compression."""
    k = 1 + (200 / 500) ** 0.5
    expected = (0.12 * k * 30 ** (1 / 3) + 0.15 * 2.0) * 300 * 500
    assert shear.without_stirrups(30, 300, 500, 0.01, 2.0) == pytest.approx(expected)
    least = (0.035 * k**1.5 * 30**0.5) * 300 * 500
    assert shear.without_stirrups(30, 300, 500, 0.0, 0.0) == pytest.approx(least)


def test_with_stirrups():
    """Few: struts at cot 2.5. Many: where stirrups and struts give way together; crushing bounds it."""
    few = shear.with_stirrups(30, 300, 450, 0.5, 500, 0.0)
    assert few == pytest.approx(0.5 * 450 * 500 / 1.15 * 2.5)
    nu, fcd = 0.6 * (1 - 30 / 250), 20.0
    most = 300 * 450 * nu * fcd / 2
    assert shear.with_stirrups(30, 300, 450, 50.0, 500, 0.0) == pytest.approx(most)
    between = shear.with_stirrups(30, 300, 450, 2.5, 500, 0.0)
    cot = (300 * nu * fcd / (2.5 * 500 / 1.15) - 1) ** 0.5
    assert 1.0 < cot < 2.5
    assert between == pytest.approx(2.5 * 450 * 500 / 1.15 * cot)


@pytest.mark.parametrize("share, factor", [(0.0, 1.0), (0.2, 1.2), (0.4, 1.25), (0.8, 0.5)])
def test_compressed_struts(share, factor):
    assert shear.squeezed(share * 20.0, 20.0) == pytest.approx(factor)


def test_of_a_member():
    """VEd less the vertical part of the prestress, an effective depth from the support."""
    member, response, found = made(LIGHT, standard="EN 1992-1-1", Av=157, s=200)
    numbers = {value.symbol: value.value for value in found["shear"].values}
    w = 1.35 * (24e-6 * 300 * 600 + 5) + 1.5 * 10
    assert numbers["V"] == pytest.approx(w * abs(4500 - found["shear"].x) / 1e3, rel=1e-6)
    assert found["shear"].demand == pytest.approx(abs(numbers["V"] - numbers["Vp"]))
    assert found["least stirrups"].demand == pytest.approx(0.08 * 40**0.5 / 420 * 300 * 200)


def test_a_tendon_that_falls_the_wrong_way_adds_to_the_shear():
    """A straight line from one side to the other helps at one end, and harms at the other."""
    sloping = dict(profile="harped", dp=(200, 300, 400), harp=0.5)
    numbers = {}
    for dp in ((200, 300, 400), (400, 300, 200)):
        found = made(LIGHT, **sloping | dict(dp=dp), standard="EN 1992-1-1")[2]["shear"]
        numbers[dp] = {value.symbol: value.value for value in found.values} | {"x": found.x}
    assert all(one["Vp"] < 0.0 for one in numbers.values())  # the worst is where it harms
    assert numbers[(200, 300, 400)]["x"] > 4500 > numbers[(400, 300, 200)]["x"]
