"""Results workbooks: what is written can be read back, and the file is whole or not there."""

import os
from datetime import date, datetime

import pytest
from openpyxl import load_workbook

from ptbatch.batch import results_path, run_workbook
from ptbatch.errors import WriteError
from ptbatch.workbook import write
from ptbatch.workbook.results import PROBLEMS, SUMMARY
from ptbatch.workbook.write import Sheet, write_workbook


def round_trip(path, *values):
    write_workbook(path, [Sheet("one", [f"h{i}" for i in range(len(values))], [values])])
    return next(load_workbook(path)["one"].iter_rows(min_row=2))


def sheet(path, name) -> list[dict]:
    """Rows of a sheet by header."""
    headers, *rows = load_workbook(path)[name].iter_rows(values_only=True)
    return [dict(zip(headers, row, strict=True)) for row in rows]


@pytest.mark.parametrize("text", ["=1+1", "+1", "-1", "@sum", "NA", "001", "TRUE", "1e5", "#N/A", "  x"])
def test_text_stays_text(tmp_path, text):
    (cell,) = round_trip(tmp_path / "a.xlsx", text)
    assert (cell.value, cell.data_type) == (text, "s")


@pytest.mark.parametrize("value", [0.1, -1e-300, 3, True, date(2024, 3, 1)])
def test_values_keep_their_type(tmp_path, value):
    (cell,) = round_trip(tmp_path / "a.xlsx", value)
    assert getattr(cell.value, "date", lambda: cell.value)() == value


def test_what_excel_cannot_hold(tmp_path):
    values = [
        cell.value for cell in round_trip(tmp_path / "a.xlsx", float("nan"), "a\x00\x0bb", "x" * 40_000)
    ]
    assert values[:2] == ["not a finite number", "ab"]
    assert len(values[2]) == 32_767
    assert values[2].endswith(" ...")


def test_look(tmp_path):
    write_workbook(tmp_path / "a.xlsx", [Sheet("s", ["member", "load [kN]"], [["B1", 1.23456]])])
    page = load_workbook(tmp_path / "a.xlsx")["s"]
    assert page.freeze_panes == "B2"
    assert page["A1"].font.bold
    assert page["B2"].number_format == "0.0"
    assert page.column_dimensions["A"].width == 26


MIXED = [
    ["=1+1", 0.1, 3, True, None, "", "a & b < c > d", " space ", "two\nlines", "'quoted'"],
    ["\x00", 0.2, -3, True, "", "\x01\x02", "tail ", "=", 1e22, "0"],
    ["+1", -1e-300, 2**40, False, "é 漢 \u2212", "]]>", '"', "\ttab", "@x", "-"],
    ["date", 1 / 3, 0, date(2024, 3, 1), float("inf"), "x" * 40_000, "\x00", "<is>", "NA", "001"],
]


def test_rows_as_markup_are_those_of_openpyxl(tmp_path, monkeypatch):
    """Values, types and styles, cell by cell; the usual way is what counts."""
    headers = ["member", "load [kN]", *(f"h{i} [MPa]" for i in range(8))]
    sheets = [Sheet("s", headers, MIXED)]
    quick = load_workbook(write_workbook(tmp_path / "quick.xlsx", sheets))["s"]
    monkeypatch.setattr("ptbatch.workbook.page.takes_markup", lambda *_: False)
    usual = load_workbook(write_workbook(tmp_path / "usual.xlsx", sheets))["s"]
    assert quick.dimensions == usual.dimensions == "A1:J5"
    for row, expected in zip(quick.iter_rows(), usual.iter_rows(), strict=True):
        for one, other in zip(row, expected, strict=True):
            assert one.value == other.value
            assert one.data_type == other.data_type or one.value is None
            assert (one.number_format, one.quotePrefix) == (other.number_format, other.quotePrefix)


