"""A raw sheet seen as a table: which column stands where, and in which unit."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from ptbatch.validation import closest
from ptbatch.workbook.cells import CellError, parse
from ptbatch.workbook.column import Column, System
from ptbatch.workbook.problems import Place, Problem
from ptbatch.workbook.read import RawSheet, address
from ptbatch.workbook.units import Header, UnitError, factor, parse_header

HEADER_WITHIN = 30  # rows: a title and some notes may stand above the table


@dataclass(frozen=True)
class Found:
    """A column of the registry found in the sheet; factor is None if its header is faulty."""

    column: Column
    index: int
    typed: str
    unit: str
    factor: float | None


@dataclass(frozen=True)
class Table:
    """Columns found by name, unknown headers by column number, rows below the header, its problems."""

    sheet: str
    columns: Sequence[Column]
    header_row: int
    found: dict[str, Found]
    unknown: dict[int, str]
    rows: dict[int, dict[int, Any]]
    problems: list[Problem]

    def place(self, row: int, name: str) -> Place:
        """Place of a value; for a column that the sheet does not have, where its header could be put."""
        if name in self.found:
            found = self.found[name]
            return Place(self.sheet, address(row, found.index), found.typed)
        free = 1 + max([found.index for found in self.found.values()] + list(self.unknown))
        return Place(self.sheet, address(self.header_row, free), name)

    def raw(self, row: int, name: str) -> Any:
        """Cell as typed; None if it is blank or there is no such column."""
        return self.rows[row].get(self.found[name].index) if name in self.found else None

    def errors(self) -> list[Problem]:
        """Faults of the headers, which concern every row."""
        return [problem for problem in self.problems if not problem.warning]

    def parse_row(self, row: int) -> tuple[dict[str, Any], list[Problem], set[str]]:
        """Sound values of a row by column, the problems of its other cells, and the names of these."""
        values: dict[str, Any] = {}
        problems: list[Problem] = []
        bad: set[str] = set()
        for name, found in self.found.items():
            raw = self.raw(row, name)
            if raw is None:
                continue
            try:
                if found.factor is None:
                    bad.add(name)
                else:
                    values[name] = parse(found.column, raw, found.factor)
            except CellError as error:
                problems.append(Problem(self.place(row, name), raw, error.wrong, error.cure))
                bad.add(name)
        return values, problems, bad


def find_header(raw: RawSheet, key: str) -> int | None:
    """Number of the first row that has a column of this name."""
    for number in list(raw.rows)[:HEADER_WITHIN]:
        names = (parse_header(str(value)).name.casefold() for value in raw.rows[number].values())
        if key.casefold() in names:
            return number
    return None


def make_table(raw: RawSheet, header_row: int, columns: Sequence[Column], system: System) -> Table:
    """Match the headers of a row to columns; units that are not given are those of the system."""
    typed = {index: str(value).strip() for index, value in raw.rows[header_row].items()}
    headers = {index: parse_header(text) for index, text in typed.items()}
    matches, twice = _match(headers, columns)
    problems = [_twice(Place(raw.name, address(header_row, i), typed[i])) for i in twice]
    found: dict[str, Found] = {}
    for index, column in matches.items():
        unit = headers[index].unit or column.unit(system)
        try:
            number = None if index in twice else factor(column.quantity, unit)
        except UnitError as error:
            number = None
            place = Place(raw.name, address(header_row, index), typed[index])
            problems.append(Problem(place, typed[index], error.wrong, error.cure))
        found.setdefault(column.name, Found(column, index, typed[index], headers[index].unit, number))
    unknown = {index: text for index, text in typed.items() if index not in matches}
    problems += [
        _unknown(Place(raw.name, address(header_row, i), text), headers[i].name, columns)
        for i, text in unknown.items()
    ]
    rows = {number: cells for number, cells in raw.rows.items() if number > header_row}
    return Table(raw.name, columns, header_row, found, unknown, rows, problems)


def _match(headers: dict[int, Header], columns: Iterable[Column]) -> tuple[dict[int, Column], set[int]]:
    """Column of each known header, and headers given twice. Case counts only where two names collide."""
    by_name = {column.name: column for column in columns}
    by_folded = {name.casefold(): column for name, column in by_name.items()}
    matches = {i: by_name[header.name] for i, header in headers.items() if header.name in by_name}
    exact = {column.name for column in matches.values()}
    for i, header in headers.items():
        column = by_folded.get(header.name.casefold())
        if column is not None and column.name not in exact:
            matches[i] = column
    named = [column.name for column in matches.values()]
    return matches, {i for i, column in matches.items() if named.count(column.name) > 1}


def _twice(place: Place) -> Problem:
    return Problem(place, place.column, "this column is given twice", "keep one of them")


def _unknown(place: Place, name: str, columns: Iterable[Column]) -> Problem:
    meant = closest(name, [column.name for column in columns])
    cure = f"did you mean {meant}?" if meant else "nothing to do if it is a note"
    return Problem(place, place.column, "unknown column", cure, warning=True)
