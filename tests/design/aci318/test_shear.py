"""One-way shear of ACI 318-19: closed form by the printed expressions, in psi and inches."""

import pytest

from ptbatch.design.aci318 import PSI, shear
from ptbatch.member import MemberError
from tests.design.test_checks import LIGHT, made

IN, LB = 25.4, 4.4482216152605
FC, BW, D = 6000 * PSI, 12 * IN, 20 * IN
ROOT = 6000**0.5


def lb(force):
    """N to lb."""
    return force / LB


@pytest.mark.parametrize(
    "ratio, stress",
    [(0.01, 2 * ROOT), (0.3, 0.6 * ROOT + 210), (0.9, 5 * ROOT), (5.0, 5 * ROOT)],
)
def test_table_22_5_6_2(ratio, stress):
    assert lb(shear.approximate(FC, BW, D, ratio)) == pytest.approx(stress * 12 * 20, rel=1e-6)


def test_the_root_counts_up_to_100_psi():
    assert shear.root(16_000 * PSI) == pytest.approx(100 * PSI)


def test_cracks_in_flexure_and_in_the_web():
    kip_in = 1000 * LB * IN
    by_moment = shear.flexure_shear(FC, BW, D, 5e3 * LB, 20e3 * LB, 2000 * kip_in, 1600 * kip_in)
    assert lb(by_moment) == pytest.approx(0.6 * ROOT * 240 + 5e3 + 25e3, rel=1e-6)
    least = shear.flexure_shear(FC, BW, D, 0.0, 1.0, 0.0, 1600 * kip_in)
    assert lb(least) == pytest.approx(1.7 * ROOT * 240, rel=1e-6)
    in_web = shear.web_shear(FC, BW, D, 400 * PSI, 3e3 * LB)
    assert lb(in_web) == pytest.approx((3.5 * ROOT + 120) * 240 + 3e3, rel=1e-6)


def test_stirrups():
    """2 legs #3 at 10 in: 0.22 x 60 x 20 / 10 = 26.4 kip; least by table 9.6.3.4."""
    assert lb(shear.stirrups(0.22 * IN**2, 10 * IN, 60e3 * PSI, D)) == pytest.approx(26.4e3, rel=1e-6)
    plain = max(0.75 * ROOT, 50) * 12 / 60e3
    assert shear.least_stirrups(FC, BW, D, 60e3 * PSI, None) / IN == pytest.approx(plain, rel=1e-6)
    pulled = 0.5 * 270 / (80 * 60 * 20) * (20 / 12) ** 0.5
    found = shear.least_stirrups(FC, BW, D, 60e3 * PSI, (0.5 * IN**2, 270e3 * PSI))
    assert found / IN == pytest.approx(min(plain, pulled), rel=1e-6)


def test_of_a_member():
    """Vu by statics at half a depth from the support, Vc by the table with Vu dp / Mu."""
    member, response, found = made(LIGHT, Av=157, s=200)
    check = found["shear"]
    w = 1.2 * (24e-6 * 300 * 600 + 5) + 1.6 * 10
    assert check.demand == pytest.approx(
        w * (4500 - check.x if check.x < 4500 else check.x - 4500) / 1e3, rel=1e-6
    )
    numbers = {value.symbol: value.value for value in check.values}
    assert numbers["Vs"] == pytest.approx(157 * 420 * numbers["d"] / 200 / 1e3)
    assert check.limit == pytest.approx(0.75 * (numbers["Vc"] + numbers["Vs"]))
    assert check.outcome == "pass"
    assert made(LIGHT, w_live=150, Av=0)[2]["shear"].outcome == "fail"
    assert "least stirrups" in made(LIGHT, w_live=40)[2]


def test_stirrups_need_a_spacing():
    with pytest.raises(MemberError, match="s: missing, and stirrups Av are given"):
        made(LIGHT, Av=157)
