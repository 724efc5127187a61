"""Formulas with the value that they have: what programs show that do not calculate.

openpyxl writes a formula or a value into a cell, never both. The values are put into the XML of the sheet
before it is packed.
"""

import re
from collections.abc import Mapping
from math import isfinite
from pathlib import Path
from typing import Any, NamedTuple
from xml.sax.saxutils import escape

NOT_AVAILABLE = "#N/A"
_CELL = re.compile(r'<c r="([A-Z]+\d+)"([^>]*)>(<f>[^<]*</f>)<v\s*(?:/>|></v>)</c>')


class Formula(NamedTuple):
    """Text of a formula, `=` included, and its value: a number, a text or NOT_AVAILABLE."""

    text: str
    value: float | str


def store_values(sheet: Any, values: Mapping[str, float | str]) -> None:
    """Close a write-only sheet of openpyxl and put values, by cell, beside its formulas."""
    sheet.close()
    path = Path(sheet._writer.out)
    text = path.read_text("utf-8")
    path.write_text(_CELL.sub(lambda match: _stored(match, values[match[1]]), text), "utf-8")


def _stored(match: re.Match[str], value: float | str) -> str:
    cell, attributes, formula = match.groups()
    if isinstance(value, float) and not isfinite(value):
        value = NOT_AVAILABLE
    if isinstance(value, str):
        kind = "e" if value == NOT_AVAILABLE else "str"
        return f'<c r="{cell}"{attributes} t="{kind}">{formula}<v>{escape(value)}</v></c>'
    return f'<c r="{cell}"{attributes}>{formula}<v>{float(value)!r}</v></c>'
