"""Sheets of a published table: their headers must be sound; a faulty row is kept with what is wrong."""

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from ptbatch.errors import ReadError
from ptbatch.validation import checked
from ptbatch.workbook.column import Column
from ptbatch.workbook.problems import Problem
from ptbatch.workbook.read import RawSheet
from ptbatch.workbook.table import Table, find_header, make_table

Values = dict[str, Any]
Fault = tuple[str, str, str]  # column, what is wrong and the cure
Faults = Callable[[Values, set[str]], Iterator[Fault]]  # of a row's sound values and the names of the others


class Faulty(NamedTuple):
    """A row that cannot be understood: the member and the quantity or figure that it is about, and why."""

    member: str
    what: str
    problems: list[Problem]


def open_table(
    path: Path, raw: RawSheet, key: str, columns: Sequence[Column], needed: Sequence[str] = ()
) -> Table:
    """The table whose headers have the key among them.

    needed: columns besides the required ones that must be there; a cell of them may be blank. Raises
    ReadError: a faulty header would concern every row.
    """
    top = find_header(raw, key)
    if top is None:
        cure = "give a published table, or a results workbook"
        raise ReadError(f"{path}: sheet {raw.name} has no column {key}; {cure}")
    table = make_table(raw, top, columns, "SI")
    faults = [str(problem) for problem in table.errors()]
    for column in columns:
        if (column.required or column.name in needed) and column.name not in table.found:
            sheet, cell, name = table.place(top, column.name)
            faults.append(f"{sheet}!{cell}  {name}: there is no such column; give {column.meaning}")
    if faults:
        raise ReadError(f"{path}:\n" + "\n".join(faults))
    if not table.rows:
        raise ReadError(f"{path}: sheet {raw.name} has no rows below its headers; add some")
    return table


def parsed(table: Table, number: int, faults: Faults) -> tuple[Values, list[Problem]]:
    """Sound values of a row and all its problems."""
    values, problems, bad = table.parse_row(number)
    problems += [
        Problem(table.place(number, name), table.raw(number, name), wrong, cure)
        for name, wrong, cure in faults(values, bad)
    ]
    return values, problems


def gaps(columns: Sequence[Column], values: Values, bad: set[str]) -> Iterator[Fault]:
    """Required values that are blank, and numbers beyond the limit of their column."""
    for column in columns:
        if column.required and column.name not in values and column.name not in bad:
            yield column.name, "missing", f"give {column.name}: {column.meaning}"
        elif column.kind == "number" and column.name in values:
            _, wrong = checked(column, values[column.name])
            if wrong:
                yield column.name, *wrong
