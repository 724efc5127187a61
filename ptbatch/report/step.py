"""One step of a derivation, as it stands in a report."""

from typing import NamedTuple

import numpy as np

from ptbatch.report.words import DASH, Words
from ptbatch.workbook.stored import Stored

JACKED_CURVE, ANCHORED_CURVE = "σ\u2009jacked", "σ\u2009anchored"


class Step(NamedTuple):
    """A quantity, its formula, the numbers put in, the value of both, and what the analysis found.

    One that the analysis has nothing beside has `-` there.
    """

    quantity: str
    formula: str
    numbers: str
    analytic: str
    fe: str = DASH


def with_unit(unit: str, stored: Stored, header: str) -> str:
    """A value of the summary with its unit, or the text in its place."""
    words = Words(stored.system)
    text = words.said(stored.summary.get(header), unit)
    return f"{text} {words.unit(unit)}" if np.isfinite(stored.value(header)) else text
