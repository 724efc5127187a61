"""Each kind of bad cell: reported with its place and its cure, and only that row lost."""

import zipfile
from datetime import date, time

import pytest

from ptbatch.workbook.inputs import read_inputs

HEADERS = "ABCDEFGH"  # of the sound row: member, span, b, h, fc, Aps, dp, fpj


def problems(path):
    return read_inputs(path).all_problems()


def faults(path) -> dict[str, str]:
    """What is wrong and the cure, by cell."""
    return {p.place.cell: f"{p.wrong}; {p.cure}" for p in problems(path) if not p.warning}


@pytest.mark.parametrize(
    ("column", "value", "cell", "wrong"),
    [
        ("fc", "forty", "E2", "a text is not a number"),
        ("fc", "12,5", "E2", "a comma is not clear; use a point for decimals"),
        ("span", "8000, 9000", "B2", "a comma is not clear; use a point for decimals and ; between numbers"),
        ("span", "8000;;9000", "B2", "an item of the list is missing"),
        ("b", "300 mm", "C2", "units belong into the header"),
        ("b", "300;400", "C2", "a list where one number is wanted"),
        ("fc", "NaN", "E2", "is not a finite number"),
        ("fc", "inf", "E2", "is not a finite number"),
        ("fc", "#DIV/0!", "E2", "the cell shows the error #DIV/0!"),
        ("fc", "#N/A", "E2", "the cell shows the error #N/A"),
        ("fc", True, "E2", "TRUE or FALSE is not a number"),
        ("b", date(2024, 3, 1), "C2", "a date or time is not a number"),
        ("b", time(3, 4), "C2", "a date or time is not a number"),
        ("b", -300, "C2", "must be above zero; give overall width"),
        ("h", 0, "D2", "must be above zero; give overall depth"),
        ("b", "\u2212300", "C2", "must be above zero"),
        ("fc", None, "E2", "missing; give fc"),
        ("member", None, "A2", "missing; give member"),
        ("member", date(2024, 3, 1), "A2", "a date or time is not a member; format the cell as text"),
        ("dp", "300; 700; 300", "G2", "the tendon at 700 mm lies outside the section"),
        ("dp", "300; 500", "G2", "2 depths given; parabola over 1 span needs 3"),
        ("fpj", 2000, "H2", "stress of 2000 MPa is above fpu = 1860 MPa"),
        ("fpj", None, "H2", "neither fpj nor fpe is given"),
        ("fpe", 1000, "I2", "both fpj and fpe are given; leave one of them blank"),
        ("shape", "rectangel", "I2", "is not one of the choices; did you mean rectangle?"),
        ("jack", "top", "I2", "choose one of left, right, both"),
        ("self_weight", 1, "I2", "is not yes or no"),
        ("k_ec2", 0.01, "I2", ""),
        ("elements", 12.5, "I2", "is not a whole number"),
    ],
)
def test_bad_cell(book, beam, column, value, cell, wrong):
    path = book(beam | {column: value}, beam | {"member": "good"})
    assert [row.member is not None for row in read_inputs(path).rows] == [not wrong, True]
    assert wrong in faults(path).get(cell, "")


def test_bars_outside(book, beam):
    path = book(beam | {"As": "400; 300", "ds": "550; 610"})
    assert "bars at 610 mm lie outside the section, which is 600 mm deep" in faults(path)["J2"]


def test_every_fault_of_a_row_at_once(book, beam):
    path = book(beam | {"b": "wide", "fc": -1, "dp": "300; 700; 300", "fpj": 2000})
    assert set(faults(path)) == {"C2", "E2", "G2", "H2"}
    row = read_inputs(path).rows[0]
    assert row.message == "b in members!C2: a text is not a number (and 3 more, see the sheet problems)"


def test_problem_shows_the_cell_as_typed(book, beam):
    row = beam | {"fpj [ksi]": 290}
    del row["fpj"]
    (problem,) = problems(book(row))
    assert problem.row() == (
        "members",
        "H2",
        "fpj [ksi]",
        290,
        "stress of 290 ksi is above fpu = 269.8 ksi",
        "give a stress below fpu; check the unit in the header",
    )


