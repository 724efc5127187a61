"""The checks of a member, from its row to the sheet and the exit code."""

import numpy as np
import pytest
from openpyxl import load_workbook

from ptbatch.analysis import analyse
from ptbatch.batch import run_workbook
from ptbatch.cli import exit_code
from ptbatch.design.aci318 import PSI
from ptbatch.design.checks import checks, governing, outcome, subject
from ptbatch.design.subject import Subject
from ptbatch.design.time_losses import compression_at_tendon, volume_to_surface
from ptbatch.member import Member
from ptbatch.response import ANCHORED
from ptbatch.tables import check_table, summary_row

LIGHT = dict(
    span=9000, b=300, h=600, fc=40, Aps=592, dp=(300, 500, 300), fpj=1300, As=603, ds=550, w_dead=5,
    w_live=10, elements=8, layers=12, long_term_loss=120, deflection_limit=30,
)  # fmt: skip
TWO = LIGHT | dict(span=(9000, 9000), dp=(300, 500, 100, 500, 300), As_top=603, ds_top=50)


def made(base=LIGHT, **changes):
    """Member, its analysis and its checks."""
    member = Member(**{"member": "B1", "standard": "ACI 318-19"} | base | changes)
    response = analyse(member)
    return member, response, {check.name: check for check in checks(subject(member, response))}


def test_nothing_is_checked_unless_it_is_asked_for():
    assert made(standard="none")[2] == {}


def test_bending_of_a_simple_beam_by_aci():
    """Closed form: moments of statics, fps by table 20.3.2.4.1, the stress block solved again by hand."""
    member, response, found = made()
    check = found["bending, sagging"]
    dead = (24e-6 * 300 * 600 + 5.0) * 9000**2 / 8
    live = 10.0 * 9000**2 / 8
    assert check.x == pytest.approx(4500.0)
    assert check.demand == pytest.approx((1.2 * dead + 1.6 * live) / 1e6, rel=1e-6)
    fps = response.tendon[ANCHORED].mean - 120.0 + 10_000 * PSI + 40.0 / (100 * 592 / (300 * 500))
    a = (592 * fps + 603 * 420) / (0.85 * 40 * 300)
    nominal = 592 * fps * (500 - a / 2) + 603 * 420 * (550 - a / 2)
    assert check.limit == pytest.approx(0.9 * nominal / 1e6, rel=1e-6)
    assert (check.outcome, "bending, hogging" in found) == ("pass", False)


def test_bending_by_en():
    """Closed form: fse + 100 MPa, design strengths by 1.5 and 1.15."""
    member, response, found = made(standard="EN 1992-1-1")
    stress = response.tendon[ANCHORED].mean - 120.0 + 100.0
    tension = 592 * stress + 603 * 420 / 1.15
    x = tension / (0.8 * 300 * 40 / 1.5)
    resistance = 592 * stress * (500 - 0.4 * x) + 603 * 420 / 1.15 * (550 - 0.4 * x)
    assert found["bending, sagging"].limit == pytest.approx(resistance / 1e6, rel=1e-6)


def test_without_long_term_losses_bending_is_not_passed():
    check = made(long_term_loss=None)[2]["bending, sagging"]
    assert check.outcome == "review" and "give RH, or long_term_loss" in check.reason
    assert made(w_live=None)[2]["bending, sagging"].reason == "no service live load is given"


@pytest.mark.parametrize("standard", ["ACI 318-19", "EN 1992-1-1"])
def test_long_term_losses_by_the_standard(standard):
    """Where RH is given they are computed, and a drier place takes more; the user's lump sum goes before."""
    _, response, found = made(standard=standard, long_term_loss=None, RH=60)
    loss = found["long-term loss"]
    assert 60.0 < loss.demand < 250.0
    assert found["bending, sagging"].outcome in ("pass", "fail")
    parts = {value.symbol: value.value for value in loss.values}
    assert sum(parts[name] for name in ("creep", "shrinkage", "relaxation")) == pytest.approx(loss.demand)
    assert parts["fse"] == pytest.approx(response.tendon[ANCHORED].mean - loss.demand)
    assert made(standard=standard, long_term_loss=None, RH=40)[2]["long-term loss"].demand > loss.demand
    given = made(standard=standard, RH=60)[2]["long-term loss"]
    assert (given.demand, given.formula) == (120.0, "as given")


