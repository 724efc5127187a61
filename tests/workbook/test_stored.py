"""Results read back."""

import numpy as np
import pytest

from ptbatch.batch import run_workbook
from ptbatch.errors import ReadError, UnknownMemberError
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.stored import read_all, read_stored


def test_what_is_stored(book, beam, engine):
    source = book(beam, beam | {"member": "B2", "fc": "x"}, beam | {"member": "stuck"})
    good, bad, stuck = read_stored(run_workbook(source).path, ["B1", "B2", "stuck"])
    assert good.member == read_inputs(source).rows[0].member
    assert (good.name, good.value("load_peak [kN]")) == ("B1", 1.25)
    assert good.tendon.stage("jacked").numbers("stress_fe [MPa]").tolist() == [1.0]
    assert len(good.curves) == 2
    assert len(good.tendon.stage("peak")) == 0
    assert bad.member is None
    assert np.isnan(bad.value("load_peak [kN]"))  # a text says why
    assert stuck.summary["status"] == "not converged"


def test_every_row_is_read(book, beam, engine):
    """In the order of the input; of two rows with one name neither has anything."""
    path = run_workbook(book(beam | {"member": "B2"}, beam, beam | {"member": "B3"}, beam)).path
    rows = read_all(path)
    assert [row.name for row in rows] == ["B2", "B1", "B3", "B1"]
    assert [len(row.curves) for row in rows] == [2, 0, 2, 0]
    assert [row.member is None for row in rows] == [False, True, False, True]


def test_members_that_are_not_there(book, beam, engine):
    path = run_workbook(book(beam)).path
    with pytest.raises(UnknownMemberError, match="no member b1; did you mean B1"):
        read_stored(path, ["b1"])


def test_no_results(book, beam, tmp_path):
    with pytest.raises(ReadError, match="no sheet summary"):
        read_stored(book(beam), ["B1"])
    with pytest.raises(ReadError, match="no column member"):
        read_stored(book(beam, summary=[{"name": "B1"}]), ["B1"])
    with pytest.raises(ReadError, match="No such file"):
        read_stored(tmp_path / "none.xlsx", ["B1"])
