"""The command line: exit codes, what goes to stdout and stderr, and how fast help is."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from openpyxl import load_workbook

from ptbatch.cli import exit_code
from ptbatch.workbook.results import SUMMARY


def summary(path) -> list[tuple]:
    return list(load_workbook(path)["summary"].iter_rows(min_row=2, values_only=True))


def test_all_rows_pass(book, beam, engine, capsys):
    path = book(beam, beam | {"member": "B2"})
    assert exit_code(["run", str(path)]) == 0
    out, err = capsys.readouterr()
    assert out == ""
    assert "B1      ok" in err
    assert f"2 ok; results: {path.with_name('beams.results.xlsx')}" in err
    assert "\r" not in err  # progress is for terminals


@pytest.mark.parametrize("bad", [{"member": "stuck"}, {"member": "crash"}, {"fc": "x"}])
def test_some_rows_fail(book, beam, engine, bad):
    path = book(beam | {"member": "good"}, beam | bad)
    assert exit_code(["run", str(path)]) == 3
    assert [row[1] for row in summary(path.with_name("beams.results.xlsx"))][0] == "ok"


def test_a_row_that_fails_before_its_live_load_has_no_peak_to_tell(book, beam, capsys):
    assert exit_code(["run", str(book(beam | {"w_dead": 400, "elements": 8, "layers": 10}))]) == 0
    told = capsys.readouterr().err
    assert "B1      warning          -  concrete crushing at x = " in told
    assert "under the sustained load: no live load can be carried\n1 warning; results:" in told


def test_a_crash_stays_in_its_row(book, beam, engine):
    path = book(beam | {"member": "crash"}, beam)
    exit_code(["run", str(path)])
    crashed, good = summary(path.with_name("beams.results.xlsx"))
    assert crashed[1:4] == (
        "not converged",
        "internal error: ZeroDivisionError: of the fake; please report it, with this row",
        "not analysed: internal error",
    )
    assert good[1] == "ok"


def test_nothing_to_read_or_write(tmp_path, book, beam, engine, capsys):
    assert exit_code(["run", str(tmp_path / "none.xlsx")]) == 4
    assert exit_code(["run", str(book(beam)), "-o", str(tmp_path / "none" / "a.xlsx")]) == 4
    assert exit_code(["check", __file__]) == 4
    assert "not an Excel workbook" in capsys.readouterr().err


def test_a_read_only_folder_is_told_before_the_work(book, beam, engine, monkeypatch, capsys):
    """Whoever runs the tests may be allowed everything, so that the system's answer is given here."""
    source = book(beam)
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK)
    assert exit_code(["run", str(source)]) == 4
    assert "the folder is read-only; give another one with -o" in capsys.readouterr().err
    assert sorted(path.name for path in source.parent.iterdir()) == ["beams.xlsx"]


@pytest.mark.parametrize("args", [["run"], ["fly"], ["run", "a.xlsx", "--jobs", "0"], ["run", "--rtol", "1"]])
def test_usage(args, capsys):
    assert exit_code(args) == 2
    assert capsys.readouterr().err


def test_internal_error(book, beam, engine, monkeypatch, capsys):
    monkeypatch.setattr("ptbatch.batch.Output.finish", lambda *_: 1 / 0)
    assert exit_code(["run", str(book(beam))]) == 70
    assert "Internal error, please report it: ZeroDivisionError" in capsys.readouterr().err


def test_only(book, beam, engine, capsys):
    rows = [beam | {"member": name} for name in ("B1", "B2", "B3")]
    path = book(*rows, beam | {"member": "B4", "fc": "x"})
    assert (
        exit_code(["run", str(path), "--only", "B3", "--only", "B1", "-o", str(path.with_name("o.xlsx"))])
        == 0
    )
    assert [row[0] for row in summary(path.with_name("o.xlsx"))] == ["B1", "B3"]
    assert exit_code(["run", str(path), "--only", "b1 "]) == 2
    assert "did you mean B1?" in capsys.readouterr().err


def test_json(book, beam, engine, capsys):
    path = book(beam | {"note": "x"}, beam | {"member": "B2", "b": "?"})
    assert exit_code(["run", str(path), "--json"]) == 3
    records = json.loads(capsys.readouterr().out)
    assert [record["status"] for record in records] == ["ok", "invalid"]
    assert list(records[0]) == ["member", "status", "message", *SUMMARY, "note"]
    assert isinstance(records[0]["load_peak [kN]"], float)


