"""A whole table of members, from a workbook, a CSV or a Parquet file: its rows as members or problems."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from hashlib import file_digest
from pathlib import Path
from typing import NamedTuple

from ptbatch.errors import PtbatchError, ReadError, UnknownMemberError
from ptbatch.validation import likely
from ptbatch.workbook import columnar, delimited
from ptbatch.workbook.cells import CellError, parse_text
from ptbatch.workbook.column import System
from ptbatch.workbook.columns import BY_NAME, MEMBERS
from ptbatch.workbook.joined import join
from ptbatch.workbook.lazy import Rows
from ptbatch.workbook.optional import MAIN, OPTIONAL_SHEETS
from ptbatch.workbook.problems import Listed, Problem
from ptbatch.workbook.read import RawSheet
from ptbatch.workbook.read_ahead import ReadAhead, raw_sheets
from ptbatch.workbook.rows import Row, RowReader
from ptbatch.workbook.settings import Settings, read_settings
from ptbatch.workbook.source import MOST_MEMBERS, Source, sheet_source
from ptbatch.workbook.systems import typical
from ptbatch.workbook.table import Table, make_table


@dataclass(frozen=True)
class Inputs:
    """Rows of a table in their order, read anew whenever they are walked through; problems that concern no
    single row; what `run` records; the unit system that results are expected in."""

    path: Path
    sha256: str
    rows: Sequence[Row]
    problems: list[Problem]
    settings: Settings
    extra_headers: list[str]
    system: System

    def walk_problems(self) -> Iterator[Problem]:
        """Every problem once, those of the workbook first."""
        listed = Listed()
        yield from listed.new(self.problems)
        for row in self.rows:
            yield from listed.new(row.problems)

    def all_problems(self) -> list[Problem]:
        """The same as a list."""
        return list(self.walk_problems())

    def only(self, names: Iterable[str]) -> "Inputs":
        """The same with these members alone. Raises UnknownMemberError."""
        wanted = set(names)
        rows = [row for row in self.rows if row.name in wanted]
        for name in sorted(wanted.difference(row.name for row in rows)):
            there = [row.name for row in self.rows]
            raise UnknownMemberError(f"there is no member {name}; {likely(name, there)}")
        return replace(self, rows=rows)


def read_inputs(path: Path, ahead: ReadAhead | None = None) -> Inputs:
    """Read and validate a table of members; ahead: of a workbook, who may be reading it already. Raises
    ReadError where there is nothing to validate."""
    for suffixes, source in _TABLES.items():
        if path.suffix.lower() in suffixes:
            with _naming(path):
                return _inputs(path, source(path), {}, Settings())
    return make_inputs(path, ahead.sheets() if ahead else raw_sheets(path))


_TABLES = {delimited.SUFFIXES: delimited.csv_source, columnar.SUFFIXES: columnar.parquet_source}


def make_inputs(path: Path, sheets: Mapping[str, RawSheet]) -> Inputs:
    """Validate the raw sheets of a workbook. Raises ReadError where there is nothing to validate."""
    settings = read_settings(sheets.get("settings"))
    optional = {
        name: sheets[name]
        for name in OPTIONAL_SHEETS
        if name in sheets and sheets[name].name != sheets[MAIN].name
    }
    with _naming(path):
        return _inputs(path, sheet_source(sheets[MAIN]), optional, settings)


@contextmanager
def _naming(path: Path) -> Iterator[None]:
    """Whatever makes a file unreadable becomes a ReadError that names it."""
    try:
        yield
    except ReadError as error:
        raise ReadError(f"{path}: {error}") from error
    except PtbatchError:
        raise
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror or error}") from error


def _inputs(path: Path, source: Source, optional: Mapping[str, RawSheet], settings: Settings) -> Inputs:
    table = make_table(source.head, source.header_row, MEMBERS, settings.system)
    names = _names(table, source)
    if not names.rows:
        raise ReadError(f"sheet {table.sheet} has no rows below its headers; add one per member")
    joined = {
        sheet: join(sheet, raw, settings.system, set(names.first) - {""}) for sheet, raw in optional.items()
    }
    attached = {sheet: rows.by_member for sheet, rows in joined.items()}
    errors = [problem for problem in settings.problems if not problem.warning]
    typed = [found.typed for columns in table.found.values() for found in columns]
    system = settings.units or typical(typed)
    units = settings.system, system
    reader = RowReader(table, settings.defaults, attached, names.repeated, errors, *units)
    problems = [*settings.problems, *table.problems, *(p for rows in joined.values() for p in rows.problems)]
    with path.open("rb") as file:
        digest = file_digest(file, "sha256").hexdigest()
    rows = Rows(reader, source.blocks, names.rows)
    return Inputs(path, digest, rows, problems, settings, list(table.others.values()), system)


class _Names(NamedTuple):
    """How many rows there are, the first of each name, and all rows of names that are not unique."""

    rows: int
    first: dict[str, int]
    repeated: dict[str, list[int]]


def _names(table: Table, source: Source) -> _Names:
    first: dict[str, int] = {}
    repeated: dict[str, list[int]] = {}
    count = 0
    for block in source.blocks():
        part = replace(table, rows=block)
        for number in block:
            name = _name(part, number)
            if first.setdefault(name, number) != number:
                repeated.setdefault(name, [first[name]]).append(number)
        count += len(block)
        if count > MOST_MEMBERS:
            raise ReadError(f"there are more than {MOST_MEMBERS} rows; split the file")
    return _Names(count, first, repeated)


def _name(table: Table, number: int) -> str:
    raw = table.raw(number, "member")
    try:
        return "" if raw is None else parse_text(BY_NAME["member"], raw)
    except CellError:
        return ""
