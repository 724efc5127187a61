"""Members echoed in the results are the members that were analysed."""

import pytest
from openpyxl import load_workbook

from examples.build import EXAMPLE, ROOT
from ptbatch.batch import run_workbook
from ptbatch.workbook.echo import echo
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.write import write_workbook


def members(path) -> list:
    return [row.member for row in read_inputs(path).rows if row.member is not None]


def test_every_example_comes_back_to_the_last_digit(tmp_path):
    """Among them lists, US units, wobble as an angle and every default."""
    original = members(ROOT / EXAMPLE)
    path = write_workbook(tmp_path / "echo.xlsx", echo(original))
    assert read_inputs(path).all_problems() == []
    assert members(path) == original


def test_optional_sheets_come_back(tmp_path, book, beam):
    profile = [
        {"member": "B1", "x [ft]": x, "dp [in]": d} for x, d in ((0, 12), (15, 20.1), (39.3700787401575, 12))
    ]
    rebar = [{"member": "B1", "x_end [m]": 6, "depth": 550, "area": 400}]
    loads = [
        {"member": "B1", "case": "live", "type": "point", "x": 4000, "value": 1 / 3},
        {"member": "B1", "case": "dead", "type": "uniform", "x": 1000, "value": -0.7},
    ]
    del beam["dp"]
    rows = (
        beam | {"live": "loads", "density": 23.6, "K": 0.0021},
        beam | {"member": "001", "dp": "300;500;300"},
    )
    original = members(book(*rows, profile=profile, rebar=rebar, loads=loads))
    path = write_workbook(tmp_path / "echo.xlsx", echo(original))
    assert load_workbook(path).sheetnames == ["members", "profile", "rebar", "loads"]
    assert members(path) == original


def test_invalid_rows_are_not_echoed(book, beam, engine):
    source = book(beam | {"fc": "x"}, beam | {"member": "B2"})
    path = run_workbook(source).path
    assert [member.member for member in members(path)] == ["B2"]
    assert members(path)[0] == members(source)[0]


@pytest.mark.parametrize("shape", ["rectangle", "box"])
def test_results_can_be_run_again(book, beam, engine, shape):
    sizes = {"shape": shape} | ({"bw": 100, "hf": 80} if shape == "box" else {})
    first = run_workbook(book(beam | sizes)).path
    again = run_workbook(first)
    assert again.counts["ok"] == 1
    assert members(again.path) == members(first)
