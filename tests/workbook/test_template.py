"""The template: it runs as it is, its headers explain themselves, and Excel refuses what cannot be right."""

import pytest
from openpyxl import load_workbook

from ptbatch.workbook.column import LISTS
from ptbatch.workbook.columns import BY_NAME
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.page import TEXT
from ptbatch.workbook.template import SHEETS, write_template
from ptbatch.workbook.units import parse_header

SYSTEMS = ("SI", "US")


@pytest.fixture(scope="module", params=SYSTEMS)
def path(request, tmp_path_factory):
    """A template of each unit system."""
    return write_template(tmp_path_factory.mktemp("template") / "new.xlsx", request.param)


@pytest.fixture(scope="module")
def book(path):
    return load_workbook(path)


def test_rows_are_sound(path):
    inputs = read_inputs(path)
    assert inputs.all_problems() == []
    members = {row.name: row.member for row in inputs.rows}
    assert [len(member.span) for member in members.values()] == [1, 3, 1, 2, 1]
    assert {member.shape for member in members.values()} == {"rectangle", "tee"}
    assert len(members["Grouted beam"].profile_points) == 5
    assert len(members["Slab strip"].bars) == 2
    assert len(members["Harped, two spans"].loads) == 4
    assert members["Simple beam"].h == pytest.approx(600, rel=0.05)  # 24 in is a little more


def test_sheets(book):
    assert book.sheetnames == ["members", "profile", "rebar", "loads", "settings", "columns"]
    assert all(book[name].freeze_panes == "B2" for name in book.sheetnames)


def test_every_header_says_what_it_is(book):
    for name, columns in SHEETS.items():
        comments = [cell.comment.text for cell in book[name][1]]
        assert all(map(str.startswith, comments, [column.meaning for column in columns]))
    comments = {parse_header(cell.value).name: cell.comment.text for cell in book["members"][1]}
    us = "span [ft]" in [cell.value for cell in book["members"][1]]
    assert f"default: 1860 MPa{' (269.77 ksi)' * us}\nsource: ASTM A416, grade 270" in comments["fpu"]
    assert f"limit: zero or more\ndefault: 6 mm{' (0.23622 in)' * us}" in comments["set"]
    assert "choices: beam, slab" in comments["kind"]


def test_every_column_is_explained(book):
    explained = [row[:2] for row in book["columns"].iter_rows(min_row=2, values_only=True)]
    assert explained == [(sheet, column.name) for sheet, columns in SHEETS.items() for column in columns]


def rules(page) -> dict:
    """Data validations by name of the column."""
    names = {cell.column_letter: parse_header(cell.value).name for cell in page[1]}
    return {
        names["".join(filter(str.isalpha, str(rule.sqref).split(":")[0]))]: rule
        for rule in page.data_validations.dataValidation
    }


def test_excel_refuses_a_wrong_choice(book):
    found = rules(book["members"])
    for name, column in BY_NAME.items():
        if column.kind == "choice":
            assert found[name].formula1 == f'"{",".join(column.choices)}"'
            assert (found[name].type, found[name].errorStyle, found[name].showErrorMessage) == (
                *("list", "stop"),
                True,
            )
    assert found["self_weight"].formula1 == '"yes,no"'
    assert rules(book["loads"])["case"].formula1 == '"dead,live"'


def test_excel_refuses_numbers_beyond_their_limit(book):
    found = rules(book["members"])
    assert (found["fc"].type, found["fc"].operator, found["fc"].formula1) == ("decimal", "greaterThan", "0")
    assert (found["set"].operator, found["elements"].type) == ("greaterThanOrEqual", "whole")
    assert found["inflection"].operator == "between"
    assert not any(BY_NAME[name].kind in (*LISTS, "text") for name in found)


def test_what_excel_would_make_a_date_or_a_number_of_is_text(book):
    page = book["members"]
    letters = {parse_header(cell.value).name: cell.column_letter for cell in page[1]}
    for name in ("member", "harp", "live_spans", "note"):
        assert page.column_dimensions[letters[name]].number_format == TEXT
    assert page[f"{letters['harp']}5"].number_format == TEXT
    assert page.column_dimensions[letters["span"]].number_format == "General"
