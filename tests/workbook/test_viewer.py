"""The sheets that make results readable: viewer, legend, filters, colours."""

import re

import pytest
from openpyxl import load_workbook

from ptbatch.batch import run_workbook
from ptbatch.workbook.legend import MEANINGS, legend
from ptbatch.workbook.places import PLACES, Places
from ptbatch.workbook.results import CURVES, DETAILS, HEAD, PROBLEMS, SUMMARY, TENDON, Outcome
from ptbatch.workbook.site import SHEET, site_headers
from ptbatch.workbook.viewer import FIRST, write_viewer
from ptbatch.workbook.write import Book

STAGES = ("jacked", "set", "anchored", "service", "peak")


def outcome(points: int, steps: int, stages=STAGES) -> Outcome:
    """Numbers that tell where they come from."""
    tendon = [
        (stage, 10.0 * i, 1000.0 + i, "" if stage == "peak" else 900.0 + i, 0.0)
        for stage in stages
        for i in range(points)
    ]
    events = {1: "cracking, yield", steps - 1: "peak"}
    curves = [(i, i, 5.0 * i, 2.0 * i, 0, 0, 0, 0, events.get(i, "")) for i in range(steps)]
    return Outcome("ok", "", {}, columns(TENDON, tendon), columns(CURVES, curves))


def columns(headers, lines) -> dict:
    """A table of lines by header."""
    return dict(zip(headers[1:], map(list, zip(*lines, strict=True)), strict=bool(lines)))


@pytest.fixture
def viewer(tmp_path):
    """viewer((name, outcome), ...) writes a viewer; its sheet with formulas, and with values."""

    def make(*members):
        places, book = Places(), Book()
        for name, result in members:
            line = dict.fromkeys((*HEAD, *SUMMARY), 1.5) | {"member": name, "status": "ok", "failure": "=1+1"}
            places.add(line, result)
        write_viewer(book, places, 0)
        path = book.save(tmp_path / "v.xlsx")
        return [load_workbook(path, data_only=stored)["viewer"] for stored in (False, True)]

    return make


def column(sheet, head) -> list:
    """Values below a head."""
    (at,) = [cell.column for cell in sheet[2] if cell.value == head]
    return [sheet.cell(row, at).value for row in range(FIRST, sheet.max_row + 1)]


def test_values_of_the_first_member_are_stored(viewer):
    _, values = viewer(("B1", outcome(3, 4)), ("B2", outcome(5, 6)))
    assert values["B1"].value == "B1"
    assert values["B3"].value == "=1+1"
    assert column(values, "x [mm]")[:5] == [0, 10, 20, 20, 20]
    assert column(values, "stress_fe set")[:5] == [1000, 1001, 1002, "#N/A", "#N/A"]
    assert column(values, "stress_analytic jacked")[:3] == [900, 901, 902]
    assert column(values, "load [kN]")[:6] == [0, 5, 10, 15, "#N/A", "#N/A"]
    assert column(values, "load at yield")[:4] == ["#N/A", 5, "#N/A", "#N/A"]
    assert column(values, "load at peak")[:4] == ["#N/A", "#N/A", "#N/A", 15]


def test_every_formula_has_a_value(viewer):
    formulas, values = viewer(("B1", outcome(3, 4)), ("B2", outcome(5, 6)))
    found = [cell for row in formulas.iter_rows() for cell in row if cell.data_type == "f"]
    assert len(found) > 50
    assert all(values[cell.coordinate].value is not None for cell in found)


def test_no_text_of_a_user_is_in_a_formula(viewer):
    name = '=cmd("x")'
    formulas, _ = viewer((name, outcome(3, 4)), ("*", outcome(3, 4)))
    assert (formulas["B1"].value, formulas["B1"].data_type, formulas["B1"].number_format) == (name, "s", "@")
    texts = [cell.value for row in formulas.iter_rows() for cell in row if cell.data_type == "f"]
    functions = {word for text in texts for word in re.findall(r"([A-Z]+)\(", text)}
    assert functions == {
        "SUMPRODUCT",
        "EXACT",
        "ROW",
        "INDEX",
        "IF",
        "IFERROR",
        "NA",
        "MIN",
        "ISNUMBER",
        "FIND",
    }
    assert not any("cmd" in text for text in texts)
    assert not any("MATCH" in text for text in texts)  # it would take * for a pattern


def test_numbers_that_are_none(viewer):
    """A number that is not finite would make Excel call the file damaged."""
    result = outcome(3, 4)
    result.tendon["stress_fe [MPa]"][1] = float("nan")
    _, values = viewer(("B1", result))
    assert column(values, "stress_fe jacked")[:3] == [1000, "#N/A", 1002]


def test_places():
    places = Places()
    places.add({"member": "bad"}, None)
    places.add({"member": "B1"}, outcome(3, 4))
    places.add({"member": "stuck"}, Outcome("not converged", "", {}, outcome(2, 1, STAGES[:2]).tendon))
    places.add({"member": "B2"}, outcome(5, 6))
    lines = [dict(zip(PLACES, place.line(), strict=True)) for place in places.places]
    assert [line["summary"] for line in lines] == [2, 3, 4]
    assert [line["jacked"] for line in lines] == [1, 16, 20]
    assert [line["peak"] for line in lines] == [13, "none", 40]
    assert [line["curves"] for line in lines] == [1, "none", 5]
    assert (places.most_points, places.most_steps) == (5, 6)


def test_charts_and_choice(viewer):
    formulas, _ = viewer(("B1", outcome(3, 4)), ("B2", outcome(5, 6)))
    (rule,) = formulas.data_validations.dataValidation
    assert (rule.type, rule.formula1, str(rule.sqref)) == ("list", "places!$A$2:$A$3", "B1")
    stress, curve = formulas._charts
    assert (len(stress.series), len(curve.series)) == (7, 4)
    assert [s.yVal.numRef.f for s in curve.series][0] == "'viewer'!$AF$3:$AF$8"


def test_results_with_a_viewer(book, beam, engine):
    source = book(beam | {"member": "@sum"}, beam | {"member": "@B2", "fc": "x", "=note": "=A1"})
    results = load_workbook(run_workbook(source).path)
    assert results["places"].sheet_state == "hidden"
    assert results["viewer"]["B1"].value == "@sum"
    for page in results.worksheets:
        formulas = [c.value for row in page.iter_rows() for c in row if c.data_type == "f"]
        assert page.title == "viewer" or not formulas
        assert not any("A1" in text.replace("$", "").split("(")[0] for text in formulas)
    summary = results["summary"]
    assert summary.auto_filter.ref.startswith("A1:")
    assert summary.auto_filter.ref.endswith("3")
    coloured = [rule.formula[0] for rules in summary.conditional_formatting for rule in rules.rules]
    assert '"not converged"' in coloured
    assert summary["A1"].comment.text.startswith("name as typed")
    assert summary["D2"].number_format == "0.0"


def test_no_viewer_of_nothing(book, beam, engine):
    names = load_workbook(run_workbook(book(beam | {"fc": "x"})).path).sheetnames
    assert "viewer" not in names
    assert "legend" in names


def test_legend_knows_every_column():
    sheets = {"summary": (*HEAD, *SUMMARY), **DETAILS, "problems": PROBLEMS}
    sheets[SHEET] = site_headers("SI")
    lines = list(legend(sheets))
    assert len(lines) == sum(map(len, sheets.values())) == sum(map(len, MEANINGS.values()))
    assert ["summary", "load_peak", "kN"] in [line[:3] for line in lines]
    assert list(legend({"summary": ["mark [x]"]})) == [["summary", "mark [x]", "-", "as typed in the input"]]
