"""A whole workbook: its rows as members or problems."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from hashlib import file_digest
from pathlib import Path

from ptbatch.errors import ReadError, UnknownMemberError
from ptbatch.validation import closest, likely
from ptbatch.workbook.cells import CellError, parse_text
from ptbatch.workbook.columns import BY_NAME, MEMBERS
from ptbatch.workbook.joined import join
from ptbatch.workbook.optional import OPTIONAL_SHEETS
from ptbatch.workbook.problems import Problem
from ptbatch.workbook.read import RawSheet, read_sheets
from ptbatch.workbook.rows import Row, RowReader
from ptbatch.workbook.settings import Settings, read_settings
from ptbatch.workbook.table import Table, find_header, make_table
from ptbatch.workbook.units import parse_header

MAIN = "members"


@dataclass(frozen=True)
class Inputs:
    """Rows of a workbook in their order; problems that concern no single row; what `run` records."""

    path: Path
    sha256: str
    rows: list[Row]
    problems: list[Problem]
    settings: Settings
    extra_headers: list[str]

    def all_problems(self) -> list[Problem]:
        """Every problem once, those of the workbook first."""
        return list(dict.fromkeys([*self.problems, *(p for row in self.rows for p in row.problems)]))

    def only(self, names: Iterable[str]) -> "Inputs":
        """The same with these members alone. Raises UnknownMemberError."""
        wanted, there = set(names), [row.name for row in self.rows]
        for name in sorted(wanted.difference(there)):
            raise UnknownMemberError(f"there is no member {name}; {likely(name, there)}")
        return replace(self, rows=[row for row in self.rows if row.name in wanted])


def read_inputs(path: Path) -> Inputs:
    """Read and validate a workbook. Raises ReadError where there is nothing to validate."""
    return make_inputs(path, read_sheets(path, MAIN, [*OPTIONAL_SHEETS, "settings"]))


def make_inputs(path: Path, sheets: dict[str, RawSheet]) -> Inputs:
    """Validate the raw sheets of a workbook. Raises ReadError where there is nothing to validate."""
    settings = read_settings(sheets.get("settings"))
    table = _members(path, sheets[MAIN], settings)
    names = _rows_by_name(table)
    joined = {
        sheet: join(sheet, sheets[sheet], settings.system, set(names) - {""})
        for sheet in OPTIONAL_SHEETS
        if sheet in sheets and sheets[sheet].name != sheets[MAIN].name
    }
    attached = {sheet: rows.by_member for sheet, rows in joined.items()}
    errors = [problem for problem in settings.problems if not problem.warning]
    reader = RowReader(table, settings.defaults, attached, names, errors)
    problems = [*settings.problems, *table.problems, *(p for rows in joined.values() for p in rows.problems)]
    with path.open("rb") as file:
        digest = file_digest(file, "sha256").hexdigest()
    rows = [reader.read(number) for number in table.rows]
    return Inputs(path, digest, rows, problems, settings, list(table.others.values()))


def _members(path: Path, raw: RawSheet, settings: Settings) -> Table:
    header = find_header(raw, "member")
    if header is None:
        raise ReadError(f"{path}: {_no_header(raw)}")
    table = make_table(raw, header, MEMBERS, settings.system)
    if not table.rows:
        raise ReadError(f"{path}: sheet {raw.name} has no rows below its headers; add one per member")
    return table


def _no_header(raw: RawSheet) -> str:
    """Why a sheet is no table of members."""
    if not raw.rows:
        return f"sheet {raw.name} is empty; `ptbatch template FILE` writes a workbook to start from"
    names = [parse_header(str(value)).name for value in next(iter(raw.rows.values())).values()]
    known = {name.casefold() for name in BY_NAME}
    strange = [name for name in names if name.casefold() not in known]
    close = next((name for name in strange if closest(name, ["member"])), None)
    cure = (
        f"did you mean member where it says {close}?" if close else "put the members on a sheet named members"
    )
    return f"sheet {raw.name} has no column member; {cure}"


def _rows_by_name(table: Table) -> dict[str, list[int]]:
    names: dict[str, list[int]] = {}
    for number in table.rows:
        names.setdefault(_name(table, number), []).append(number)
    return names


def _name(table: Table, number: int) -> str:
    raw = table.raw(number, "member")
    try:
        return "" if raw is None else parse_text(BY_NAME["member"], raw)
    except CellError:
        return ""