@pytest.mark.parametrize("jobs", ["1", "2", "7"])
def test_jobs_do_not_change_the_order(book, beam, engine, jobs):
    names = [f"B{i}" for i in range(20)]
    path = book(*(beam | {"member": name} for name in names))
    assert exit_code(["run", str(path), "--jobs", jobs]) == 0
    assert [row[0] for row in summary(path.with_name("beams.results.xlsx"))] == names


def test_long_closing_table_shows_what_failed(book, beam, engine, capsys):
    path = book(*(beam | {"member": f"B{i}"} for i in range(60)), beam | {"member": "stuck"})
    assert exit_code(["run", str(path)]) == 3
    err = capsys.readouterr().err
    assert "stuck" in err
    assert "... and 21 more rows" in err


def test_file_in_use(book, beam, engine, monkeypatch, capsys):
    path = book(beam)
    monkeypatch.setattr("ptbatch.workbook.write._move", lambda temporary, path: path.with_name("other.xlsx"))
    assert exit_code(["run", str(path)]) == 0
    err = capsys.readouterr().err
    assert "beams.results.xlsx is in use and could not be replaced" in err
    assert "other.xlsx" in err


def test_progress_on_a_terminal(book, beam, engine, monkeypatch, capsys):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    exit_code(["run", str(book(beam, beam | {"member": "B2"})), "--jobs", "1"])
    err = capsys.readouterr().err
    assert "2 of 2  " in err
    assert "all done  B2\n" in err


@pytest.mark.parametrize("terminal", [True, False])
def test_compiling_is_said(book, beam, engine, monkeypatch, tmp_path, capsys, terminal):
    monkeypatch.setattr("sys.stderr.isatty", lambda: terminal)
    monkeypatch.setenv("PTBATCH_CACHE", str(tmp_path / "empty"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    exit_code(["run", str(book(beam))])
    assert capsys.readouterr().err.startswith("compiling (first run only)" + "\n" * (not terminal))


def test_check(book, beam, capsys):
    assert exit_code(["check", str(book(beam))]) == 0
    assert exit_code(["check", str(book(beam | {"fc": "12,5", "mark": 1}))]) == 3
    out, err = capsys.readouterr()
    assert out == ""
    assert "members!E2  fc = 12,5: a comma is not clear; use a point for decimals" in err
    assert "members!I1  mark" in err
    assert "1 rows: 0 valid, 1 invalid" in err


def test_template(tmp_path):
    path = tmp_path / "new.xlsx"
    assert exit_code(["template", str(path), "--units", "us"]) == 0
    assert exit_code(["check", str(path)]) == 0
    assert exit_code(["template", str(path)]) == 4  # it is there already


def test_help_names_the_exit_codes(capsys):
    for args in (["--help"], ["run", "-h"], ["check", "--help"], ["plot", "-h"]):
        assert exit_code(args) == 0
        out = capsys.readouterr().out
        assert all(f"\n    {code} " in out for code in (0, 1, 2, 3, 4, 70))
    assert exit_code(["--version"]) == 0


@pytest.mark.parametrize("code", ["import ptbatch", "from ptbatch.cli import exit_code; exit_code(['-h'])"])
def test_help_is_light(code):
    check = "import sys; print([m for m in ('numba', 'numpy', 'matplotlib', 'openpyxl') if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", f"{code}; {check}"],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path(__file__).parent.parent,
    )
    assert done.stdout.splitlines()[-1] == "[]"


@pytest.mark.parametrize(
    "args",
    [["check"], ["template", "new.xlsx"], ["plot", "--geometry", "--member", "B1"]],
    ids=lambda a: a[0],
)
def test_what_does_not_analyse_does_not_compile(args, book, beam, tmp_path):
    path = [] if args[0] == "template" else [str(book(beam))]
    code = f"import sys; from ptbatch.cli import exit_code; code = exit_code({args + path}); "
    code += "print(code, [m for m in ('numba', 'llvmlite', 'pandas') if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(Path(__file__).parent.parent)},
    )
    assert done.stdout.splitlines()[-1] == "0 []"


def test_public_names():
    import ptbatch

    assert ptbatch.Member.__name__ == "Member"
    assert issubclass(ptbatch.MemberError, ValueError)
    assert "analyse" in dir(ptbatch)
    with pytest.raises(AttributeError):
        _ = ptbatch.analyze
