"""A results workbook of one made-up member, and published tables about it."""

from pathlib import Path

import pytest
from openpyxl import Workbook

ROW = {"member": "B1", "quantity": "load_peak [kN]", "value": 200, "class": "frozen", "source": "made up"}


def write(path: Path, **sheets) -> Path:
    """Write sheets of rows by header."""
    book = Workbook()
    book.remove(book.active)
    for title, rows in sheets.items():
        page = book.create_sheet(title)
        headers = list(dict.fromkeys(header for row in rows for header in row))
        page.append(headers)
        for row in rows:
            page.append([row.get(header) for header in headers])
    book.save(path)
    return path


def summary(**values) -> dict:
    """A row of the summary."""
    row = {"member": "B1", "status": "ok", "message": None, "load_peak [kN]": 200.0, "failure": "bar rupture"}
    row |= {"loss_fixed_end_fe [%]": 4.0, "loss_fixed_end_analytic [%]": 5.0, "camber_anchored [mm]": 0.0}
    return row | {"newton_iterations": 99, "time [ms]": 12.5} | values


TENDON = [
    {
        "member": "B1",
        "stage": stage,
        "x [mm]": x,
        "stress_fe [MPa]": stress,
        "stress_analytic [MPa]": analytic,
    }
    for stage, x, stress, analytic in (
        ("jacked", 0, 1400.0, 1400.0),
        ("jacked", 1000, 1390.0, 1389.0),
        ("jacked", 2000, 1370.0, 1378.0),
        ("peak", 0, 1500.0, ""),
        ("peak", 2000, 1600.0, ""),
    )
]
CURVES = [
    {
        "member": "B1",
        "step": i,
        "load [kN]": load,
        "deflection [mm]": deflection,
        "event": "" if i else "peak",
    }
    for i, (load, deflection) in enumerate([(0, 0), (100, 10), (80, 9), (200, 30)])
]


@pytest.fixture
def results(tmp_path):
    """results(row of summary, ..., name=...) writes a results workbook and returns its path."""

    def make(*rows, name="beams.results.xlsx") -> Path:
        rows = rows or (summary(), summary(member="B2", **{"load_peak [kN]": "not converged: see message"}))
        return write(tmp_path / name, summary=rows, tendon=TENDON, curves=CURVES)

    return make


@pytest.fixture
def published(tmp_path):
    """published(row, ...) writes a table; what a row does not say is as in ROW."""

    def make(*rows, name="published.xlsx") -> Path:
        return write(tmp_path / name, published=[ROW | row for row in rows])

    return make


@pytest.fixture
def lines(results, published):
    """lines(row, ..., rtol=...) compares rows with the made-up results."""
    from ptbatch.compare.comparison import compare_workbooks

    def compare(*rows, rtol=1e-6):
        return compare_workbooks(results(), published(*rows), rtol=rtol).lines

    return compare
