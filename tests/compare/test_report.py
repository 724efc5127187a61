"""The table in the terminal, the sheet and the report in Markdown."""

import pytest
from openpyxl import load_workbook

from ptbatch.compare import report
from ptbatch.compare.comparison import compare_workbooks

ROWS = (
    {"rtol": 0.1, "value": 190, "note": "Ours | theirs."},
    {"value": 190, "case": "Second"},
    {"value": 1, "case": "Second", "not_reproducible": "a misprint"},
    {"value": None, "case": "Second", "not_reproducible": "a misprint", "quantity": "camber_anchored [mm]"},
)


def test_table_is_aligned_and_gives_reasons_below(lines):
    assert report.table(lines(*ROWS)) == [
        "verdict           member  quantity              ours  theirs  tolerance",
        "pass              B1      load_peak [kN]         200     190  ± 10 %",
        "FAIL              B1      load_peak [kN]         200     190  ± 0.0001 %",
        "                  off by 10 (5.3 %)",
        "not reproducible  B1      load_peak [kN]         200       1  ± 0.0001 %",
        "                  a misprint",
        "not reproducible  B1      camber_anchored [mm]     0       -",
        "                  a misprint",
    ]


def test_sheet(results, published):
    comparison = compare_workbooks(results(), published(*ROWS))
    assert comparison.path.name == "beams.results.comparison.xlsx"
    headers, *rows = load_workbook(comparison.path)["comparison"].iter_rows(values_only=True)
    assert headers == report.HEADERS
    assert rows[1][:6] == ("Second", "B1", "load_peak", 200, 190, "kN")
    assert rows[1][6] == pytest.approx(200 / 190)
    assert rows[1][7:10] == ("± 0.0001 %", "fail", "off by 10 (5.3 %)")
    assert rows[3][4:7] == ("none", "mm", "-")  # never a blank for what does not exist


def test_records_are_those_of_the_sheet(lines):
    records = report.records(lines(*ROWS))
    assert [record["verdict"] for record in records] == ["pass", "fail", *["not reproducible"] * 2]
    assert records[0]["ratio"] == 200 / 190 and records[3]["theirs"] == "none"


def test_markdown(tmp_path, results, published):
    path = tmp_path / "report.md"
    compare_workbooks(results(), published(*ROWS), markdown=path)
    assert path.read_text("utf-8").splitlines() == [
        "# Verification",
        "",
        "Written by `ptbatch compare beams.results.xlsx published.xlsx --markdown report.md`. 4 entries: "
        "1 pass, 1 fail, 2 not reproducible.",
        "The ratio is ours over theirs; of two tolerances the larger counts.",
        "",
        "## B1",
        "",
        "| row | quantity | ours | theirs | ratio | tolerance | verdict | class |",
        "| --: | --- | --: | --: | --: | --- | --- | --- |",
        "| 1 | load_peak [kN] | 200 | 190 | 1.0526 | ± 10 % | pass | frozen |",
        "",
        "- 1: Ours \\| theirs.",
        "- 1: from made up",
        "",
        "## Second",
        "",
        "| row | quantity | ours | theirs | ratio | tolerance | verdict | class |",
        "| --: | --- | --: | --: | --: | --- | --- | --- |",
        "| 1 | load_peak [kN] | 200 | 190 | 1.0526 | ± 0.0001 % | FAIL | frozen |",
        "| 2 | load_peak [kN] | 200 | 1 | 200.0000 | ± 0.0001 % | not reproducible | frozen |",
        "| 3 | camber_anchored [mm] | 0 | - | - |  | not reproducible | frozen |",
        "",
        "- 1: fail, because off by 10 (5.3 %)",
        "- 2-3: not reproducible, because a misprint",
        "- 1-3: from made up",
    ]
