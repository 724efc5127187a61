"""Strands that an existing member has lost."""

import pytest

from ptbatch.analysis import analyse
from ptbatch.member import Member, MemberError
from tests.design.test_checks import LIGHT, made


def test_the_others_are_analysed_alone():
    """A member with three of four strands is the one that has never had more."""
    lost = analyse(Member(member="B", **LIGHT | dict(n_strands=4, n_strands_lost=1)))
    fewer = analyse(Member(member="B", **LIGHT | dict(Aps=0.75 * 592)))
    assert lost.event("peak").load == pytest.approx(fewer.event("peak").load, rel=1e-9)
    assert lost.member.Aps == 592.0
    whole = analyse(Member(member="B", **LIGHT))
    assert lost.event("peak").load < whole.event("peak").load


def test_they_lack_in_the_checks():
    limit = made(n_strands=4, n_strands_lost=1)[2]["bending, sagging"].limit
    assert limit == pytest.approx(made(Aps=0.75 * 592)[2]["bending, sagging"].limit, rel=1e-9)


@pytest.mark.parametrize(
    "given, message",
    [({"n_strands_lost": 1}, "n_strands: missing"), ({"n_strands": 4, "n_strands_lost": 4}, "none is left")],
)
def test_some_are_left(given, message):
    with pytest.raises(MemberError, match=message):
        Member(member="B", **LIGHT, **given)
