"""Workbooks made on the spot, and an engine that answers at once."""

import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest
from openpyxl import Workbook

BEAM = {
    "member": "B1",
    "span": 12000,
    "b": 300,
    "h": 600,
    "fc": 40,
    "Aps": 592,
    "dp": "300; 500; 300",
    "fpj": 1395,
}


@pytest.fixture(autouse=True)
def alone(monkeypatch):
    """No second process compiles beside the tests."""
    monkeypatch.setattr("ptbatch.runner.compile_ahead", lambda: None)


@pytest.fixture
def beam():
    """A sound row, by header."""
    return dict(BEAM)


@pytest.fixture
def book(tmp_path):
    """book(row, ..., rebar=[row, ...]) writes a workbook from rows by header and returns its path."""

    def make(*rows, name="beams.xlsx", **sheets) -> Path:
        workbook = Workbook()
        workbook.remove(workbook.active)
        for title, content in {"members": rows, **sheets}.items():
            page = workbook.create_sheet(title)
            headers = list(dict.fromkeys(header for row in content for header in row))
            page.append(headers)
            for row in content:
                page.append([row.get(header) for header in headers])
        path = tmp_path / name
        workbook.save(path)
        return path

    return make


@pytest.fixture
def engine(monkeypatch):
    """Stands in for the analysis: members named crash raise, those named stuck do not converge."""
    from ptbatch.workbook.results import CRACKS, CURVES, SUMMARY, TENDON

    def analyse(member):
        if member.member == "crash":
            raise ZeroDivisionError("of the fake")
        stuck = member.member == "stuck"
        return SimpleNamespace(
            status="not converged" if stuck else "ok", message="jacking: no equilibrium" if stuck else ""
        )

    def summary_row(member, response, found):
        value = "not reached: no equilibrium" if response.message else 1.25
        return {header: value for header in SUMMARY if header != "time [ms]"}

    fakes = {
        "analysis": {"analyse": analyse},
        "tables": {
            "summary_row": summary_row,
            "tendon_table": lambda *_: dict.fromkeys(TENDON, [1.0]) | {"stage": ["jacked"]},
            **{
                f"{name}_table": lambda *_: {}
                for name in ("check", "elongation", "loss", "moment", "reaction")
            },
            "crack_table": lambda *_: dict.fromkeys(CRACKS, [3.0]) | {"stage": ["peak"]},
            "curve_table": lambda *_: dict.fromkeys(CURVES, [2.0] * 2) | {"event": ["peak"] * 2},
        },
    }
    for name, content in fakes.items():
        module = ModuleType(f"ptbatch.{name}")
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, f"ptbatch.{name}", module)
