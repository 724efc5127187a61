"""Shear forces and reactions: closed form."""

import numpy as np
import pytest

from ptbatch.design.subject import Subject
from ptbatch.member import Load, Member
from ptbatch.model.loading import by_span
from tests.design.test_checks import LIGHT, TWO, made


def test_of_two_equal_spans():
    """3/8, 10/8, 3/8 of w L; the secondary ones balance each other and make M2 = R L."""
    member, response, _ = made(TWO)
    about = Subject(member, response)
    live = about.reactions["live"]
    assert live == pytest.approx(10.0 * 9000 * np.array([3 / 8, 10 / 8, 3 / 8]), rel=1e-6)
    secondary = about.reactions["secondary"]
    assert sum(secondary) == pytest.approx(0.0, abs=1e-6 * abs(secondary[1]))
    i = int(np.abs(about.moments.x - 9000).argmin())
    assert about.moments.secondary[i] == pytest.approx(secondary[0] * 9000, rel=1e-6)
    dead = sum(about.reactions["dead"])
    assert dead == pytest.approx((24e-6 * 300 * 600 + 5) * 18_000, rel=1e-9)


def test_of_a_point_load():
    loads = (Load("live", "point", 3000, 3000, 30e3),)
    member, response, _ = made(LIGHT, live="loads", w_live=None, loads=loads)
    about = Subject(member, response)
    assert about.reactions["live"] == pytest.approx([20e3, 10e3], rel=1e-6)
    i = int(np.abs(about.moments.x - 3000).argmin())
    assert about.shears["live"][i] == pytest.approx([20e3, -10e3], rel=1e-6)


def test_live_load_on_the_spans_where_it_counts():
    """Closed form, two equal spans: w L2 / 16 less at the support if one is loaded; the largest moment of a
    loaded span beside an unloaded one is 49 / 512 w L2."""
    member, response, found = made(TWO)
    moments = Subject(member, response).moments
    i = int(np.abs(moments.x - 9000).argmin())
    w = 10.0 * 9000**2
    assert moments.live[i] == pytest.approx(-w / 8, rel=1e-6)
    assert moments.live_least[i] == pytest.approx(-w / 8, rel=1e-6)
    assert moments.live_most.max() == pytest.approx(49 / 512 * w, rel=1e-4)
    assert moments.live.max() == pytest.approx(9 / 128 * w, rel=1e-4)
    assert moments.live_most + moments.live_least == pytest.approx(moments.live, rel=1e-9, abs=1e-3)


def test_loads_are_cut_at_the_supports():
    loads = (
        Load("live", "uniform", 3000, 12_000, 10.0),
        Load("live", "point", 9000, 9000, 5e3),
    )
    member = Member(member="B", **TWO | dict(live="loads", w_live=None, loads=loads))
    left, right = by_span(member, list(loads))
    assert [(load.x, load.x_end) for load in left] == [(3000, 9000), (9000, 9000)]
    assert [(load.x, load.x_end) for load in right] == [(9000, 12_000)]
