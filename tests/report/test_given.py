"""The input as the report tells it."""

import pytest

from ptbatch import Member
from ptbatch.report.given import MOST, given
from tests.plots.conftest import SMALL

BEAM = {header.split(" [")[0]: value for header, value in SMALL.items()}
BEAM |= {"member": "B", "dp": (250, 400, 250), "As": (300, 200), "ds": (450, 420)}


def told(name, **values) -> list[str]:
    """Values of that name, with their units."""
    groups = given(Member(**BEAM | values), "SI")
    return [
        f"{one.value} {one.unit}".strip() for group in groups.values() for one in group if one.name == name
    ]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("span", "6000 mm"),
        ("dp", "250; 400; 250 mm"),
        ("Aps", "400 mm²"),
        ("K", "0.0033 1/m"),
        ("density", "24 kN/m³"),
    ],
)
def test_values_have_their_units(name, text):
    assert told(name) == [text]


@pytest.mark.parametrize("name", ["fpe", "bw", "harp", "As_top", "w_live"])
def test_what_is_not_used_is_left_out(name):
    assert told(name) == []


def test_of_many_points_some_are_told():
    def points(count):
        step = 6000 / (count - 1)
        return told("x; dp", dp=(), profile_points=[(step * i, 250 + i) for i in range(count)])

    assert points(MOST)[-1] == "6000; 258 mm"
    assert len(points(MOST)) == MOST
    assert len(points(25)) == MOST - 1 and points(25)[-1] == "6000; 274 mm"
    assert not told("dp", dp=(), profile_points=[(0, 250), (6000, 250)])


def test_what_time_and_checks_need_is_told_where_they_are_asked_for():
    assert not told("RH") and not told("exposure") and not told("age_stressing")
    assert told("RH", RH=60) == ["60 %"] and told("age_stressing", RH=60) == ["7"]
    assert told("exposure", standard="ACI 318-19") == ["interior"]
    assert not told("bar_diameter", standard="ACI 318-19")
    assert told("bar_diameter", standard="EN 1992-1-1") == ["16 mm"]
    assert told("n_strands_lost", n_strands=4, n_strands_lost=1) == ["1"]
