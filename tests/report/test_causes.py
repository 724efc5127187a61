"""The losses by cause as a report tells them."""

from ptbatch.report.causes import causes
from ptbatch.workbook.stored import Stored, Table

ROW = {"cause": "creep", "source": "long_term_loss", "loss [MPa]": -20.125, "share [%]": -1.5}


def stored(*rows):
    return Stored({}, None, Table(), Table(), Table(), losses=Table([*rows]))


def test_a_cause():
    (one,) = causes(stored(ROW | {"stress_after [MPa]": 1200.0}))
    assert (one.name, one.source) == ("creep", "long_term_loss")
    assert one.loss.startswith("\u221220.1") and one.share.startswith("\u22121.5")
    assert one.left.startswith("1200")


def test_older_results_have_none():
    assert causes(stored()) == []
