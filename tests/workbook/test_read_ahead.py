"""The second process that reads a workbook: what it sends, when it starts, and that nothing depends on it."""

import sys
from datetime import date
from types import SimpleNamespace

import pytest
from openpyxl import Workbook, load_workbook

from ptbatch import cli
from ptbatch.errors import ReadError
from ptbatch.workbook import read_ahead
from ptbatch.workbook.read_ahead import ReadAhead, raw_sheets


@pytest.fixture
def large(monkeypatch):
    """Every workbook counts as large."""
    monkeypatch.setattr(read_ahead, "LARGE", 0)


@pytest.fixture
def path(tmp_path):
    book = Workbook()
    members = book.active
    members.title = "members"
    members.append(["member", "span [m]", "note", "dp [mm]"])
    members.append(["B1", 12, date(2026, 11, 29), "=1+1"])  # never calculated
    members.append(["B2", 1 / 3, True, None])
    book.create_sheet("Loads").append(["member", "case"])
    book.create_sheet("other").append(["nobody", "reads this"])
    book.save(tmp_path / "a.xlsx")
    return tmp_path / "a.xlsx"


@pytest.mark.usefixtures("large")
def test_it_sends_what_this_process_would_read(path, monkeypatch):
    expected = raw_sheets(path)
    monkeypatch.setattr(read_ahead, "raw_sheets", None)  # this process does not
    ahead = ReadAhead(path)
    assert ahead.under_way
    assert ahead.sheets() == expected
    assert set(expected) == {"members", "loads"}
    assert not ahead.under_way


@pytest.mark.usefixtures("large")
@pytest.mark.parametrize(
    "script",
    [
        "raise SystemExit(1)",
        "import pickle, sys; pickle.dump({'members': 1}, sys.stdout.buffer); raise SystemExit(1)",
        "import pickle, sys; sys.stdout.buffer.write(pickle.dumps({'members': 'x' * 99})[:-20])",
        "print('noise')",
        "",
    ],
)
def test_a_process_that_fails_is_not_needed(path, monkeypatch, script):
    popen = read_ahead.subprocess.Popen
    monkeypatch.setattr(
        read_ahead.subprocess, "Popen", lambda _, **rest: popen([sys.executable, "-c", script], **rest)
    )
    assert ReadAhead(path).sheets() == raw_sheets(path)


@pytest.mark.usefixtures("large")
def test_what_is_wrong_is_said_by_this_process(tmp_path):
    path = tmp_path / "a.xlsx"
    path.write_bytes(b"no workbook at all")
    ahead = ReadAhead(path)
    assert ahead.under_way
    with pytest.raises(ReadError, match=r"a\.xlsx: the file is not an Excel workbook"):
        ahead.sheets()


def test_a_small_workbook_is_not_worth_it(path):
    ahead = ReadAhead(path)
    assert not ahead.under_way
    assert ahead.sheets() == raw_sheets(path)


@pytest.mark.usefixtures("large")
def test_where_there_is_nothing_to_gain(path, tmp_path, monkeypatch):
    for name in ("a.csv", "a.parquet"):
        (tmp_path / name).write_bytes(b"member")
        assert not ReadAhead(tmp_path / name).under_way
    assert not ReadAhead(tmp_path / "missing.xlsx").under_way
    monkeypatch.setattr(read_ahead, "os", SimpleNamespace(cpu_count=lambda: 1))
    assert not ReadAhead(path).under_way


@pytest.mark.usefixtures("large")
def test_run_uses_it(path, monkeypatch, capsys):
    """The problems are those that `check` finds, whoever reads."""
    assert cli.exit_code(["check", str(path)]) == cli.INVALID_ROWS
    problems = capsys.readouterr().err.splitlines()[:-1]
    monkeypatch.setattr(read_ahead, "raw_sheets", None)
    assert cli.exit_code(["run", str(path), "--quiet"]) == cli.INVALID_ROWS
    told = load_workbook(path.with_name("a.results.xlsx"))["problems"]
    assert told.max_row - 1 == len(problems) > 2
