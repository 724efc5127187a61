"""A workbook to start from: headers with units, one example row, a sheet that explains each column."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ptbatch.workbook.column import Column, System
from ptbatch.workbook.columns import MEMBERS, NOTE
from ptbatch.workbook.optional import OPTIONAL_SHEETS, SETTINGS
from ptbatch.workbook.write import Sheet, write_workbook

COLUMNS = (*MEMBERS, NOTE)
EXPLAINED = ("sheet", "column", "unit", "choices", "default", "meaning")


def write_template(path: Path, system: System) -> Path:
    """Write the template in SI or US units. Raises WriteError, also if the file is there already."""
    return write_workbook(path, _sheets(system), replace=False)


def _sheets(system: System) -> Iterator[Sheet]:
    headers = [column.header(system) for column in COLUMNS]
    yield Sheet("members", headers, [[_example(column, system) for column in COLUMNS]])
    yield Sheet("columns", EXPLAINED, list(_explanations(system)))


def _example(column: Column, system: System) -> Any:
    return column.example and column.example[system == "US"]


def _explanations(system: System) -> Iterator[list[str]]:
    for sheet, columns in ({"members": COLUMNS} | OPTIONAL_SHEETS | {"settings": SETTINGS}).items():
        for column in columns:
            choices = (
                "list, separated by ;" if column.kind in ("list", "integers") else ", ".join(column.choices)
            )
            default = column.default_text
            if isinstance(column.default, float) and column.unit("SI") != "-":
                default += f" {column.unit('SI')}"
            yield [sheet, column.name, column.unit(system), choices or "-", default, column.meaning]