def test_rows_that_come_together(tmp_path):
    """As many rows as there are, whether or not they can go as markup, below those before."""
    book = write.Book()
    page = book.page("s", ["member", "load [kN]"])
    page.extend([["A", "A"], [1.5, "none"]])
    page.extend([["B", "B"], [2.5, date(2024, 3, 1)]])
    page.add(["C", 3.5])
    page.extend([[], []])
    page.extend([["D", "=D"], [4.5, 5]])
    page.filtered()
    sheet = load_workbook(book.save(tmp_path / "s.xlsx"))["s"]
    expected = [("A", 1.5), ("A", "none"), ("B", 2.5), ("B", datetime(2024, 3, 1)), ("C", 3.5), ("D", 4.5)]
    assert list(sheet.iter_rows(min_row=2, values_only=True)) == [*expected, ("=D", 5)]
    assert sheet.auto_filter.ref == "A1:B8"


def test_columns_of_numbers_keep_every_digit(tmp_path):
    """Also the largest and the smallest, and beside a number that no cell can hold."""
    numbers = [0.1, 1 / 3, -0.0, 1e-5, 1e16, -1.25e22, 5e-324, 1.7976931348623157e308, 123456.0]
    book = write.Book()
    page = book.page("s", ["load [kN]", "moment [kNm]"])
    page.extend([numbers, [*numbers[:-1], float("nan")]])
    sheet = load_workbook(book.save(tmp_path / "s.xlsx"))["s"]
    first, second = ([cell.value for cell in column[1:]] for column in sheet.columns)
    assert [float(value).hex() for value in first] == [value.hex() for value in numbers]
    assert second == [*numbers[:-1], "not a finite number"]


@pytest.mark.parametrize("column", [[0, -7, 2**70], [0, None, 2.5, True, False, "", "a", 0.0], [None, None]])
def test_columns_of_one_kind_and_of_several(tmp_path, column):
    """Zero and no are not blank."""
    book = write.Book()
    page = book.page("s", ["member", "value"])
    page.extend([["A"] * len(column), column])
    sheet = load_workbook(book.save(tmp_path / "s.xlsx"))["s"]
    found = [cell.value for cell in sheet["B"][1:]]
    assert [(value, type(value)) for value in found] == [
        (value, type(value)) if value != "" else (None, type(None)) for value in column
    ]


def test_a_sheet_that_has_no_room_for_all_takes_none(tmp_path, monkeypatch):
    monkeypatch.setattr("ptbatch.workbook.page.LAST_ROW", 4)
    book = write.Book()
    try:
        page = book.page("s", ["member"])
        page.extend([["A", "B"]])
        with pytest.raises(WriteError, match="has 4 rows"):
            page.extend([["C", "D"]])
        page.add(["C"])
        with pytest.raises(WriteError):
            page.add(["D"])
    finally:
        book.discard()


def test_openpyxl_takes_markup(monkeypatch):
    """If this fails with a new openpyxl, results are as right as before and four times as slow."""
    book = write.Book()
    try:
        assert book.page("s", ["a"])._quick
    finally:
        book.discard()


# --- the file ---

SHEETS = [Sheet("s", ["a"], [[1.0]])]


def names(folder) -> list[str]:
    return sorted(os.listdir(folder))


def test_replaces_the_old_file(tmp_path):
    path = tmp_path / "a.xlsx"
    path.write_text("old")
    assert write_workbook(path, SHEETS) == path
    assert names(tmp_path) == ["a.xlsx"]
    assert load_workbook(path)["s"]["A2"].value == 1.0


def test_takes_the_next_free_name_if_the_file_is_in_use(tmp_path, monkeypatch):
    path, replace = tmp_path / "a.results.xlsx", os.replace
    path.write_text("open in Excel")
    (tmp_path / "a.results-2.xlsx").write_text("another")

    def in_use(source, target):
        if target == path:
            raise PermissionError(13, "in use")
        replace(source, target)

    monkeypatch.setattr(os, "replace", in_use)
    assert write_workbook(path, SHEETS) == tmp_path / "a.results-3.xlsx"
    assert path.read_text() == "open in Excel"
    assert len(names(tmp_path)) == 3


