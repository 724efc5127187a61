"""Elongations as a site reads them."""

import pytest

from ptbatch.analysis import analyse
from ptbatch.design.elongation import Elongation, elongations, inches
from ptbatch.member import Member


@pytest.mark.parametrize(
    ("mm", "text"),
    [(25.4, "1"), (3.175, "1/8"), (85.725, "3 3/8"), (87.0, "3 3/8"), (88.9, "3 1/2"), (0.5, "0")],
)
def test_inches(mm, text):
    assert inches(mm) == text  # closed form


def test_band():
    one = Elongation("left", 200e3, 90.0, 84.0)
    assert (one.least, one.most) == (pytest.approx(78.12), pytest.approx(89.88))  # closed form: 7 %
    assert (one.rounded, one.warning) == ("84 mm; 3 1/4 in", "")


def test_a_short_tendon_cannot_be_read_well_enough():
    """Closed form: half of 1/8 in is 1.59 mm, 7 % of 20 mm are 1.4; half a millimetre is 7 % of 7.1 mm."""
    assert Elongation("left", 200e3, 26.0, 20.0).warning == "rounding to 1/8 in alone exceeds 7 %"
    assert Elongation("left", 200e3, 12.0, 6.0).warning == "rounding to 1 mm or 1/8 in alone exceeds 7 %"


@pytest.mark.parametrize("friction", [{}, {"mu": 0, "K": 0}])
def test_two_jacks_on_a_symmetric_member_stretch_the_tendon_alike(friction):
    """By symmetry; together they make what the summary tells."""
    strip = dict(span=(8000, 9000, 8000), dp=(100, 160, 40, 160, 40, 160, 100), As=393, ds=170)
    member = Member(member="S", b=1000, h=200, fc=32, Aps=300, fpj=1395, jack="both", **strip, **friction)
    response = analyse(member)
    left, right = elongations(member, response)
    assert left.before == pytest.approx(right.before, rel=1e-3)
    assert left.before + right.before == pytest.approx(response.elongation_before, rel=1e-12)
