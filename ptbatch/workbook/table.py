"""A raw sheet seen as a table: which column stands where, and in which unit."""

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from ptbatch.validation import closest
from ptbatch.workbook.cells import CellError, parse
from ptbatch.workbook.column import Column, System
from ptbatch.workbook.columns import NOTE
from ptbatch.workbook.problems import Place, Problem
from ptbatch.workbook.read import Block, RawSheet
from ptbatch.workbook.units import Header, UnitError, factor, parse_header

HEADER_WITHIN = 30  # rows: a title and some notes may stand above the table


@dataclass(frozen=True)
class Found:
    """A column of the registry found in the sheet; factor is 0 if its header is faulty."""

    column: Column
    index: int
    typed: str
    unit: str
    factor: float


@dataclass(frozen=True)
class Table:
    """Columns found by name, other headers by column number, rows below the header, its problems.

    A column can stand there once in each unit, e.g. `span [m]` and `span [ft]`: a row fills one of them.
    """

    sheet: str
    columns: Sequence[Column]
    header_row: int
    found: dict[str, list[Found]]
    others: dict[int, str]
    rows: Block
    problems: list[Problem]
    cell: Callable[[int, int], str]
    width: int | None

    def at(self, row: int, name: str) -> Found | None:
        """The column of this name that the row fills, or else the first; None if there is none."""
        return next(iter(self._filled(row, name) or self.found.get(name, [])), None)

    def place(self, row: int, name: str) -> Place:
        """Place of a value; for a column that the sheet does not have, where its header could be put."""
        if found := self.at(row, name):
            return Place(self.sheet, self.cell(row, found.index), found.typed)
        taken = [found.index for columns in self.found.values() for found in columns]
        return Place(self.sheet, self.cell(self.header_row, 1 + max([*taken, *self.others])), name)

    def raw(self, row: int, name: str) -> Any:
        """Cell as typed; None if it is blank or there is no such column."""
        found = self.at(row, name)
        return self.rows[row].get(found.index) if found else None

    def errors(self) -> list[Problem]:
        """Faults of the headers, which concern every row."""
        return [problem for problem in self.problems if not problem.warning]

    def parse_row(self, row: int) -> tuple[dict[str, Any], list[Problem], set[str]]:
        """Sound values of a row by column, the problems of its other cells, and the names of these."""
        if self.width is not None and max(self.rows[row]) > self.width:
            return {}, [self._misfit(row, self.width)], {column.name for column in self.columns}
        values: dict[str, Any] = {}
        problems: list[Problem] = []
        bad: set[str] = set()
        for name in self.found:
            filled = self._filled(row, name)
            if not all(found.factor for found in filled):
                bad.add(name)
            elif filled:
                try:
                    values[name] = self._value(row, *filled)
                except CellError as error:
                    place, raw = self.place(row, name), self.raw(row, name)
                    problems.append(Problem(place, raw, error.wrong, error.cure))
                    bad.add(name)
        return values, problems, bad

    def _misfit(self, row: int, width: int) -> Problem:
        """A row with more cells than there are headers, none of which can be trusted."""
        last = max(self.rows[row])
        place = Place(self.sheet, self.cell(row, last), "no header")
        cure = "put quotes around a cell with separators in it, such as a list, and use a point for decimals"
        return Problem(place, self.rows[row][last], f"{last} cells below {width} headers", cure)

    def _filled(self, row: int, name: str) -> list[Found]:
        return [found for found in self.found.get(name, []) if found.index in self.rows.get(row, ())]

    def _value(self, row: int, found: Found, *others: Found) -> Any:
        if others:
            cells = " and ".join(self.cell(row, other.index) for other in others)
            raise CellError(f"{found.column.name} is given in {cells} as well", "leave all but one blank")
        return parse(found.column, self.rows[row][found.index], found.factor)


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
    matches = _match(headers, columns)
    factors, faults = _factors(headers, matches, system)
    found: dict[str, list[Found]] = {}
    for i, column in matches.items():
        found.setdefault(column.name, []).append(Found(column, i, typed[i], headers[i].unit, factors[i]))
    others = {index: text for index, text in typed.items() if index not in matches}
    places = {i: Place(raw.name, raw.cell(header_row, i), text) for i, text in typed.items()}
    problems = [Problem(places[i], typed[i], *fault) for i, fault in faults.items()]
    problems += [
        _unknown(places[i], headers[i].name, columns)
        for i in others
        if headers[i].name.casefold() != NOTE.name
    ]
    rows = {number: cells for number, cells in raw.rows.items() if number > header_row}
    return Table(raw.name, columns, header_row, found, others, rows, problems, raw.cell, raw.width)


def _match(headers: dict[int, Header], columns: Iterable[Column]) -> dict[int, Column]:
    """Column of each known header. Case counts only where two names collide."""
    columns = list(columns)
    by_name = {column.also: column for column in columns if column.also}
    by_name |= {column.name: column for column in columns}
    by_folded = {name.casefold(): column for name, column in by_name.items()}
    matches = {i: by_name[header.name] for i, header in headers.items() if header.name in by_name}
    exact = {column.name for column in matches.values()}
    for i, header in headers.items():
        column = by_folded.get(header.name.casefold())
        if column is not None and column.name not in exact:
            matches[i] = column
    return matches


def _factors(
    headers: dict[int, Header], matches: dict[int, Column], system: System
) -> tuple[dict[int, float], dict[int, tuple[str, str]]]:
    """Factors of the matched headers to N, mm, MPa, 0 for the faulty ones; what is wrong and the cure."""
    factors: dict[int, float] = {}
    faults: dict[int, tuple[str, str]] = {}
    for i, column in matches.items():
        try:
            factors[i] = factor(column.quantity, headers[i].unit or column.unit(system))
        except UnitError as error:
            faults[i] = error.wrong, error.cure
    same = Counter((matches[i].name, number) for i, number in factors.items())
    for i, number in factors.items():
        if same[matches[i].name, number] > 1:
            faults[i] = "this column is given twice", "keep one of them"
    return factors | dict.fromkeys(faults, 0.0), faults


def _unknown(place: Place, name: str, columns: Iterable[Column]) -> Problem:
    meant = closest(name, [column.name for column in (*columns, NOTE)])
    cure = f"did you mean {meant}?" if meant else "nothing to do if it is a note"
    return Problem(place, place.column, "unknown column", cure, warning=True)