def test_compression_at_the_tendon():
    """Closed form: P/A + P e2/I - M e/I, averaged over two parabolas, of whose products 8/15 is the mean."""
    member, response, _ = made(long_term_loss=None)
    about = Subject(member, response)
    P, area, inertia = about.fse * 592, 300 * 600, 300 * 600**3 / 12
    M = (24e-6 * area + 5.0) * 9000**2 / 8
    expected = P / area + 8 / 15 * (P * 200 - M) * 200 / inertia
    assert compression_at_tendon(about) == pytest.approx(expected, rel=0.01)  # friction makes P vary
    assert volume_to_surface(member) == pytest.approx(300 * 600 / 1800)


def test_too_much_load_fails_and_no_steel_at_all_fails():
    assert made(w_live=60)[2]["bending, sagging"].outcome == "fail"
    hogging = made(TWO, As_top=0, ds_top=0, dp=(300, 500, 500, 500, 300))[2]["bending, hogging"]
    assert (hogging.outcome, hogging.x) == ("fail", 9000.0)


def test_too_high_a_stress_at_the_jack_fails():
    found = made(fpj=1500)[2]
    assert found["stress at the jack"].outcome == "fail"
    assert found["stress at the jack"].utilisation == pytest.approx(1500 / (0.80 * 1860), rel=1e-6)


def test_secondary_moments_are_those_of_the_analysis():
    """On a prismatic elastic member without friction and weight the only external moments after anchoring are
    secondary; 1 % is the issue's, of which the analysis' own camber takes some."""
    plain = dict(concrete_law="elastic", self_weight=False, mu=0, K=0, set=0, w_dead=0, elements=20)
    member, response, _ = made(TWO, **plain, long_term_loss=0)
    moments = Subject(member, response).moments
    largest = moments.secondary[np.abs(moments.secondary).argmax()]
    # of the Gauss section next to the support, to which the moment has run down in proportion
    nearest = 1.0 - (0.5 - 0.5 / np.sqrt(3.0)) / 20
    assert response.curve.moment_max[0] == pytest.approx(nearest * largest, rel=0.01)


def test_two_views_agree_within_a_reason():
    _, response, found = made()
    check = found["strength, two views"]
    assert check.demand == pytest.approx(
        response.curve.at(response.event("peak").step, response.curve.moment_max) / 1e6
    )
    assert check.outcome in ("info", "review") and (check.outcome == "info" or "lower, by" in check.reason)
    numbers = {value.symbol: value.value for value in check.values}
    assert numbers["used, code"] == pytest.approx(found["bending, sagging"].utilisation, rel=0.02)
    ratio = numbers["M, analysis"] / numbers["Mn, code"]
    assert numbers["used, analysis"] == pytest.approx(numbers["used, code"] / ratio)


def test_the_gravest_outcome_counts():
    found = list(made(w_live=60)[2].values())
    assert outcome(found) == "fail"
    assert governing(found).name == "bending, sagging"


def test_sheet_and_exit_code(book, capsys):
    row = {name: "; ".join(map(str, v)) if isinstance(v, tuple) else v for name, v in LIGHT.items()}
    rows = [
        row | {"member": "sound", "standard": "aci 318-19"},
        row | {"member": "overloaded", "standard": "EN 1992-1-1", "w_live": 60},
        row | {"member": "not asked"},
    ]
    source = book(*rows)
    assert exit_code(["run", str(source)]) == 1
    assert exit_code(["run", str(source), "--only", "sound"]) == 0
    path = run_workbook(source, units="US").path
    headers, *lines = load_workbook(path)["summary"].iter_rows(values_only=True)
    at = headers.index("checks")
    assert lines[0][at] in ("pass", "review")  # the two views of strength may differ
    assert [line[at] for line in lines[1:]] == ["fail", "no standard is asked for"]
    rows = [dict(zip(*pair, strict=True)) for pair in _rows(path)]
    assert {row["member"] for row in rows} == {"sound", "overloaded"}
    bending = next(row for row in rows if row["check"] == "bending, sagging" and row["member"] == "sound")
    assert bending["unit"] == "kip ft" and "ksi" in bending["numbers"] and " MPa" not in bending["numbers"]
    assert bending["x [in]"] == pytest.approx(4500 / 25.4)


