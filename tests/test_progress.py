"""What is said while rows are done."""

from itertools import count

import pytest

from ptbatch.cli import exit_code
from ptbatch.progress import CLEAR, Meter, duration, row_line
from ptbatch.workbook.results import SUMMARY


def line(member, status="ok", message="", time=12.3):
    return [member, status, message, *(time if header == "time [ms]" else 0.0 for header in SUMMARY)]


def said(terminal, verbose=False, rows=4) -> str:
    """All that a meter writes when a row takes two seconds."""
    texts, seconds = [], count(step=2)
    meter = Meter(texts.append, terminal, verbose, lambda: next(seconds))
    for done in range(1, rows + 1):
        meter(done, rows, line(f"B{done}"))
    return "".join(texts)


def test_rows_pace_and_time_left():
    states = said(terminal=True).split(CLEAR)
    assert states[1:] == [
        "1 of 4  0.5/s  6 s left  B1",
        "2 of 4  0.5/s  4 s left  B2",
        "3 of 4  0.5/s  2 s left  B3",
        "4 of 4  0.5/s  all done  B4\n",
    ]


def test_a_line_of_each_row():
    assert said(terminal=False, verbose=True, rows=2) == "1 of 2  B1  ok  12 ms\n2 of 2  B2  ok  12 ms\n"
    assert said(terminal=True, verbose=True).count("\n") == 5


def test_a_row_that_was_not_analysed():
    assert row_line(3, 9, line("B\x1b[2J", "invalid", "fc: 12\n5", "invalid input")) == (
        "3 of 9  B [2J  invalid  fc: 12 5"
    )


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0.4, "0 s"), (59.4, "59 s"), (59.6, "1:00 min"), (200, "3:20 min"), (7500, "2:05 h")],
)
def test_duration(seconds, text):
    assert duration(seconds) == text


def test_quiet_and_verbose(book, beam, engine, capsys):
    path = str(book(beam | {"member": "stuck"}, beam))
    assert exit_code(["run", path, "--quiet"]) == 3
    assert capsys.readouterr() == ("", "")
    assert exit_code(["run", path, "-v"]) == 3
    assert "1 of 2  stuck  not converged" in capsys.readouterr().err
    assert exit_code(["run", path, "-q", "-v"]) == 2
