"""What a results workbook holds of some of its members, read back."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.errors import ReadError, UnknownMemberError
from ptbatch.member import Member
from ptbatch.validation import likely
from ptbatch.workbook.column import System
from ptbatch.workbook.filed import folder_in, rows_of, sheet_of
from ptbatch.workbook.inputs import make_inputs
from ptbatch.workbook.optional import MAIN, OPTIONAL_SHEETS
from ptbatch.workbook.read import RawSheet, guarded, open_book
from ptbatch.workbook.settings import read_settings
from ptbatch.workbook.systems import record_in

BOUNDS = 8  # results may be that many times larger than an input
TABLES = ("tendon", "curves", "cracks", "checks", "losses")

Row = dict[str, Any]


@dataclass(frozen=True)
class Table:
    """Rows of one sheet that belong to one member, by header, in SI units."""

    rows: list[Row] = field(default_factory=list)

    def __len__(self) -> int:
        return len(self.rows)

    def stage(self, name: str) -> "Table":
        """The rows of one stage."""
        return Table([row for row in self.rows if row["stage"] == name])

    def numbers(self, header: str) -> NDArray[np.float64]:
        """A column; nan where a text says why there is no number."""
        return np.array([number(row.get(header)) for row in self.rows])


@dataclass(frozen=True)
class Stored:
    """Results of one member, in SI units. member is None where its row was invalid; tables are empty where
    the analysis did not get that far. system: that of the workbook, in which they are to be shown; a row of
    checks names its own unit."""

    summary: Row
    member: Member | None
    tendon: Table
    curves: Table
    cracks: Table
    system: System = "SI"
    checks: Table = Table()
    losses: Table = Table()

    @property
    def name(self) -> str:
        """Name of the member."""
        return str(self.summary["member"])

    def value(self, header: str) -> float:
        """A number of the summary; nan where a text says why there is none."""
        return number(self.summary.get(header))


def number(value: Any) -> float:
    """The value if it is a number, else nan."""
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else np.nan


def read_stored(path: Path, names: Sequence[str]) -> list[Stored]:
    """Results of the named members, in that order. Raises ReadError, UnknownMemberError."""
    read = _members_of(path, set(names))
    by_name = {stored.name: stored for stored in reversed(read.wanted)}  # the first of a name
    for name in names:
        if name not in by_name:
            raise UnknownMemberError(f"there is no member {name}; {likely(name, read.names)}")
    return [by_name[name] for name in names]


def read_all(path: Path) -> list[Stored]:
    """Results of every row of the summary, in its order. Raises ReadError."""
    return _members_of(path, None).wanted


class _Read(NamedTuple):
    """The rows asked for, and the names of all rows."""

    wanted: list[Stored]
    names: list[str]


def _members_of(path: Path, names: set[str] | None) -> _Read:
    """Rows of the members of these names, or all."""
    every, summary, tables, raw = guarded(path, lambda file: _read(file, path, names), BOUNDS)
    members, system = _members(path, raw), read_settings(raw.get("settings")).system
    by_name = {sheet: _by_name(rows) for sheet, rows in tables.items()}
    return _Read([_stored(row, members, by_name, system) for row in summary], every)


def _by_name(rows: Iterable[Row]) -> dict[Any, list[Row]]:
    found: dict[Any, list[Row]] = defaultdict(list)
    for row in rows:
        found[row["member"]].append(row)
    return found


def _stored(
    row: Row, members: dict[str, Member], tables: dict[str, dict[Any, list[Row]]], system: System
) -> Stored:
    """One row; an invalid one has nothing, also where a sound one has its name."""
    name = row["member"]
    if row.get("status") == "invalid":
        return Stored(row, None, Table(), Table(), Table(), system)
    tendon, curves, cracks, checks, losses = (Table(tables[sheet].get(name, [])) for sheet in TABLES)
    return Stored(row, members.get(str(name)), tendon, curves, cracks, system, checks, losses)


def _read(
    file: BinaryIO, path: Path, names: set[str] | None
) -> tuple[list[str], list[Row], dict[str, list[Row]], dict[str, RawSheet]]:
    """All names; of the wanted members rows of the summary, of the other tables as read, and raw."""
    book = open_book(file)
    if "summary" not in book.sheetnames:
        raise ReadError("these are no results: there is no sheet summary; --geometry draws an input workbook")
    every: list[str] = []
    summary: list[Row] = []
    for row in _rows(book, "summary"):
        every.append(str(row["member"]))
        if names is None or every[-1] in names:
            summary.append(row)
    wanted = set(every) if names is None else names
    if folder := folder_in(book, path):
        tables = {name: _in_si(rows_of(folder, name, wanted)) for name in TABLES}
        raw = {name: sheet_of(folder, name, wanted) for name in (MAIN, *OPTIONAL_SHEETS)}
        return every, summary, tables, raw | _settings(book)
    tables = {name: [row for row in _rows(book, name) if row["member"] in wanted] for name in TABLES}
    return every, summary, tables, {n: _raw(book[n], wanted) for n in _echoed(book)} | _settings(book)


def _in_si(rows: Iterable[Row]) -> list[Row]:
    return [record_in(row, "SI") for row in rows]


def _settings(book: Any) -> dict[str, RawSheet]:
    """The sheet that names the unit system of the members, if there is one."""
    return {name: _raw(book[name], {"units"}) for name in ("settings",) if name in book.sheetnames}


def _echoed(book: Any) -> Iterable[str]:
    return [name for name in (MAIN, *OPTIONAL_SHEETS) if name in book.sheetnames]


def _rows(book: Any, name: str) -> Iterator[Row]:
    """Rows of a sheet by header, in SI units; none if there is no such sheet."""
    if name not in book.sheetnames:
        return
    rows = book[name].iter_rows(values_only=True)
    headers = next(rows, ())
    if "member" not in headers:
        raise ReadError(f"sheet {name} has no column member; run the input again for whole results")
    for row in rows:
        named = {header: value for header, value in zip(headers, row, strict=False) if header is not None}
        yield record_in(named, "SI")


def _raw(sheet: Any, wanted: set[str]) -> RawSheet:
    """Header and rows of the wanted members (their name stands in the first column)."""
    rows = {
        number: {column: value for column, value in enumerate(row, 1) if value is not None}
        for number, row in enumerate(sheet.iter_rows(values_only=True), 1)
        if number == 1 or str(row[0]) in wanted
    }
    return RawSheet(sheet.title, rows)


def _members(path: Path, raw: dict[str, RawSheet]) -> dict[str, Member]:
    """The members as they were analysed."""
    if len(raw.get(MAIN, RawSheet("", {})).rows) < 2:
        return {}
    return {row.name: row.member for row in make_inputs(path, raw).rows if row.member is not None}
