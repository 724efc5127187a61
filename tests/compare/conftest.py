"""Results and published tables written on the spot."""

from pathlib import Path

import pytest

from tests.compare.made_up import CRACKS, CURVES, ROW, TENDON, summary, write


@pytest.fixture
def results(tmp_path):
    """results(row of summary, ..., name=...) writes a results workbook and returns its path."""

    def make(*rows, name="beams.results.xlsx") -> Path:
        rows = rows or (summary(), summary(member="B2", **{"load_peak [kN]": "not converged: see message"}))
        return write(tmp_path / name, summary=rows, tendon=TENDON, curves=CURVES, cracks=CRACKS)

    return make


@pytest.fixture
def published(tmp_path):
    """published(row, ...) writes a table; what a row does not say is as in ROW. Sheets by their name."""

    def make(*rows, name="published.xlsx", **sheets) -> Path:
        return write(tmp_path / name, published=[ROW | row for row in rows], **sheets)

    return make


@pytest.fixture
def lines(results, published):
    """lines(row, ..., rtol=...) compares rows with the made-up results."""
    from ptbatch.compare.comparison import compare_workbooks

    def compare(*rows, rtol=1e-6):
        return compare_workbooks(results(), published(*rows), rtol=rtol).lines

    return compare