def test_faults_are_told_in_the_units_of_the_cell(book, beam):
    """Whatever the other headers are in."""
    row = beam | {"dp": "300; 700; 300", "fpj [ksi]": 290}
    del row["fpj"]
    assert "lies outside the section, which is 600 mm deep" in faults(book(row))["G2"]
    row = row | {"dp [in]": "12; 28; 12"}
    del row["dp"]
    assert "the tendon at 28 in lies outside" in faults(book(row))["H2"]


def test_missing_column_is_reported_once(book, beam):
    del beam["fc"]
    found = problems(book(beam, beam | {"member": "B2"}))
    assert [str(problem) for problem in found] == [
        "members!H1  fc: there is no such column; give fc: cylinder strength of the concrete"
    ]


def test_missing_and_misspelled_column(book, beam):
    beam["Fcc"] = beam.pop("fc")
    found = {p.place.column: p.cure for p in problems(book(beam))}
    assert found["Fcc"] == "did you mean fc?"
    assert "cylinder strength" in found["fc"]


def test_unknown_unit(book, beam):
    beam["span [yd]"] = beam.pop("span")
    path = book(beam)
    assert faults(path) == {"H1": "there is no unit yd; use one of mm, cm, m, in, ft"}
    assert read_inputs(path).rows[0].member is None


def test_column_given_twice(book, beam):
    path = book(beam | {"fc [MPa]": 40})
    assert faults(path) == {cell: "this column is given twice; keep one of them" for cell in ("E1", "I1")}


def test_column_in_two_units_both_filled(book, beam):
    path = book(beam | {"b [in]": 12}, {**beam, "member": "B2", "b": None, "b [in]": 12})
    assert faults(path) == {"C2": "b is given in I2 as well; leave all but one blank"}
    assert [row.member is not None for row in read_inputs(path).rows] == [False, True]


def test_column_in_two_units_neither_filled(book, beam):
    path = book(beam | {"b": None, "b [in]": None})
    assert faults(path) == {"C2": "missing; give b: overall width"}


def test_fault_stands_where_the_value_does(book, beam):
    path = book(beam | {"b": None, "b [in]": -12})
    assert faults(path) == {"I2": "must be above zero; give overall width"}


def test_duplicate_names(book, beam):
    path = book(beam, beam | {"member": "B2"}, beam | {"member": " B1 "})
    assert faults(path) == {
        "A2": "the same name stands in A4; give every member its own name",
        "A4": "the same name stands in A2; give every member its own name",
    }
    assert [row.member is not None for row in read_inputs(path).rows] == [False, True, False]


# --- formulas ---


def stored(path, cell: bytes, formula: bytes, value: bytes, kind: bytes = b""):
    """Give a formula its stored value, as Excel does."""
    copy = path.with_name("stored.xlsx")
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(copy, "w") as new:
        for name in old.namelist():
            content = old.read(name)
            if name.endswith("sheet1.xml"):
                before = b'<c r="%s"><f>%s</f><v /></c>' % (cell, formula)
                assert content.count(before) == 1
                content = content.replace(
                    before, b'<c r="%s"%s><f>%s</f><v>%s</v></c>' % (cell, kind, formula, value)
                )
            new.writestr(name, content)
    return copy


def test_formula_without_stored_value(book, beam):
    path = book(beam | {"fc": "=20+20"})
    assert faults(path)["E2"].startswith("the formula has no stored value; open the workbook in Excel")
    assert str(problems(path)[0].row()[3]) == "=20+20"


def test_formula_with_stored_value(book, beam):
    path = stored(book(beam | {"fc": "=20+20"}), b"E2", b"20+20", b"40")
    assert read_inputs(path).rows[0].member.fc == 40.0


def test_formula_that_gives_an_error(book, beam):
    path = stored(book(beam | {"fc": "=1/0"}), b"E2", b"1/0", b"#DIV/0!", b' t="e"')
    assert "shows the error #DIV/0!" in faults(path)["E2"]


def test_formula_that_gives_an_empty_text_is_blank(book, beam):
    path = stored(book(beam | {"ft": "=T(1)"}), b"I2", b"T(1)", b"", b' t="str"')
    assert read_inputs(path).rows[0].problems == []
