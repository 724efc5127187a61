"""What a prestress balances, in closed form."""

import numpy as np
import pytest

from ptbatch.analysis import analyse
from ptbatch.design.balance import about_prestress, balanced, least_radius
from ptbatch.design.subject import Subject
from ptbatch.member import Member

BEAM = dict(
    member="B", span=10_000, b=300, h=600, fc=40, Aps=500, fpj=1300, long_term_loss=100, elements=4, layers=8
)


def test_a_parabola():
    member = Member(**BEAM, dp=(300, 500, 300))
    assert balanced(member) == [pytest.approx(8 * 200 / 10_000**2)]
    assert least_radius(member) == pytest.approx(10_000**2 / (8 * 200))


def test_spans_that_end_at_other_depths():
    """The sag is below the chord between the supports."""
    member = Member(
        **BEAM | {"span": (10_000, 8_000)}, dp=(300, 500, 100, 450, 300), profile="harped", harp=(0.5,)
    )
    assert balanced(member) == [pytest.approx(8 * 300 / 10_000**2), pytest.approx(8 * 250 / 8_000**2)]
    assert least_radius(member) is None


def test_told_of_a_member():
    member = Member(**BEAM, dp=(300, 500, 300))
    about = Subject(member, analyse(member))
    mean, load, radius = about_prestress(about)
    P = about.fse * 500
    assert mean.demand == pytest.approx(P / (300 * 600))
    assert load.demand == pytest.approx(P * 8 * 200 / 10_000**2)
    weight = 24e-6 * 300 * 600
    assert load.reason == f"{load.demand / weight:.0%} of all dead load"
    assert radius.unit == "mm" and np.isnan(radius.limit)
