"""The sheet `settings`: defaults of any column for the whole workbook, and the unit system."""

from dataclasses import dataclass, field
from typing import Any

from ptbatch.validation import likely
from ptbatch.workbook.cells import CellError, parse
from ptbatch.workbook.column import System
from ptbatch.workbook.columns import BY_NAME
from ptbatch.workbook.optional import SETTINGS
from ptbatch.workbook.problems import Place, Problem
from ptbatch.workbook.read import RawSheet
from ptbatch.workbook.table import Table, find_header, make_table
from ptbatch.workbook.units import UnitError, factor, parse_header, plain

UNIT_SYSTEM = ("units", "unit system", "unit_system")


@dataclass(frozen=True)
class Setting:
    """A default of this workbook; where the cell is faulty, `problem` says so and the value is None."""

    place: Place
    raw: Any
    value: Any = None
    problem: Problem | None = None


@dataclass(frozen=True)
class Settings:
    """Unit system as asked for, defaults by column, problems that concern nobody's row."""

    units: System | None = None
    defaults: dict[str, Setting] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)

    @property
    def system(self) -> System:
        """Unit system of headers without units."""
        return self.units or "SI"


def read_settings(raw: RawSheet | None) -> Settings:
    """Settings of a workbook, all default ones if it has no such sheet."""
    header = find_header(raw, "name") if raw else None
    if raw is None or header is None:
        return Settings()
    table = make_table(raw, header, SETTINGS, "SI")
    settings = Settings(_system(table), problems=table.problems)
    for row in table.rows:
        name = parse_header(str(table.raw(row, "name") or "")).name
        if name.casefold() not in UNIT_SYSTEM:
            _add(settings, table, row)
    return settings


def _system(table: Table) -> System | None:
    for row in table.rows:
        if plain(str(table.raw(row, "name"))).casefold() in UNIT_SYSTEM:
            system = plain(str(table.raw(row, "value"))).upper()
            if system not in ("SI", "US"):
                place = table.place(row, "value")
                wrong = "there is no such unit system"
                table.problems.append(Problem(place, table.raw(row, "value"), wrong, "give SI or US"))
            return "US" if system == "US" else "SI"
    return None


def _add(settings: Settings, table: Table, row: int) -> None:
    header = parse_header(str(table.raw(row, "name") or ""))
    folded = {name.casefold(): column for name, column in BY_NAME.items() if name != "member"}
    column = folded.get(header.name.casefold())
    raw = table.raw(row, "value")
    if column is None:
        wrong, cure = "there is no such column to give a default for", likely(header.name, BY_NAME)
        place = table.place(row, "name")
        settings.problems.append(Problem(place, table.raw(row, "name"), wrong, cure, warning=True))
        return
    if raw is None:
        return
    place = table.place(row, "value")._replace(column=f"setting {column.name}")
    try:
        if column.name in settings.defaults:
            raise CellError("this setting is given twice", "keep one of them")
        unit = header.unit or column.unit(settings.system)
        value = parse(column, raw, factor(column.quantity, unit))
        settings.defaults[column.name] = Setting(place, raw, value)
    except (CellError, UnitError) as error:
        problem = Problem(place, raw, error.wrong, error.cure)
        settings.defaults[column.name] = Setting(place, raw, problem=problem)
