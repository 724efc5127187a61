"""The same digits come out for any number of members at a time, and where a run was gone on with."""

from threading import Event

import pytest
from openpyxl import load_workbook

from ptbatch.batch import run_workbook


@pytest.fixture
def light(book, beam):
    """Light members of several kinds."""
    beam |= {"elements": 4, "layers": 8, "As": 400, "ds": 550}
    kinds = {}, {"bond": "bonded"}, {"profile": "harped"}, {"jack": "both", "mu": 0.15}, {"h": 700, "fc": 30}
    spans = {"span": "12000; 9000", "dp": "300; 500; 90; 450; 300"}
    return book(*(beam | kind | {"member": f"B{i}"} for i, kind in enumerate((*kinds, spans))))


def values(path) -> dict:
    book = load_workbook(path)
    sheets = {name: list(book[name].values) for name in book.sheetnames if name != "run"}
    place = sheets["summary"][0].index("time [ms]")
    sheets["summary"] = [row[:place] + row[place + 1 :] for row in sheets["summary"]]
    return sheets


def test_jobs_do_not_change_a_digit(light, tmp_path):
    one, *others = (values(run_workbook(light, tmp_path / f"{n}.xlsx", n).path) for n in (1, 2, 4))
    assert {row[1] for row in one["summary"][1:]} == {"ok"}
    assert others == [one, one]


def test_going_on_does_not_change_a_digit(light, tmp_path):
    whole = run_workbook(light, tmp_path / "whole.xlsx").path
    path, stop = tmp_path / "part.xlsx", Event()
    first = run_workbook(light, path, progress=lambda done, total, name: stop.set(), stop=stop)
    assert first.interrupted
    second = run_workbook(light, path, resume=True)
    assert 0 < second.known < 6
    assert second.known == first.counts["ok"]
    assert values(path) == values(whole)
