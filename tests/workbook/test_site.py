"""The sheet that a site fills in."""

import pytest
from openpyxl import load_workbook

from ptbatch.batch import run_workbook
from tests.workbook.hostile.sown import LIGHT


@pytest.fixture
def results(book):
    """Results of a member with two live ends and one with one, in mm and in inches."""
    rows = [LIGHT | {"member": "two", "jack": "both"}, LIGHT | {"member": "one", "jack": "right"}]
    source = book(*rows)
    return [run_workbook(source, source.with_name(f"{s}.xlsx"), units=s).path for s in ("SI", "US")]


def lines(path) -> list[dict]:
    headers, *rows = load_workbook(path)["elongation"].iter_rows(values_only=True)
    return [dict(zip(headers, row, strict=True)) for row in rows]


def test_a_row_for_each_live_end(results):
    rows = lines(results[0])
    assert [(row["member"], row["end"]) for row in rows] == [
        ("two", "left"),
        ("two", "right"),
        ("one", "right"),
    ]
    summary = list(load_workbook(results[0])["summary"].iter_rows(values_only=True))
    at = summary[0].index("elongation_after_set [mm]")
    two, one = summary[1][at], summary[2][at]
    assert rows[0]["after_set [mm]"] + rows[1]["after_set [mm]"] == pytest.approx(two, rel=1e-12)
    assert rows[2]["after_set [mm]"] == pytest.approx(one, rel=1e-12)
    assert rows[2]["most [mm]"] == pytest.approx(1.07 * one)
    assert rows[0]["jack_force [kN]"] == pytest.approx(1300 * 0.3)


def test_formulas_judge_what_is_filled_in(results):
    row = lines(results[0])[1]
    assert row["gauge"] is row["measured [mm]"] is None
    assert row["deviation [%]"] == '=IF(K3="","",100*(K3/E3-1))'
    assert row["verdict"] == '=IF(K3="","",IF(AND(K3>=F3,K3<=G3),"OK","NG"))'
    stored = load_workbook(results[0], data_only=True)["elongation"]
    assert stored["M3"].value in (None, "")


def test_in_inches(results):
    si, us = (lines(path)[0] for path in results)
    assert us["after_set [in]"] * 25.4 == pytest.approx(si["after_set [mm]"], rel=1e-12)
    assert us["to_read"] == si["to_read"]
    assert "measured [in]" in us
