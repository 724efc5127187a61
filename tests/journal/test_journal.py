"""The journal: outcomes to the last digit, and keys that change with whatever an outcome depends on."""

import numpy as np
import pytest

from ptbatch.journal import key as keys
from ptbatch.journal.content import decode, encode
from ptbatch.journal.journal import Journal
from ptbatch.journal.key import member_key
from ptbatch.member import Member
from ptbatch.runner import STOPPED, not_analysed
from ptbatch.workbook.results import DETAILS, SUMMARY, Outcome

NUMBERS = [0.1, 1 / 3, -0.0, 1e-300, float("inf"), 12345678.901234567, 7, "no crack", ""]


def outcome(value=1.5) -> Outcome:
    tables = {name: dict.fromkeys(headers[1:], [value] * 2) for name, headers in DETAILS.items()}
    return Outcome("ok", "a message", dict.fromkeys(SUMMARY, value), **tables)


def member(**changes) -> Member:
    values = {"member": "B1", "span": 12000, "b": 300, "h": 600, "fc": 40, "Aps": 592, "dp": (300, 500, 300)}
    return Member(**values | {"fpj": 1395} | changes)


@pytest.mark.parametrize("value", NUMBERS)
def test_outcomes_come_back_to_the_last_digit(value):
    again = decode(encode(outcome(value)))
    assert again == outcome(value)
    assert repr(again.summary) == repr(outcome(value).summary)


def test_columns_of_every_kind_come_back():
    """Numbers alone, numbers among texts, whole ones, none; NaN too, which differs from itself."""
    columns = [
        [0.1, -0.0, float("nan"), float("inf")],
        [0.5, "none", 2, ""],
        [1, 2, 3, 4],
        [0.2] * 4,
        [True] * 4,
    ]
    curves = dict(zip(DETAILS["curves"][1:], [*columns, *columns], strict=False))
    tables = {"curves": curves, "cracks": {header: [] for header in DETAILS["cracks"][1:]}, "tendon": {}}
    given = Outcome("ok", "", dict.fromkeys(SUMMARY, 1.0), **tables)
    assert repr(decode(encode(given))) == repr(given)


def test_numbers_of_numpy():
    again = decode(encode(outcome(np.float64(1 / 3))))
    assert again.summary["load_peak [kN]"] == 1 / 3
    assert type(decode(encode(outcome(np.int64(7)))).curves["step"][0]) is int


@pytest.mark.parametrize(
    "change", [{"fc": 40.000000000000007}, {"member": "B2"}, {"mu": 0.2}, {"As": (5.0,), "ds": (500,)}]
)
def test_a_changed_value_changes_the_key(change):
    assert member_key(member()) == member_key(member(fc=40.0, span=(12000.0,)))
    assert member_key(member(**change)) != member_key(member())


def test_a_changed_program_changes_the_key(monkeypatch):
    before = member_key(member())
    monkeypatch.setattr(keys, "_program", lambda: b"another")
    assert member_key(member()) != before


def test_an_earlier_run_is_known_only_if_asked_for(tmp_path):
    path = tmp_path / "j"
    with Journal(path, resume=False) as journal:
        journal.add(member(), outcome())
        assert journal.key(member()) is None
    with Journal(path, resume=True) as journal:
        assert journal.key(member(fc=41)) is None
        assert journal.read(journal.key(member())) == outcome()
        assert journal.used == 1
        journal.remove()
    assert list(tmp_path.iterdir()) == []


def test_what_is_no_result_is_not_kept(tmp_path):
    with Journal(tmp_path / "j", resume=True) as journal:
        journal.add(member(), not_analysed(STOPPED))
        journal.add(member(), not_analysed("not analysed: internal error", "not converged", "internal error"))
        assert journal.key(member()) is None
    assert list(tmp_path.iterdir()) == []
