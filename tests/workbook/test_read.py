"""From workbooks to members: where tables are found, units, defaults, optional sheets."""

import pytest
from openpyxl import Workbook, load_workbook

from ptbatch.workbook.inputs import read_inputs


def only_row(path):
    """The one row of a workbook; shows its problems if there is no member."""
    inputs = read_inputs(path)
    assert [str(problem) for problem in inputs.all_problems() if not problem.warning] == []
    return inputs.rows[0]


def test_plain_row(book, beam):
    row = only_row(book(beam))
    assert (row.name, row.number, row.problems) == ("B1", 2, [])
    assert (row.member.span, row.member.dp, row.member.fpj) == ((12000.0,), (300.0, 500.0, 300.0), 1395.0)


def test_si_and_us_give_the_same_member(book):
    si = {"member": "B1", "span [m]": 12.192, "b [cm]": 30.48, "h [mm]": 609.6, "fc [MPa]": 41.36854375901}
    si |= {"Aps [mm\u00b2]": 592.25688, "dp [mm]": "304.8; 508; 304.8", "fpj [GPa]": 1.3961883518665931}
    si |= {
        "K [1/m]": 0.0032808398950131,
        "w_live [N/m]": 10215.7320560454,
        "density [kg/m3]": 2402.7695056029,
    }
    us = {"member": "B1", "span [ft]": 40, "b [in]": 12, "h [ft]": 2, "fc [psi]": 6000, "Aps [in2]": 0.918}
    us |= {
        "dp [in]": "12; 20; 12",
        "fpj [ksi]": 202.5,
        "K [1/ft]": 0.001,
        "w_live [klf]": 0.7,
        "density [pcf]": 150,
    }
    first, second = only_row(book(si, name="si.xlsx")).member, only_row(book(us, name="us.xlsx")).member
    for name, value in vars(first).items():
        plain = isinstance(value, str | bool | None) or value == ()
        same = value if plain else pytest.approx(value, rel=1e-11)  # closed form
        assert getattr(second, name) == same, name


def test_header_anywhere_near_the_top_and_blank_rows(tmp_path, beam):
    book = Workbook()
    page = book.active
    page.title = "Bridge 7"
    page["A1"] = "Beams of the bridge"
    for column, (name, value) in enumerate(beam.items(), 2):
        page.cell(4, column, name)
        page.cell(5, column, value)
        page.cell(9, column, "B2" if name == "member" else value)
    page["D7"] = "  "
    book.save(tmp_path / "b.xlsx")
    assert [(row.name, row.number) for row in read_inputs(tmp_path / "b.xlsx").rows] == [("B1", 5), ("B2", 9)]


def test_names_match_in_any_case_unless_they_collide(book, beam):
    beam |= {"FC": beam.pop("fc"), "B": "mark of the office"}
    inputs = read_inputs(book(beam))
    assert inputs.rows[0].member.fc == 40.0
    assert inputs.extra_headers == ["B"]
    assert inputs.rows[0].extra == ("mark of the office",)


@pytest.mark.parametrize("name", ["NA", "001", "=1+1", "nan", "B\u00b2"])
def test_names_are_texts(book, beam, name):
    path = book(beam)
    workbook = load_workbook(path)
    workbook["members"]["A2"].value = name
    workbook["members"]["A2"].data_type = "s"
    workbook.save(path)
    assert only_row(path).member.member == name


def test_numbers_serve_as_names(book, beam):
    assert only_row(book(beam | {"member": 7})).name == "7"


def test_choices_and_yes_no_in_the_users_spelling(book, beam):
    member = only_row(book(beam | {"live": "Third points", "self_weight": False, "kind": "SLAB"})).member
    assert (member.live, member.self_weight, member.kind) == ("third-points", False, "slab")
    assert only_row(book(beam | {"self_weight": "No"})).member.self_weight is False


def test_all_spans(book, beam):
    assert only_row(book(beam | {"live_spans": "All"})).member.live_spans == (1,)


def test_numbers_typed_as_text(book, beam):
    beam |= {"fc": " 40.0 ", "harp": "1/3; 0.7", "profile": "harped", "b": "3e2", "dp": "300;500 ; 300"}
    assert only_row(book(beam)).member.harp == (1 / 3, 0.7)


def test_unknown_columns_are_warned_about_and_kept(book, beam):
    inputs = read_inputs(book(beam | {"mark": "W7", "Apps [mm2]": 3}))
    assert inputs.rows[0].member is not None
    assert inputs.rows[0].message == ""
    assert inputs.extra_headers == ["mark", "Apps [mm2]"]
    assert [problem.cure for problem in inputs.problems] == [
        "nothing to do if it is a note",
        "did you mean Aps?",
    ]
    assert all(problem.warning for problem in inputs.problems)


def test_notes_are_kept_without_a_warning(book, beam):
    loads = [{"member": "B1", "case": "live", "type": "point", "x": 6000, "value": 10, "note": "crane"}]
    inputs = read_inputs(book(beam | {"live": "loads", "Note": "=from the drawing"}, loads=loads))
    assert inputs.all_problems() == []
    assert inputs.extra_headers == ["Note"]


def test_a_column_in_two_units(book, beam):
    del beam["span"]
    rows = beam | {"span [m]": 12}, beam | {"member": "B2", "span [ft]": 40}
    inputs = read_inputs(book(*rows))
    assert inputs.all_problems() == []
    assert [row.member.span for row in inputs.rows] == [(12000.0,), (40 * 304.8,)]


def test_loads_in_two_units(book, beam):
    point = {"member": "B1", "case": "live", "type": "point", "x": 6000, "value [kip]": 10}
    line = {"member": "B1", "case": "live", "type": "uniform", "value [kN/m]": 3}
    member = only_row(book(beam | {"live": "loads"}, loads=[point, line])).member
    assert [load.value for load in member.loads] == [pytest.approx(44482.216), 3.0]
