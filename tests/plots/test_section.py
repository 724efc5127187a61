"""Outlines of the shapes."""

from types import SimpleNamespace

import numpy as np
import pytest

from ptbatch.geometry.section import gross_section
from ptbatch.member import Member
from ptbatch.plots.pages import geometry_of
from ptbatch.plots.section import outline

SHAPES = {
    "rectangle": {},
    "tee": {"bw": 150, "hf": 120},
    "i": {"bw": 150, "hf": 120, "b_bottom": 400, "hf_bottom": 200},
    "box": {"bw": 200, "hf": 120, "b_bottom": 500, "hf_bottom": 100},
}
ANY = dict(b=600, h=800, layers=10, b_bottom=None, hf_bottom=None, bw=None, hf=None)


def area(path) -> float:
    """Area inside closed polygons by the shoelace formula; a hole runs the other way round."""
    total = 0.0
    for polygon in path.to_polygons():
        x, y = polygon.T
        total += 0.5 * float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
    return abs(total)


@pytest.mark.parametrize("shape", SHAPES)
def test_outline_has_the_area_of_the_section(shape):
    sizes = SimpleNamespace(**ANY | SHAPES[shape] | {"shape": shape})
    assert area(outline(sizes)) == pytest.approx(gross_section(sizes).area)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("profile", ["straight", "parabola", "harped"])
def test_geometry_of_every_shape_and_profile(shape, profile):
    sizes = {name: value for name, value in (ANY | SHAPES[shape]).items() if value is not None}
    dp = 500 if profile == "straight" else (300, 700, 300)
    ends = dict(
        support_left="fixed", support_right="free", jack="right", w_dead=3, live="midspan", P_live=1e4
    )
    bars = dict(As=(400, 500), ds=(650, 750), bars=[(1000, 3000, 60, 300, 500)])
    values = dict(member="M", span=8000, fc=40, Aps=600, fpj=1300, profile=profile, dp=dp, shape=shape)
    geometry_of(Member(**values | sizes | ends | bars)).draw_without_rendering()
