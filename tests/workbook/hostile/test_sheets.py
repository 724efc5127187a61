"""What people do to a sheet around its rows: titles, groups, totals, merged and hidden cells, mistakes."""

import pytest
from openpyxl import Workbook, load_workbook

from ptbatch.batch import run_workbook
from ptbatch.workbook.inputs import read_inputs


@pytest.fixture
def edited(book):
    """edited(*rows, edit=function of the sheet) writes the rows and lets the function loose on them."""

    def make(*rows, edit):
        path = book(*rows)
        workbook = load_workbook(path)
        edit(workbook["members"])
        workbook.save(path)
        return path

    return make


def states(path) -> list[tuple[str, bool]]:
    """Names of the rows and whether they are sound."""
    return [(row.name, row.member is not None) for row in read_inputs(path).rows]


def test_groups_of_columns_above_the_header(edited, beam):
    def group(sheet):
        sheet.insert_rows(1)
        sheet["B1"], sheet["E1"] = "Geometry", "Material"
        sheet.merge_cells("B1:D1")
        sheet.merge_cells("E1:F1")

    assert states(edited(beam, edit=group)) == [("B1", True)]


def test_a_merged_header_hides_a_column(edited, beam):
    """Excel keeps the left one of the headers: the other is missing, and that is said."""
    path = edited(beam, edit=lambda sheet: sheet.merge_cells("C1:D1"))
    (problem,) = read_inputs(path).all_problems()
    assert (problem.place.column, problem.wrong) == ("h", "there is no such column")


def test_merged_cells_hold_one_value(edited, beam):
    path = edited(beam, beam | {"member": "B2"}, edit=lambda sheet: sheet.merge_cells("C2:C3"))
    assert states(path) == [("B1", True), ("B2", False)]
    (problem,) = read_inputs(path).all_problems()
    assert (problem.place.cell, problem.wrong) == ("C3", "missing")


def test_hidden_and_filtered_rows_count_like_the_others(edited, beam):
    def hide(sheet):
        sheet.row_dimensions[2].hidden = True
        sheet.column_dimensions["E"].hidden = True
        sheet.auto_filter.ref = "A1:H3"

    assert states(edited(beam, beam | {"member": "B2"}, edit=hide)) == [("B1", True), ("B2", True)]


def test_a_line_of_totals_is_a_faulty_row_and_harms_no_other(edited, beam):
    path = edited(beam, edit=lambda sheet: sheet.append(["Total", 12000, None, None, None, 592]))
    assert states(path) == [("B1", True), ("Total", False)]
    assert {p.place.cell for p in read_inputs(path).all_problems()} == {"C3", "D3", "E3", "G3", "H3"}


def test_line_breaks_in_headers(book, beam):
    beam["span\n[m]"] = beam.pop("span") / 1000
    beam["Aps \n [cm\u00b2]"] = beam.pop("Aps") / 100
    assert states(book(beam)) == [("B1", True)]


@pytest.mark.parametrize("value", [1e308, 5e-324, "1e400"])
def test_numbers_at_the_ends_of_what_a_computer_holds(book, beam, value):
    """Refused, or told to be beyond what is built; nothing overflows."""
    inputs = read_inputs(book(beam | {"b": value}, beam | {"member": "B2"}))
    assert inputs.rows[1].member is not None
    assert any(problem.place.column == "b" for problem in inputs.rows[0].problems)


def test_sixteen_thousand_columns_are_refused(tmp_path):
    book = Workbook(write_only=True)
    book.create_sheet("members").append(["member", *range(16_000)])
    book.save(tmp_path / "wide.xlsx")
    with pytest.raises(Exception, match="beyond column 1000"):
        read_inputs(tmp_path / "wide.xlsx")


def test_ten_thousand_faulty_rows(tmp_path, beam, engine):
    """Every fault is listed, and the one good row at the end is computed."""
    rows = 10_000
    book = Workbook(write_only=True)
    sheet = book.create_sheet("members")
    sheet.append(list(beam))
    for i in range(rows):
        sheet.append(list((beam | {"member": f"R{i}", "fc": "high", "b": -1}).values()))
    sheet.append(list((beam | {"member": "good"}).values()))
    book.save(tmp_path / "many.xlsx")
    batch = run_workbook(tmp_path / "many.xlsx")
    assert (batch.counts["invalid"], batch.counts["ok"]) == (rows, 1)
    results = load_workbook(batch.path, read_only=True)
    assert sum(1 for _ in results["problems"].iter_rows(min_row=2)) == 2 * rows
