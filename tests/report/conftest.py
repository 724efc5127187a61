"""Results of members of all kinds, some with names that mean mischief, and the report on them."""

import pytest
from openpyxl import Workbook

from ptbatch import analysis, stages
from ptbatch.batch import run_workbook
from ptbatch.core.ramp import NO_EQUILIBRIUM
from ptbatch.report import write_report
from ptbatch.workbook.stored import read_all
from tests.plots.conftest import ROWS, SMALL

SCRIPT, LONG = "<script>alert(1)</script>", "long" * 30
HOSTILE = '"></p><img src=x onerror=alert(2)>'
MORE = [
    SMALL | {"member": SCRIPT, "note": HOSTILE},
    SMALL | {"member": "=1+1", "jack": "right", "w_live": 10},
    SMALL | {"member": LONG, "live": "loads", "dp [mm]": None},
    SMALL | {"member": "mean", "fpj [MPa]": None, "fpe": 1100, "set": 0, "jack": "both"},
    SMALL | {"member": "frictionless", "mu": 0, "K": 0},
    SMALL | {"member": "too heavy", "w_dead": 75},
    SMALL | {"member": "wrong", "fc [MPa]": "<b>12,5</b>", "Aps [mm2]": -1},
]
SHEETS = {
    "profile": [{"member": LONG, "x": x, "dp": dp} for x, dp in ((0, 250), (2500, 400), (6000, 250))],
    "loads": [
        {"member": LONG, "case": "live", "type": "point", "x": 2000, "value": 60},
        {"member": LONG, "case": "dead", "type": "uniform", "x": 1000, "x_end": 5000, "value": 4},
    ],
    "rebar": [{"member": LONG, "x_start": 1000, "x_end": 5000, "depth": 450, "area": 200}],
}


def sheet(book, name, rows):
    """Add a sheet of rows by header; texts as texts."""
    page = book.create_sheet(name)
    headers = list(dict.fromkeys(header for row in rows for header in row))
    page.append(headers)
    for row in rows:
        page.append([row.get(header) for header in headers])
    for line in page.iter_rows():
        for cell in line:
            if isinstance(cell.value, str):
                cell.data_type = "s"


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """The results workbook; the member `stuck` finds no equilibrium under live load."""
    path = tmp_path_factory.mktemp("report") / "beams.xlsx"
    book = Workbook()
    book.remove(book.active)
    for name, rows in {"members": ROWS + MORE, **SHEETS}.items():
        sheet(book, name, rows)
    book.save(path)
    serve = analysis.serve

    def stuck(run, refine, loss):
        if run.setup.member.member == "stuck":
            raise stages.NoEquilibriumError(stages.LIVE, NO_EQUILIBRIUM, 0.25)
        return serve(run, refine, loss)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(analysis, "serve", stuck)
        return run_workbook(path, jobs=2).path


@pytest.fixture(scope="session")
def stored(results):
    """Results by member."""
    return {result.name: result for result in read_all(results)}


@pytest.fixture(scope="session")
def reported(results):
    """The report on all of them."""
    return write_report(results)


@pytest.fixture(scope="session")
def page(reported):
    """Its text."""
    return reported.path.read_text("utf-8")
