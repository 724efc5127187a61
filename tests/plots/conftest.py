"""One results workbook for all tests of figures: simple, bonded in US units, two spans, and two that fail."""

import pytest
from openpyxl import Workbook

from ptbatch import analysis, stages
from ptbatch.batch import run_workbook
from ptbatch.core.ramp import NO_EQUILIBRIUM
from ptbatch.workbook.stored import read_stored

SMALL = {
    **{"span [mm]": 6000, "b [mm]": 300, "h [mm]": 500, "fc [MPa]": 35, "Aps [mm2]": 400, "set": 2},
    **{"dp [mm]": "250; 400; 250", "fpj [MPa]": 1200, "As [mm2]": "300; 200", "ds [mm]": "450; 420"},
    **{"elements": 6, "layers": 12},
}
ROWS = [
    SMALL | {"member": "simple", "live": "third-points", "P_live": 100},
    {
        **{"member": "US tee", "span [ft]": 20, "b [in]": 24, "h [in]": 20, "shape": "tee", "bw [in]": 10},
        **{"hf [in]": 4, "fc [ksi]": 5, "Aps [in2]": 0.6, "dp [in]": "8; 16; 8", "fpj [ksi]": 190},
        **{"bond": "bonded", "w_live [kip/ft]": 1, "elements": 6, "layers": 12, "deflection_limit": 40},
    },
    SMALL
    | {
        **{"member": "two spans", "span [mm]": "6000; 5000", "dp [mm]": "250; 400; 90; 400; 250"},
        **{"support_left": "roller", "jack": "both", "live_spans": 1, "w_dead": 5, "w_live": 10},
    },
    SMALL | {"member": "stuck", "w_dead": 5},
    SMALL | {"member": "outside", "dp [mm]": "250; 650; 250"},
]
NAMES = [row["member"] for row in ROWS]


@pytest.fixture(scope="session")
def source(tmp_path_factory):
    """The input workbook."""
    path = tmp_path_factory.mktemp("plots") / "beams.xlsx"
    book = Workbook()
    page = book.active
    page.title = "members"
    headers = list(dict.fromkeys(header for row in ROWS for header in row))
    page.append(headers)
    for row in ROWS:
        page.append([row.get(header) for header in headers])
    book.save(path)
    return path


@pytest.fixture(scope="session")
def results(source):
    """Its results; the member `stuck` finds no equilibrium under live load."""
    serve = analysis.serve

    def stuck(run, refine, loss):
        if run.setup.member.member == "stuck":
            raise stages.NoEquilibriumError(stages.LIVE, NO_EQUILIBRIUM, 0.25)
        return serve(run, refine, loss)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(analysis, "serve", stuck)
        return run_workbook(source, jobs=2).path


@pytest.fixture(scope="session")
def stored(results):
    """Results by member."""
    return {result.name: result for result in read_stored(results, NAMES)}
