"""Gross sections and their layers: every expected number is closed form."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from ptbatch.geometry.section import gross_section, section_layers


def member(shape, b, h, bw=None, hf=None, b_bottom=None, hf_bottom=None, layers=40):
    return SimpleNamespace(
        shape=shape, b=b, h=h, bw=bw, hf=hf, b_bottom=b_bottom, hf_bottom=hf_bottom, layers=layers
    )


ALL = {
    "rectangle": member("rectangle", 300.0, 600.0),
    "tee": member("tee", 1200.0, 700.0, bw=300.0, hf=150.0),
    "i": member("i", 600.0, 1000.0, bw=150.0, hf=120.0, b_bottom=400.0, hf_bottom=180.0),
    "box": member("box", 2000.0, 1500.0, bw=500.0, hf=250.0, hf_bottom=200.0),
}
every_shape = pytest.mark.parametrize("m", ALL.values(), ids=ALL.keys())


def test_rectangle():
    s = gross_section(ALL["rectangle"])
    assert (s.area, s.centroid, s.h) == (180000.0, 300.0, 600.0)
    assert s.inertia == pytest.approx(300.0 * 600.0**3 / 12.0, rel=1e-14)


def test_tee_has_its_flange_on_top():
    s = gross_section(ALL["tee"])
    area = 1200.0 * 150.0 + 300.0 * 550.0
    centroid = (1200.0 * 150.0 * 75.0 + 300.0 * 550.0 * 425.0) / area
    about_top = 1200.0 * 150.0**3 / 3.0 + 300.0 * (700.0**3 - 150.0**3) / 3.0
    assert (s.area, s.centroid) == pytest.approx((area, centroid), rel=1e-14)
    assert s.inertia == pytest.approx(about_top - area * centroid**2, rel=1e-12)


def test_symmetric_i_is_a_rectangle_less_its_recesses():
    s = gross_section(member("i", 600.0, 1000.0, bw=150.0, hf=120.0))
    assert s.centroid == pytest.approx(500.0, rel=1e-14)
    assert s.inertia == pytest.approx((600.0 * 1000.0**3 - 450.0 * 760.0**3) / 12.0, rel=1e-13)


def test_box_is_its_outline_less_its_cell():
    s = gross_section(ALL["box"])
    cell = 1500.0 * 1050.0
    assert s.area == pytest.approx(2000.0 * 1500.0 - cell, rel=1e-14)
    assert s.centroid == pytest.approx((2000.0 * 1500.0 * 750.0 - cell * 775.0) / s.area, rel=1e-14)
    assert s.width[[0, 20, -1]] == pytest.approx([2000.0, 500.0, 2000.0])


@every_shape
def test_layers_tile_the_section(m):
    s = gross_section(m)
    assert s.y.size == s.width.size == s.thickness.size == 40
    edges = np.append(0.0, np.cumsum(s.thickness))
    assert_allclose(s.y, (edges[:-1] + edges[1:]) / 2.0, rtol=1e-12)
    assert edges[-1] == pytest.approx(m.h, rel=1e-14)
    assert_allclose(section_layers(m), (s.y, s.width, s.thickness), rtol=0.0)


@every_shape
def test_layers_have_the_area_the_centroid_and_nearly_the_inertia(m):
    s = gross_section(m)
    area = s.width * s.thickness
    assert area.sum() == pytest.approx(s.area, rel=1e-13)
    assert area @ s.y == pytest.approx(s.area * s.centroid, rel=1e-13)
    points = area @ (s.y - s.centroid) ** 2
    assert points == pytest.approx(s.inertia, rel=2e-3)  # each layer lumped at its centre
    assert points + area @ s.thickness**2 / 12.0 == pytest.approx(s.inertia, rel=1e-13)


def test_layers_end_at_the_flanges_and_each_part_has_two():
    s = gross_section(
        member("i", 600.0, 1000.0, bw=150.0, hf=10.0, b_bottom=400.0, hf_bottom=180.0, layers=10)
    )
    assert_allclose(s.thickness[:2], 5.0)
    assert_allclose(s.width, [600.0] * 2 + [150.0] * 6 + [400.0] * 2)
    assert gross_section(member("i", 600.0, 1000.0, bw=150.0, hf=100.0, layers=1)).y.size == 6


def test_faults_name_what_is_wrong():
    with pytest.raises(ValueError, match="'circle' is none of rectangle, tee, i, box"):
        gross_section(member("circle", 300.0, 300.0))
    with pytest.raises(ValueError, match="each part needs a width and a height above zero"):
        gross_section(member("tee", 1200.0, 700.0, bw=300.0, hf=700.0))
