"""Rows meet their outcomes in order, and nothing piles up on the way."""

from threading import Event
from types import SimpleNamespace

import pytest

from ptbatch import pairing
from ptbatch.pairing import Pairing
from ptbatch.runner import on_threads
from ptbatch.workbook.results import Outcome


class NoJournal:
    """Knows the members whose number is in `known`."""

    def __init__(self, known=()):
        self.known, self.added = set(known), []

    def key(self, member):
        return member.number if member.number in self.known else None

    def read(self, key):
        return outcome(f"known {key}")

    def add(self, member, outcome):
        self.added.append(member.number)


def outcome(message):
    return Outcome("ok", message, {})


def row(number, valid=True):
    return SimpleNamespace(number=number, member=SimpleNamespace(number=number) if valid else None)


def one_by_one(members):
    return (outcome(f"done {member.number}") for member in members)


def all_ahead(members):
    return one_by_one(list(members))


def pairs(rows, outcomes, journal=None, stop=None):
    return Pairing(rows, outcomes, journal or NoJournal(), stop or Event())


def told(rows, outcomes, known=()):
    return [(row.number, out and out.message) for row, out in pairs(rows, outcomes, NoJournal(known))]


@pytest.mark.parametrize("outcomes", [one_by_one, all_ahead])
@pytest.mark.parametrize("most", [1, 2, 1000])
def test_every_row_has_its_outcome(monkeypatch, outcomes, most):
    monkeypatch.setattr(pairing, "MOST_SETTLED", most)
    invalid, known = {0, 1, 5, 19}, {2, 3, 4, 7, 18}
    rows = [row(i, i not in invalid) for i in range(20)]
    expected = [(i, None if i in invalid else f"known {i}" if i in known else f"done {i}") for i in range(20)]
    assert told(rows, outcomes, known) == expected


@pytest.mark.parametrize("rows", [[], [row(0, False)], [row(0)]])
def test_few_rows(rows):
    assert [n for n, _ in told(rows, all_ahead)] == [r.number for r in rows]


def test_known_rows_do_not_pile_up(monkeypatch):
    monkeypatch.setattr(pairing, "MOST_SETTLED", 10)
    read = []
    rows = (read.append(i) or row(i) for i in range(1000))
    for found, _ in pairs(rows, one_by_one, NoJournal(range(1000))):
        assert len(read) <= found.number + 10


def test_threads_take_few_rows_in_advance(monkeypatch):
    monkeypatch.setattr("ptbatch.runner.engine", lambda: lambda member: outcome(""))
    read = []
    rows = (read.append(i) or row(i) for i in range(2000))
    for found, _ in pairs(rows, on_threads(2)):
        assert len(read) <= found.number + 2 + 2 * 32


def test_after_a_stop_rows_are_told_not_to_be_analysed(monkeypatch):
    stop, journal = Event(), NoJournal({12})
    out = []
    for found, result in pairs([row(i, i != 15) for i in range(20)], one_by_one, journal, stop):
        out.append(result and result.message)
        if found.number == 9:
            stop.set()
    assert out[:10] == [f"done {i}" for i in range(10)]
    assert out[12] == "known 12"
    assert out[15] is None
    assert {out[i] for i in (11, 13, 14, 16, 19)} == {"not analysed: interrupted"}
