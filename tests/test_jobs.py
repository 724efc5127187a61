"""The same digits come out for any number of members at a time, and where a run was gone on with."""

import sys
from dataclasses import asdict
from threading import Event

import pytest
from openpyxl import load_workbook

from benchmarks.population import population
from ptbatch.batch import run_workbook
from ptbatch.member import Member
from ptbatch.runner import on_threads


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


def test_threads_share_nothing():
    members = [Member(**asdict(member) | {"elements": 6, "layers": 8}) for member in population(60, seed=7)]
    twice = [member for member in members for _ in range(2)]  # one object in two threads, its caches too
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-4)
    try:
        threads = list(map(digits, on_threads(4)(twice)))
    finally:
        sys.setswitchinterval(interval)
    serial = list(map(digits, on_threads(1)(members)))
    assert threads == [outcome for outcome in serial for _ in range(2)]


def digits(outcome) -> dict:
    """All of an outcome but the time."""
    return vars(outcome) | {"summary": dict(outcome.summary) | {"time [ms]": 0.0}}


def test_going_on_does_not_change_a_digit(light, tmp_path):
    whole = run_workbook(light, tmp_path / "whole.xlsx").path
    path, stop = tmp_path / "part.xlsx", Event()
    first = run_workbook(light, path, progress=lambda done, total, name: stop.set(), stop=stop)
    assert first.interrupted
    second = run_workbook(light, path, resume=True)
    assert 0 < second.known < 6
    assert second.known == first.counts["ok"]
    assert values(path) == values(whole)