@pytest.mark.parametrize("step", ["fsync", "replace"])
def test_failure_leaves_the_old_file(tmp_path, monkeypatch, step):
    path = tmp_path / "a.xlsx"
    path.write_text("old")

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, step, full)
    with pytest.raises(WriteError, match="No space left on device"):
        write_workbook(path, SHEETS)
    assert (names(tmp_path), path.read_text()) == (["a.xlsx"], "old")


def test_what_is_on_disk_is_verified(tmp_path, monkeypatch):
    monkeypatch.setattr(write.ZipFile, "testzip", lambda self: "xl/workbook.xml")
    with pytest.raises(WriteError, match="not what was written"):
        write_workbook(tmp_path / "a.xlsx", SHEETS)
    assert names(tmp_path) == []


def test_no_such_folder(tmp_path):
    with pytest.raises(WriteError, match="cannot be written"):
        write_workbook(tmp_path / "none" / "a.xlsx", SHEETS)


# --- results ---


def test_results(book, beam, engine):
    source = book(
        beam | {"note": "=A1", "Status": "as built"},
        beam | {"member": "@B2", "fc": "x", "dp": "1;2", "note": 7},
        beam | {"member": "stuck"},
        beam | {"member": "held", "support_right": "pin"},
    )
    before = source.read_bytes()
    batch = run_workbook(source, jobs=2)
    assert source.read_bytes() == before
    assert batch.path == results_path(source) == source.with_name("beams.results.xlsx")
    sheets = [
        "summary",
        "viewer",
        "tendon",
        "curves",
        "cracks",
        "problems",
        "members",
        "run",
        "legend",
        "places",
    ]
    assert load_workbook(batch.path).sheetnames == sheets
    summary = sheet(batch.path, "summary")
    assert list(summary[0]) == ["member", "status", "message", *SUMMARY, "note", "Status"]
    assert [row["status"] for row in summary] == ["ok", "invalid", "not converged", "warning"]
    assert [row["member"] for row in summary] == ["B1", "@B2", "stuck", "held"]
    assert [row["note"] for row in summary] == ["=A1", 7, None, None]
    assert summary[0]["load_peak [kN]"] == 1.25
    assert summary[1]["load_peak [kN]"] == "invalid input"
    assert summary[1]["message"].endswith("(and 1 more, see the sheet problems)")
    assert summary[2]["load_peak [kN]"] == "not reached: no equilibrium"
    assert "take part of the prestress" in summary[3]["message"]


def test_other_sheets(book, beam, engine):
    source = book(
        beam | {"nte": 1}, beam | {"member": "B2", "fc": "x"}, settings=[{"name": "mu", "value": 0.2}]
    )
    path = run_workbook(source).path
    assert [(row["member"], row["stage"]) for row in sheet(path, "tendon")] == [("B1", "jacked")]
    assert [(row["member"], row["event"]) for row in sheet(path, "curves")] == [("B1", "peak")] * 2
    assert [tuple(row) for row in sheet(path, "problems")] == [PROBLEMS] * 2
    assert [row["cell"] for row in sheet(path, "problems")] == ["I1", "E3"]
    assert sheet(path, "problems")[0]["what is wrong"] == "warning: unknown column"
    run = {row["name"]: row["value"] for row in sheet(path, "run")}
    assert (run["rows"], run["rows ok"], run["rows invalid"], run["setting mu"]) == (2, 1, 1, 0.2)
    assert len(run["input sha256"]) == 64
    assert run["input"] == str(source)


def test_column_with_the_name_of_a_result(book, beam, engine):
    path = run_workbook(book(beam | {"failure": "none so far"})).path
    assert sheet(path, "summary")[0]["failure (input)"] == "none so far"


def test_input_is_never_the_target(book, beam, engine):
    source = book(beam)
    with pytest.raises(WriteError, match="never touched"):
        run_workbook(source, source)
