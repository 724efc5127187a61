"""Published tables: where they are found, and each kind of fault with its cell and its cure."""

from datetime import date

import pytest

from ptbatch.compare.comparison import compare_workbooks
from ptbatch.compare.entry import Entry
from ptbatch.compare.published import read_published
from ptbatch.errors import ReadError
from tests.compare.made_up import ROW, write

STRESS = {"quantity": "stress_fe", "stage": "jacked", "x": 0}


@pytest.mark.parametrize(
    ("row", "because"),
    [  # member, quantity, value, class, source are A to E; what a row adds is F, G, ...
        (
            {"value": None},
            "published!C2  value: missing; give the expected number, or say under not_reproducible",
        ),
        ({"value": "#N/A"}, "published!C2  value = #N/A: the cell shows the error #N/A"),
        ({"value": date(2024, 3, 1)}, "published!C2  value = 2024-03-01 00:00:00: a date or time"),
        ({"value": True}, "TRUE or FALSE is not a value"),
        ({"value": "=1+1"}, "published!C2  value = =1+1: the formula has no stored value; open the workbook"),
        ({"member": None}, "published!A2  member: missing; give member: name in the results"),
        ({"quantity": None}, "published!B2  quantity: missing"),
        (
            {"class": "frosen"},
            "published!D2  class = frosen: is not one of the choices; did you mean frozen?",
        ),
        ({"class": None}, "published!D2  class: missing; give class: what the number is"),
        ({"source": None}, "published!E2  source: missing; give source: where it is printed"),
        ({"rtol": "2 %"}, "published!F2  rtol = 2 %: a number with something after it; units belong into"),
        (
            {"atol": -1},
            "published!F2  atol = -1: must be zero or more; give tolerance in the unit of the value",
        ),
        ({"bound": "below"}, "published!F2  bound = below: is not one of the choices"),
        ({"as": "quotient"}, "published!F2  as = quotient: is not one of the choices"),
        ({"as": "ratio"}, "against: missing; give the other member, against_quantity or against_x"),
        ({"against": "B2"}, "as: against is given, but not what is made of it; give ratio or difference"),
        ({"quantity": "stress_fe", "x": 0}, "stage: missing; give stage: stress_fe is looked up by it"),
        (STRESS | {"x": None}, "published!G2  x: missing; give x: stress_fe is looked up by it"),
        (STRESS | {"x": "middle"}, "published!G2  x = middle: a text is not a number"),
        (STRESS | {"stage": "jacking"}, "published!F2  stage = jacking: is not one of the choices"),
        (STRESS | {"against_x": -1, "as": "ratio"}, "against_x = -1: must be zero or more"),
        ({"quantity": "cracked_to"}, "stage: missing; give stage: cracked_to is looked up by it"),
        ({"share_of": "load_peak"}, "share_of = load_peak: is for differences alone"),
        (
            {"as": "difference", "against": "B2", "share_of": "stress_fe"},
            "stage: missing; give stage: stress_fe is looked up by it",
        ),
        ({"quantity": "load [kN]"}, "deflection: missing; give deflection: load is looked up by it"),
        (
            {"as": "ratio", "against_quantity": "load", "quantity": "load_peak"},
            "deflection: missing; give deflection: load is looked up by it",
        ),
    ],
)
def test_a_faulty_row_fails_and_says_why(lines, row, because):
    """Only that row is lost."""
    faulty, sound = lines(row, {})
    assert (faulty.verdict, faulty.ours, sound.verdict) == ("fail", None, "pass")
    assert because in faulty.because


def test_every_fault_of_a_row_at_once(lines):
    (line,) = lines({"value": None, "atol": "x", "class": "y"})
    assert [cell in line.because for cell in ("C2", "D2", "F2")] == [True] * 3


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        (
            [{"quantity": "load_peak"}],
            "sheet published has no column member; give a published table, or a results",
        ),
        ([{"member": "B1", "value": 1}], "quantity: there is no such column; give a header of summary"),
        ([ROW | {"x [kN]": 1}], "published!F1  x [kN] = x [kN]: kN is a unit of force, not of length"),
        ([ROW | {"x": 1, "x [mm]": 1}], "this column is given twice; keep one of them"),
        ([dict.fromkeys(ROW)], "sheet published has no rows below its headers; add some"),
    ],
)
def test_a_table_that_cannot_be_read(tmp_path, rows, message):
    with pytest.raises(ReadError) as error:
        read_published(write(tmp_path / "published.xlsx", published=rows))
    assert message in str(error.value)


def test_every_fault_of_the_headers_at_once(tmp_path):
    with pytest.raises(ReadError) as error:
        read_published(write(tmp_path / "published.xlsx", published=[{"member": "B1", "x [s]": 0}]))
    assert all(name in str(error.value) for name in ("x [s]", "quantity", "value", "class", "source"))


def test_a_misspelled_column_is_told(results, published):
    comparison = compare_workbooks(results(), published({"rtoll": 0.1}))
    assert [str(warning) for warning in comparison.warnings] == [
        "published!F1  rtoll = rtoll: warning: unknown column; did you mean rtol?"
    ]


def test_the_first_sheet_is_the_table_if_none_has_its_name(tmp_path):
    path = write(tmp_path / "numbers.xlsx", numbers=[ROW], more=[ROW])
    (entry,) = read_published(path).rows
    assert isinstance(entry, Entry)
    assert (entry.of.member, entry.value, entry.case) == ("B1", 200.0, "B1")


def test_a_table_beside_a_summary_is_a_table(tmp_path):
    path = write(tmp_path / "both.xlsx", summary=[{"member": "B1"}], Published=[ROW])
    assert len(read_published(path).rows) == 1


def test_a_results_workbook_is_none(results):
    assert read_published(results()) is None


def test_case_and_note_are_kept(lines):
    (line,) = lines({"note": "ours", "case": "One"})
    assert (line.note, line.case) == ("ours", "One")
