"""What Excel lets be typed into a column: choices from lists, numbers within limits, texts as texts."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from openpyxl.utils import get_column_letter
from openpyxl.worksheet.datavalidation import DataValidation

from ptbatch.workbook.column import LIMITS, LISTS, Column
from ptbatch.workbook.page import TEXT
from ptbatch.workbook.read import MAX_ROWS

_RULES: dict[str, dict[str, str]] = {
    "positive": {"operator": "greaterThan", "formula1": "0"},
    "not negative": {"operator": "greaterThanOrEqual", "formula1": "0"},
    "fraction": {"operator": "between", "formula1": "0.000001", "formula2": "0.999999"},
}
_TYPES = {"number": "decimal", "integer": "whole"}


def entry(columns: Sequence[Column]) -> Callable[[Any], None]:
    """What makes a blank sheet of openpyxl take sound values alone in these columns."""

    def dress(sheet: Any) -> None:
        for letter, column in _lettered(columns):
            if column.kind == "text" or (column.kind in LISTS and column.quantity == "number"):
                sheet.column_dimensions[letter].number_format = TEXT  # 001 stays, 1/3 becomes no date
            if rule := validation(column):
                rule.add(f"{letter}2:{letter}{MAX_ROWS + 1}")
                sheet.data_validations.append(rule)

    return dress


def _lettered(columns: Sequence[Column]) -> Iterator[tuple[str, Column]]:
    for i, column in enumerate(columns, 1):
        yield get_column_letter(i), column


def validation(column: Column) -> DataValidation | None:
    """The rule for cells of a column; None where anything may be typed, as in lists of numbers."""
    if words := ("yes", "no") if column.kind == "yesno" else column.choices:
        return _stop(
            column, f"Choose one of: {', '.join(words)}", type="list", formula1=f'"{",".join(words)}"'
        )
    if column.kind in _TYPES and column.limit in _RULES:
        what = f"Give a number {LIMITS[column.limit][1]}".replace("number zero", "number, zero")
        return _stop(column, what, type=_TYPES[column.kind], **_RULES[column.limit])
    return None


def _stop(column: Column, error: str, **rule: str) -> DataValidation:
    return DataValidation(
        **rule,
        allow_blank=True,
        showErrorMessage=True,
        errorStyle="stop",
        errorTitle=column.name,
        error=error,
    )
