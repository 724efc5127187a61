"""What is compared and when it passes. Every number is made up; see made_up."""

import pytest

STRESS = {"quantity": "stress_fe [MPa]", "stage": "jacked"}
CRACKS = {"stage": "end"}
LOAD = {"quantity": "load", "deflection": 10, "as": "difference", "against_quantity": "load_peak"}
LOSS = {"quantity": "loss_fixed_end_fe", "as": "ratio", "against_quantity": "loss_fixed_end_analytic"}
NOT_CONVERGED = "the results say: not converged: see message"


@pytest.fixture
def one(lines):
    """The line of one row."""
    return lambda row, **options: lines(row, **options)[0]


@pytest.mark.parametrize(
    ("row", "ours"),
    [
        ({}, 200.0),
        ({"quantity": "load_peak"}, 200.0),
        ({"quantity": "Load_Peak [N]"}, 2e5),
        ({"quantity": "load_peak [kip]"}, 44.9618),
        ({"quantity": "failure", "value": "Bar rupture"}, "bar rupture"),
        (STRESS | {"x": 500}, 1395.0),  # interpolated
        (STRESS | {"x": 2000, "quantity": "stress_analytic [ksi]"}, 199.862),
        (STRESS | {"x": 1000, "stage": "peak"}, 1550.0),
        ({"quantity": "load [kN]", "deflection": 9.5}, 95.0),  # on the first of three passes
        ({"quantity": "load [kN]", "deflection [m]": 0.03}, 200.0),
        (LOSS, 0.8),
        (STRESS | {"x": 0, "as": "difference", "against_x": 2000}, 30.0),
        (STRESS | {"x": 0, "as": "difference", "against_quantity": "stress_analytic"}, 0.0),
        ({"quantity": "loss_fixed_end_fe [%]", "as": "ratio", "against": "B2"}, 1.0),
        (LOAD | {"share_of": "load_peak"}, -50.0),  # 100 less 200 kN, in % of 200 kN
        (LOAD | {"quantity": "load [N]", "share_of": "load_peak [kN]"}, -50.0),
        (CRACKS | {"quantity": "cracked_sections"}, 2.0),
        (CRACKS | {"quantity": "cracked_from"}, 500.0),
        (CRACKS | {"quantity": "cracked_to [m]"}, 0.9),
        (CRACKS | {"quantity": "crack_height_mean"}, 150.0),
        (CRACKS | {"quantity": "crack_height_max", "as": "ratio", "against_quantity": "cracked_to"}, 1 / 3),
    ],
)
def test_what_is_compared(one, row, ours):
    line = one(row)
    assert line.ours == (ours if isinstance(ours, str) else pytest.approx(ours, rel=1e-5))
    if isinstance(ours, float):
        assert one(row | {"value": line.ours}).verdict == "pass"


@pytest.mark.parametrize(
    ("row", "verdict"),
    [
        ({"value": 200}, "pass"),
        ({"value": 200.001}, "fail"),
        ({"value": 201, "rtol": 0.01}, "pass"),
        ({"value": 201, "rtol [%]": 0.4}, "fail"),
        ({"value": 201, "atol": 1, "rtol [%]": 0.1}, "pass"),  # the larger of both
        ({"value": 201, "atol": 0.5, "rtol [%]": 0.1}, "fail"),
        ({"value": "200"}, "pass"),  # a number in a cell formatted as text
        ({"value": "two hundred"}, "fail"),
        ({"value": 200.1, "bound": "at most"}, "pass"),
        ({"value": 199.9, "bound": "at most"}, "fail"),
        ({"value": 199.9, "bound": "At most", "atol": 0.2}, "pass"),
        ({"value": 200.1, "bound": "at least"}, "fail"),
        ({"value": 200.1, "bound": "at_least", "rtol": 0.01}, "pass"),
        ({"value": 200.1, "bound": "at least", "rtol": 0}, "fail"),
        ({"quantity": "failure", "value": "concrete crushing"}, "fail"),
        ({"quantity": "failure", "value": 7}, "fail"),
        ({"quantity": "camber_anchored [mm]", "value": 0}, "pass"),
        (LOSS | {"value": 1, "atol": 0.2}, "pass"),
        (LOSS | {"value": 1, "atol": 0.1}, "fail"),
    ],
)
def test_tolerance(one, row, verdict):
    assert one(row).verdict == verdict


def test_numbers_without_a_tolerance_take_that_of_the_command(one):
    assert one({"value": 201}, rtol=0.01).verdict == "pass"
    assert one({"value": 201, "rtol": 0}, rtol=0.01).verdict == "fail"
    assert one({"value": 201, "bound": "at least"}, rtol=0.01).verdict == "fail"  # bounds are bounds