def _rows(path):
    headers, *lines = load_workbook(path)["checks"].iter_rows(values_only=True)
    return [(headers, line) for line in lines]


def test_stresses_at_transfer_and_in_service():
    """Closed form: P/A +- M/S at midspan, without friction."""
    plain = dict(mu=0, K=0, set=0, fci=28)
    _, response, found = made(**plain)
    area, modulus = 300 * 600, 300 * 600**2 / 6
    anchored = response.tendon[ANCHORED].mean * 592
    weight, dead, live = (w * 9000**2 / 8 for w in (4.32, 9.32, 10.0))
    bottom = anchored / area + (anchored * 200 - weight) / modulus
    check = found["transfer compression"]
    assert check.demand == pytest.approx(bottom, rel=2e-3)  # the force varies by what the camber takes
    assert check.limit == pytest.approx(0.60 * 28)
    P = (response.tendon[ANCHORED].mean - 120.0) * 592
    tension = -P / area + (dead + live - P * 200) / modulus
    assert found["class"].demand == pytest.approx(tension, abs=0.02)
    top = P / area + (dead + live - P * 200) / modulus
    assert found["service compression, total"].demand == pytest.approx(top, rel=5e-3)
    assert "transfer compression" not in made()[2]


def test_ends_of_a_simple_member_may_bear_more():
    found = made(fci=28)[2]
    assert found["transfer compression, ends"].limit == pytest.approx(0.70 * 28)
    assert "transfer compression, ends" not in made(TWO, fci=28)[2]


def test_a_cracked_class_is_to_be_reviewed():
    found = made(w_live=25)[2]["class"]
    assert (found.outcome, found.reason[:7]) == ("review", "class C")


def test_service_stresses_by_en():
    found = made(standard="EN 1992-1-1")[2]
    assert found["compression, quasi-permanent"].limit == pytest.approx(0.45 * 40)
    assert found["tendon after losses"].limit == pytest.approx(0.75 * 1860)
    assert found["compression, characteristic"].outcome == "pass"


def test_outside_a_clause_nothing_is_passed():
    little = made(LIGHT, fpj=800)[2]["bending, sagging"]
    assert little.outcome == "fail" or "fse is below 0.5 fpu" in little.reason
    light = made(LIGHT, fpj=800, w_live=2)[2]["bending, sagging"]
    assert light.outcome == "review" and "fse is below 0.5 fpu" in light.reason
    strong = made(LIGHT, fc=100, concrete_law="parabola-rectangle", standard="EN 1992-1-1")[2][
        "bending, sagging"
    ]
    assert strong.outcome == "review" and "12 to 90 MPa" in strong.reason


def test_the_class_has_a_short_name(book):
    row = {name: "; ".join(map(str, v)) if isinstance(v, tuple) else v for name, v in LIGHT.items()}
    source = book(row | {"member": "B1", "standard": "ACI 318-19", "w_live": 25, "class": "U"})
    batch = run_workbook(source)
    told = [dict(zip(*pair, strict=True)) for pair in _rows(batch.path)]
    (check,) = [one for one in told if one["check"] == "class"]
    assert (check["outcome"], check["reason"]) == ("fail", "class C, not U")
    assert not batch.inputs.extra_headers


def test_nothing_provided_is_said_in_words():
    member, response, found = made(LIGHT | dict(As=0, ds=0))
    table = check_table(found.values())
    steel = table["check"].index("least bonded steel")
    assert (table["utilisation"][steel], table["outcome"][steel]) == ("nothing is provided", "fail")
    assert summary_row(member, response)["utilisation_max"] == "nothing is provided"
