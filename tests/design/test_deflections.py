"""Deflections, cover, class and load factors of a member: closed form."""

import numpy as np
import pytest

from ptbatch.design.deflections import elastic, live_by_analysis
from ptbatch.design.subject import Subject
from ptbatch.member import MemberError
from tests.design.test_checks import made

EI = 4700 * 40**0.5 * 300 * 600**3 / 12


def test_elastic_deflections():
    """5 w L^4 / 384 EI, and 5 P e L^2 / 48 EI upward of a parabola without friction."""
    member, response, _ = made(mu=0, K=0, set=0)
    about = Subject(member, response)
    found = elastic(about, member.Ec)
    assert found.live.max() == pytest.approx(5 * 10 * 9000**4 / 384 / EI, rel=1e-6)
    assert found.prestress.min() == pytest.approx(-5 * about.fse * 592 * 200 * 9000**2 / 48 / EI, rel=2e-3)


def test_live_load_by_the_analysis_is_elastic_before_cracks():
    """Bars and tendon stiffen the section, by less than 10 %."""
    member, response, found = made(w_live=3, elements=20, layers=40)
    elastic_one = 5 * 3 * 9000**4 / 384 / EI
    assert 0.90 * elastic_one < live_by_analysis(Subject(member, response)) < elastic_one
    check = found["deflection, live"]
    assert (check.limit, check.outcome) == (9000 / 360, "pass")


def test_long_term_deflection_by_aci():
    _, _, found = made(live_sustained=0.25)
    check = found["deflection, long-term"]
    numbers = {value.symbol: value.value for value in check.values}
    live = numbers["delta,live"]
    sustained = numbers["delta,dead"] + 0.25 * live + numbers["delta,prestress"]
    assert check.demand == pytest.approx(abs(2.0 * sustained + live))
    assert check.limit == 9000 / 240


def test_quasi_permanent_deflection_by_en():
    _, _, found = made(standard="EN 1992-1-1", RH=60)
    check = found["deflection, quasi-permanent"]
    assert check.limit == 9000 / 250 and 1.0 < {v.symbol: v.value for v in check.values}["phi"] < 3.0


def test_cover():
    """The lowest tendon is 100 mm above the soffit; 20 mm of duct take half of it."""
    check = made(duct=20)[2]["cover"]
    assert (check.limit, check.demand, check.outcome) == (pytest.approx(90.0), 38.1, "pass")
    bare = made()[2]["cover"]
    assert bare.outcome == "info" and bare.reason == "counted to the tendon's axis: give duct"
    assert made(duct=20, exposure="ground")[2]["cover"].demand == 76.2
    assert made(duct=20, cover=95)[2]["cover"].outcome == "fail"
    by_en = made(standard="EN 1992-1-1", duct=60, exposure="XD3")[2]["cover"]
    assert (by_en.demand, by_en.limit) == (70.0, pytest.approx(70.0))


def test_a_class_that_is_asked_for():
    assert made(service_class="U", w_live=25)[2]["class"].outcome == "fail"
    assert made(service_class="C", w_live=25)[2]["class"].outcome == "review"
    assert made(service_class="U")[2]["class"].outcome == "info"


def test_load_factors_of_an_office():
    values = made(factor_dead=1.0, factor_live=1.0)[2]["bending, sagging"]
    w = 24e-6 * 300 * 600 + 5 + 10
    assert values.demand == pytest.approx(w * 9000**2 / 8 / 1e6, rel=1e-6)
    with pytest.raises(MemberError, match="factor_live: missing, and factor_dead is given"):
        made(factor_dead=1.2)


def test_strength_beyond_cracking():
    """(fr + P/A) S + P e, by hand; asked for with a bonded tendon."""
    _, response, found = made(bond="bonded", mu=0, K=0, set=0)
    check = found["strength beyond cracking"]
    P = (response.tendon["anchored"].mean - 120) * 592
    S = 300 * 600**2 / 6
    cracking = (0.62274 * 40**0.5 + P / 180_000) * S + P * 200
    assert check.demand == pytest.approx(1.2 * cracking / 1e6, rel=2e-3)
    assert check.outcome in ("pass", "review")
    assert made()[2]["strength beyond cracking"].outcome == "info"


def test_the_deflection_of_the_analysis_counts_from_the_service_state():
    member, response, _ = made()
    curve = response.curve
    start = int(np.flatnonzero(curve.factor == 0.0)[-1])
    assert start >= 2  # anchored, sustained, when time has taken its part
    whole = np.interp(1.0, curve.factor[start:], curve.deflection[start:])
    assert live_by_analysis(Subject(member, response)) == pytest.approx(whole - curve.deflection[start])