@pytest.mark.parametrize(
    ("row", "because"),
    [
        ({"value": 190}, "off by 10 (5.3 %)"),
        ({"value": 210, "bound": "at least"}, "less by 10"),
        ({"value": 190, "bound": "at most"}, "more by 10"),
        ({"member": "B3"}, "the results have no member B3; choose one of B1, B2"),
        ({"quantity": "load_peek"}, "the results have no quantity load_peek; did you mean load_peak?"),
        ({"quantity": "load_peak [MPa]"}, "load_peak is in kN: MPa is a unit of stress, not of force"),
        (
            {"as": "ratio", "against_quantity": "camber_anchored"},
            "camber_anchored is in mm: kN is a unit of force, not of length",
        ),
        ({"quantity": "time [h]"}, "time is in ms: h is not ms; give it in ms"),
        ({"member": "B2"}, NOT_CONVERGED),
        ({"as": "ratio", "against": "B2"}, "load_peak of B2 is no number but: not converged: see message"),
        ({"quantity": "failure", "value": "concrete crushing"}, "the results say: bar rupture"),
        ({"quantity": "message", "value": "slow"}, "the results say: nothing"),
        ({"value": "a lot"}, "a number in the results, a text in the table: a lot"),
        (STRESS | {"x": 2001}, "x = 2001 mm lies beyond the member, which ends at 2000 mm"),
        (STRESS | {"x": 0, "stage": "set"}, "the sheet tendon has no stage set of B1"),
        (STRESS | {"x": 0, "member": "B2"}, "the sheet tendon has no stage jacked of B2"),
        (
            {"quantity": "stress_analytic", "stage": "peak", "x": 0},
            "the sheet tendon has no stress_analytic at the stage peak",
        ),
        ({"quantity": "load", "deflection": 31}, "the curve goes to 30 mm, not to 31 mm"),
        ({"quantity": "load", "deflection": 1, "member": "B2"}, "the sheet curves has no load of B2"),
        ({"quantity": "event", "deflection": 1}, "the sheet curves has no event of B1"),
        (
            {"quantity": "camber_anchored", "as": "ratio", "against": "B2"},
            "there is no ratio to camber_anchored, which is zero",
        ),
        (
            {"quantity": "elongation", "as": "difference", "against": "B2", "share_of": "camber_anchored"},
            "the results have no quantity elongation",
        ),
        (
            {"quantity": "camber_anchored", "as": "difference", "against": "B2"}
            | {"share_of": "camber_anchored"},
            "there is no ratio to camber_anchored, which is zero",
        ),
        (
            {"quantity": "cracked_to", "stage": "peak"},
            "the sheet cracks has no cracks of B1 at the stage peak",
        ),
    ],
)
def test_why_a_row_fails(one, row, because):
    line = one(row)
    assert line.verdict == "fail"
    assert because in line.because


def test_not_reproducible(one):
    excused = {"not_reproducible": "the source has a misprint"}
    line = one(excused | {"value": 300})
    assert (line.verdict, line.because, line.ours) == ("not reproducible", "the source has a misprint", 200.0)
    assert one(excused | {"value": None}).verdict == "not reproducible"  # the source prints none


@pytest.mark.parametrize(
    "row", [{"member": "B3"}, {"member": "B2"}, {"quantity": "nonsense"}, {"value": None, "member": "B2"}]
)
def test_not_reproducible_excuses_no_value_that_is_missing(one, row):
    assert one({"value": 300, "not_reproducible": "misprint"} | row).verdict == "fail"


def test_a_mark_that_is_no_longer_needed_is_told(one):
    line = one({"not_reproducible": "misprint"})
    assert (line.verdict, line.because) == (
        "pass",
        "marked as not reproducible, but it is met: take the mark away",
    )


@pytest.mark.parametrize(
    ("row", "what", "unit", "tolerance"),
    [
        ({"rtol": 0.02, "atol": 0.5}, "load_peak", "kN", "± 0.5 or 2 %"),
        ({}, "load_peak", "kN", "± 0.0001 %"),
        ({"rtol": 0}, "load_peak", "kN", "± 0"),
        ({"bound": "at most"}, "load_peak", "kN", "at most"),
        ({"bound": "at least", "rtol": 0.01}, "load_peak", "kN", "at least, less 1 %"),
        ({"bound": "at most", "atol": 2}, "load_peak", "kN", "at most, plus 2"),
        (STRESS | {"x [m]": 1}, "stress_fe, jacked, x = 1000 mm", "MPa", "± 0.0001 %"),
        (LOSS, "loss_fixed_end_fe / loss_fixed_end_analytic", "", "± 0.0001 %"),
        (
            STRESS | {"x": 0, "as": "difference", "against_x": 2000},
            "stress_fe, jacked, x = 0 mm less x = 2000 mm",
            "MPa",
            "± 0.0001 %",
        ),
        (
            {"quantity": "load", "deflection": 10, "as": "ratio", "against": "B1"},
            "load, at 10 mm / that of B1",
            "",
            "± 0.0001 %",
        ),
        (
            LOAD | {"share_of": "load_peak", "against_quantity": None, "against": "B1", "atol": 2},
            "load, at 10 mm less that of B1, as a share of load_peak",
            "%",
            "± 2",
        ),
        (CRACKS | {"quantity": "cracked_to", "atol": 381}, "cracked_to, end", "mm", "± 381"),
    ],
)
def test_how_a_line_reads(one, row, what, unit, tolerance):
    line = one(row)
    assert (line.what, line.unit, line.tolerance) == (what, unit, tolerance)
