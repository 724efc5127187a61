"""`ptbatch doctor`: what is found, what is to be done, the exit code."""

from collections import namedtuple
from importlib.metadata import PackageNotFoundError
from pathlib import Path

import pytest

from ptbatch import doctor
from ptbatch.cli import exit_code


def test_a_sound_installation(capsys):
    assert exit_code(["doctor"]) == 0
    out, err = capsys.readouterr()
    assert out == ""
    assert "ok   numba" in err
    assert "friction loss 3.246 % and peak load 456.9 kN as known" in err
    assert err.endswith("ptbatch can work here\n")


def test_a_missing_package(monkeypatch, capsys):
    monkeypatch.setattr(doctor, "NEEDED", ("click", "no_such_package"))
    assert exit_code(["doctor"]) == 1
    err = capsys.readouterr().err
    assert "BAD  no_such_package     not installed" in err
    assert "-> pip install --upgrade --force-reinstall no_such_package" in err
    assert "self-test" not in err  # it could not be imported


def test_packages_that_do_not_fit(monkeypatch):
    def clash(name):
        raise ImportError("Numba needs NumPy 2.2 or less")

    monkeypatch.setattr(doctor, "import_module", clash)
    finding = doctor.needed_package("numba")
    assert (finding.state, finding.text) == ("fault", "cannot be imported: Numba needs NumPy 2.2 or less")


def test_an_optional_package_is_no_fault(monkeypatch):
    def absent(name):
        raise PackageNotFoundError(name)

    monkeypatch.setattr(doctor, "version", absent)
    finding = doctor.optional_package("pyarrow")
    assert (finding.state, finding.cure) == ("note", "pip install 'ptbatch[parquet]'")


@pytest.mark.parametrize(("free", "state"), [(2**20, "fault"), (2**30, "note"), (2**40, "ok")])
def test_disk(monkeypatch, tmp_path, free, state):
    usage = namedtuple("usage", "free")(free)
    monkeypatch.setattr(doctor.shutil, "disk_usage", lambda folder: usage)
    assert doctor.disk("here", tmp_path).state == state


def test_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("PTBATCH_CACHE", str(tmp_path / "mine"))
    assert doctor.cache_state().text.endswith("cold: the first run compiles for a minute or so")
    monkeypatch.setattr(doctor.cache, "cache_folder", lambda: Path("elsewhere"))
    assert doctor.cache_state().state == "note"
    assert "PTBATCH_CACHE" in doctor.cache_state().cure


def test_a_wrong_answer(monkeypatch):
    monkeypatch.setattr("ptbatch.tables.summary_row", lambda *_: {"loss_fixed_end_fe [%]": 4.0})
    finding = doctor.attempt("self-test", doctor.self_test, "report it")
    assert (finding.state, finding.cure) == ("fault", "report it")
    assert "loss_fixed_end_fe [%] is 4.0, not 3.246" in finding.text
