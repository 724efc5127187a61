"""Runs that end early: killed, interrupted once or twice, and gone on with."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic, sleep

import pytest
from openpyxl import load_workbook

from ptbatch.cli import exit_code
from ptbatch.workbook.results import SUMMARY

ROOT = Path(__file__).parent.parent
ROWS = 200
TIME = 3 + SUMMARY.index("time [ms]")

posix = pytest.mark.skipif(sys.platform == "win32", reason="needs signals of POSIX")


@pytest.fixture
def source(book, beam):
    rows = [beam | {"member": f"B{i}", "fc": 30 + i / 7} for i in range(ROWS)]
    rows[5]["fc"] = "x"
    return book(*rows)


@pytest.fixture
def slow(source, tmp_path):
    """slow(*args) starts a run of the workbook; its log names the members that were analysed."""
    log, started = tmp_path / "log", []

    def start(*args):
        log.write_text("")
        command = [sys.executable, str(ROOT / "tests" / "slow.py"), str(log), "run", str(source), *args]
        environment = os.environ | {"PYTHONPATH": str(ROOT)}
        run = subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=environment)
        started.append(run)
        return run, log

    yield start
    for run in started:
        run.kill()


def wait_for(log, rows) -> list[str]:
    """Members in the log, once there are so many."""
    end = monotonic() + 60
    while len(names := log.read_text().split()) < rows:
        assert monotonic() < end
        sleep(0.01)
    return names


def sheets(path) -> dict:
    """Values of all sheets but `run`, and but the times."""
    book = load_workbook(path)
    values = {name: [list(row) for row in book[name].values] for name in book.sheetnames if name != "run"}
    for line in values["summary"]:
        del line[TIME]
    return values


def journal(source) -> Path:
    return source.with_name(".beams.results.xlsx.journal")


@posix
@pytest.mark.parametrize("torn", [0, 30])
def test_killed_and_resumed(source, slow, torn):
    whole, _ = slow("-o", str(source.with_name("whole.xlsx")))
    assert whole.wait(60) == 3  # one row is invalid
    run, log = slow("--jobs", "2")
    wait_for(log, 60)
    run.send_signal(signal.SIGKILL)
    run.wait(60)
    assert not source.with_name("beams.results.xlsx").exists()
    with journal(source).open("r+b") as file:
        file.truncate(file.seek(0, 2) - torn)
    resumed, log = slow("--resume", "--jobs", "3")
    assert resumed.wait(60) == 3
    analysed = log.read_text().split()
    assert 0 < len(analysed) <= ROWS - 1 - 60 + 64 + bool(torn)  # what was in flight is analysed again
    assert "B0" not in analysed
    results = source.with_name("beams.results.xlsx")
    assert sheets(results) == sheets(source.with_name("whole.xlsx"))
    assert not journal(source).exists()
    run = dict(load_workbook(results)["run"].values)
    assert run["rows from the journal"] == ROWS - 1 - len(analysed)


@posix
def test_interrupted_once(source, slow):
    run, log = slow("--jobs", "2")
    wait_for(log, 40)
    run.send_signal(signal.SIGINT)
    assert run.wait(60) == 130
    told = run.stderr.read()
    assert "finishing the rows in flight" in told
    assert "--resume analyses the rows that are missing" in told
    analysed = log.read_text().split()
    assert 40 <= len(analysed) < ROWS - 1
    summary = sheets(source.with_name("beams.results.xlsx"))["summary"][1:]
    assert [row[0] for row in summary] == [f"B{i}" for i in range(ROWS)]
    assert [row[0] for row in summary if row[1] == "ok"] == analysed_in_order(analysed)
    assert summary[5][1] == "invalid"
    assert summary[-1][1:4] == ["not analysed", *["not analysed: interrupted"] * 2]
    assert journal(source).exists()

    resumed, log = slow("--resume")
    assert resumed.wait(60) == 3
    assert not set(analysed) & set(log.read_text().split())
    assert {row[1] for row in sheets(source.with_name("beams.results.xlsx"))["summary"][1:]} == {
        *("ok", "invalid")
    }
    assert not journal(source).exists()


def analysed_in_order(names) -> list[str]:
    return sorted(names, key=lambda name: int(name[1:]))


@posix
def test_interrupted_twice(source, slow):
    run, log = slow("--jobs", "2")
    wait_for(log, 30)
    run.send_signal(signal.SIGINT)
    assert any("again stops" in line for line in iter(run.stderr.readline, ""))
    run.send_signal(signal.SIGINT)
    assert run.wait(5) == 130
    left = sorted(path.name for path in source.parent.iterdir())
    assert left in (
        [".beams.results.xlsx.journal", "beams.xlsx", "log"],
        [".beams.results.xlsx.journal", "beams.results.xlsx", "beams.xlsx", "log"],  # it was fast enough
    )


def test_interrupted_before_the_first_row(book, beam, engine, monkeypatch):
    from threading import Event

    from ptbatch.batch import run_workbook

    path, stop = book(beam), Event()
    stop.set()
    with pytest.raises(KeyboardInterrupt):
        run_workbook(path, stop=stop)
    assert list(path.parent.iterdir()) == [path]


def test_a_changed_row_is_analysed_again(book, beam, engine, monkeypatch):
    path = book(beam, beam | {"member": "crash"}, beam | {"member": "B3"})
    monkeypatch.setattr("ptbatch.batch.Output.finish", lambda *_: 1 / 0)
    assert exit_code(["run", str(path)]) == 70
    monkeypatch.undo()
    assert journal(path).exists()
    book(beam | {"note": "new"}, beam | {"member": "crash"}, beam | {"member": "B3", "fc": 41})
    calls = []
    monkeypatch.setattr(
        "ptbatch.runner.engine", lambda: lambda member: calls.append(member.member) or fake_outcome()
    )
    assert exit_code(["run", str(path), "--resume"]) == 0
    assert calls == ["crash", "B3"]


def fake_outcome():
    from ptbatch.workbook.results import Outcome

    return Outcome("ok", "", dict.fromkeys(SUMMARY, 1.0))


def test_what_is_said_about_the_journal(book, beam, engine, capsys):
    path = book(beam)
    assert exit_code(["run", str(path), "--resume"]) == 0
    assert "there is no journal" in capsys.readouterr().err
    journal(path).touch()
    assert exit_code(["run", str(path)]) == 0
    assert "--resume would go on from it" in capsys.readouterr().err
