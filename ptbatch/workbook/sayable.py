"""What can stand in a cell."""

from datetime import date, time, timedelta
from math import isfinite
from numbers import Integral, Real
from typing import Any

from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE

from ptbatch.workbook.stored_values import Formula

DATES = date | time | timedelta
NOT_FINITE = "not a finite number"
LONGEST_TEXT = 32_767  # of an Excel cell


def sayable(value: Any) -> Any:
    """A value as it can stand in a cell or in JSON: finite, not too long, without control characters."""
    if type(value) is float:  # nearly all of them
        return value if isfinite(value) else NOT_FINITE
    if value is None or isinstance(value, bool | DATES | Formula):
        return value
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Real):
        return float(value) if isfinite(value) else NOT_FINITE
    text = ILLEGAL_CHARACTERS_RE.sub("", str(value))
    return text if len(text) <= LONGEST_TEXT else text[: LONGEST_TEXT - 4] + " ..."
