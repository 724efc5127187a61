"""Colours of the column status in the sheet `summary`."""

from typing import Any

from openpyxl.formatting.rule import CellIsRule
from openpyxl.styles import PatternFill

from ptbatch.workbook.read import LAST_ROW

COLOURS = {
    "ok": "C6EFCE",
    "warning": "FFEB9C",
    "invalid": "FFC7CE",
    "not converged": "FFC7CE",
    "not analysed": "D9D9D9",
}


def coloured(sheet: Any) -> None:
    """Dress a blank sheet of openpyxl whose second column will be the status."""
    for status, colour in COLOURS.items():
        fill = PatternFill(bgColor=colour)
        rule = CellIsRule(operator="equal", formula=[f'"{status}"'], fill=fill)
        sheet.conditional_formatting.add(f"B2:B{LAST_ROW}", rule)
