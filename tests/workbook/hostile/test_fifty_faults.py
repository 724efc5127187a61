"""2,000 rows with fifty faults: every fault told with sheet, cell and cure, every good row computed."""

import pytest
from openpyxl import load_workbook

from ptbatch.batch import run_workbook
from ptbatch.workbook.inputs import read_inputs
from tests.workbook.hostile.sown import FAULTS, ROWS, rows, write

SEED = 20261126
TAKEN = 9  # row of G0007, whose name the last fault takes


@pytest.fixture(scope="module")
def field(tmp_path_factory):
    """The workbook, and what was sown into it."""
    content, sown = rows(SEED)
    return write(tmp_path_factory.mktemp("field") / "beams.xlsx", content), sown


def test_there_are_fifty_kinds():
    assert len({(fault.column, str(fault.typed)) for fault in FAULTS}) == len(FAULTS) == 50


def test_every_fault_is_told_with_cell_and_cure(field):
    path, sown = field
    told: dict[str, list] = {}
    for problem in read_inputs(path).all_problems():
        if not problem.warning:
            assert problem.place.sheet == "members" and problem.wrong and problem.cure
            told.setdefault(problem.place.cell, []).append(problem.wrong)
    for fault, _, cell in sown:
        assert any(fault.said in wrong for wrong in told.get(cell, ())), (cell, fault, told.get(cell))
    at_fault = {row for _, row, _ in sown} | {TAKEN}
    assert {int("".join(filter(str.isdigit, cell))) for cell in told} == at_fault


def test_all_good_rows_are_computed(field):
    path, sown = field
    batch = run_workbook(path, jobs=2)
    invalid = len(sown) + 1  # the one whose name is taken as well
    assert batch.counts == {
        "ok": ROWS - invalid, "warning": 0, "invalid": invalid, "not converged": 0, "not analysed": 0,
    }  # fmt: skip
    book = load_workbook(batch.path, read_only=True)
    summary = list(book["summary"].iter_rows(values_only=True))
    peak = summary[0].index("load_peak [kN]")
    bad = {row for _, row, _ in sown} | {TAKEN}
    for number, line in enumerate(summary[1:], 2):
        assert (line[1] == "invalid") == (number in bad)
        assert isinstance(line[peak], float) != (number in bad)
    listed = {row[1] for row in book["problems"].iter_rows(min_row=2, values_only=True)}
    assert {cell for _, _, cell in sown} <= listed
