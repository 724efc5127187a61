"""Elastic moments against closed forms."""

import numpy as np
import pytest

from ptbatch.design.moments import of_loads, secondary, stations
from ptbatch.geometry.profile import ideal_profile
from ptbatch.geometry.section import gross_section
from ptbatch.member import Load, Member

L = 10_000.0
BEAM = dict(member="B", b=300, h=600, fc=40, Aps=500, fpj=1300)
ONE = Member(span=L, dp=(300, 500, 300), **BEAM)
TWO = Member(span=(L, L), profile="harped", harp=(0.5,), dp=(300, 500, 150, 500, 300), **BEAM)


def at(x, values, place) -> float:
    return float(np.interp(place, x, values))


def test_simple_beam_under_a_line_load():
    load = Load("dead", "uniform", 0.0, L, 10.0)
    x = stations(ONE, [load], ())
    found = of_loads(ONE, x, [load])
    np.testing.assert_allclose(found, 0.5 * 10.0 * x * (L - x), atol=1e-6 * 10.0 * L**2)


def test_simple_beam_under_part_of_a_line_load_and_a_point():
    loads = [Load("live", "uniform", 2000.0, 4100.0, 8.0), Load("live", "point", 7300.0, 7300.0, 5000.0)]
    x = stations(ONE, loads, ())
    left = (8.0 * 2100.0 * (L - 3050.0) + 5000.0 * (L - 7300.0)) / L
    assert at(x, of_loads(ONE, x, loads), 7300.0) == pytest.approx(
        left * 7300.0 - 8.0 * 2100.0 * 4250.0, rel=1e-6
    )


def test_two_spans_under_a_line_load():
    load = Load("dead", "uniform", 0.0, 2 * L, 10.0)
    x = stations(TWO, [load], ())
    found = of_loads(TWO, x, [load])
    assert at(x, found, L) == pytest.approx(-10.0 * L**2 / 8.0, rel=1e-6)  # closed form
    assert found.max() == pytest.approx(
        9.0 / 128.0 * 10.0 * L**2, rel=1e-4
    )  # at 3/8 of the span, a station or not


def primary(member, x, P) -> np.ndarray:
    return -P * (ideal_profile(member).depth(x) - gross_section(member).centroid)


def test_secondary_moments_of_two_spans_by_load_balancing():
    """Closed form: a tendon harped in the middle of each span lifts by F = P times its change of slope; two
    such forces make 3 F L / 16 over the middle support, the primary moment of which is - P e."""
    P = 1e6
    x = stations(TWO, (), ())
    m1 = primary(TWO, x, P)
    found = secondary(TWO, x, m1)
    lift = P * (200.0 + 350.0) / (L / 2)  # slopes down to the low point and up from there
    total = 3.0 / 16.0 * lift * L
    assert at(x, found, L) == pytest.approx(total - at(x, m1, L), rel=1e-6)
    np.testing.assert_allclose(found, at(x, found, L) * (1.0 - np.abs(x - L) / L), atol=1e-6 * P * 300.0)


def test_a_simple_span_has_no_secondary_moments():
    x = stations(ONE, (), ())
    np.testing.assert_allclose(secondary(ONE, x, primary(ONE, x, 1e6)), 0.0, atol=1e-6 * 1e6 * 200.0)


def test_a_fixed_beam_with_a_straight_eccentric_tendon():
    """Closed form: it cannot turn anywhere, so that the secondary moment is P e all along."""
    held = Member(span=L, profile="straight", dp=(450,), support_left="fixed", support_right="fixed", **BEAM)
    x = stations(held, (), ())
    np.testing.assert_allclose(secondary(held, x, primary(held, x, 1e6)), 1e6 * 150.0, rtol=1e-6)
