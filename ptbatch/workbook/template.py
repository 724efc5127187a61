"""A workbook to start from: a member of each kind, headers that explain themselves, drop-down lists."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from ptbatch.workbook.column import LIMITS, LISTS, Column, System
from ptbatch.workbook.columns import MEMBERS, NOTE
from ptbatch.workbook.entry import entry
from ptbatch.workbook.optional import OPTIONAL_SHEETS, SETTINGS
from ptbatch.workbook.starters import STARTERS
from ptbatch.workbook.units import conversion
from ptbatch.workbook.write import Sheet, write_workbook

SHEETS: dict[str, Sequence[Column]] = {
    name: (*columns, NOTE)
    for name, columns in ({"members": MEMBERS} | OPTIONAL_SHEETS | {"settings": SETTINGS}).items()
}
EXPLAINED = ("sheet", "column", "unit", "choices", "limit", "default", "meaning", "source")


def write_template(path: Path, system: System) -> Path:
    """Write the template in SI or US units. Raises WriteError, also if the file is there already."""
    return write_workbook(path, _sheets(system), replace=False)


def _sheets(system: System) -> Iterator[Sheet]:
    for name, columns in SHEETS.items():
        rows = [[row.of(c.name, system) for c in columns] for row in STARTERS if row.sheet == name]
        notes = {_header(column, system): comment(column, system) for column in columns}
        yield Sheet(name, list(notes), rows, notes, entry(columns))
    yield Sheet("columns", EXPLAINED, list(_explanations(system)))


def _header(column: Column, system: System) -> str:
    """Name and unit; a load names no unit, which is that of a force or of a line load, as its row needs."""
    return column.name if column.quantity == "force or line load" else column.header(system)


def comment(column: Column, system: System) -> str:
    """What a header says when it is pointed at: the meaning, then the facts that there are."""
    facts = dict(zip(EXPLAINED[2:], _facts(column, system), strict=True))
    lines = [f"{name}: {facts[name]}" for name in EXPLAINED[2:] if name != "meaning" and facts[name] != "-"]
    return "\n".join([facts["meaning"], *lines])


def _explanations(system: System) -> Iterator[list[str]]:
    for sheet, columns in SHEETS.items():
        for column in columns:
            yield [sheet, column.name, *_facts(column, system)]


def _facts(column: Column, system: System) -> list[str]:
    """Unit, choices, limit, default, meaning and source; a dash where there is none."""
    unit, default = _unit(column, system), _default(column, system)
    return [unit, _choices(column), _limit(column), default, column.meaning, column.source or "-"]


def _default(column: Column, system: System) -> str:
    """A number with its unit: the one in SI, which is exact, and what that is in the unit of the header."""
    si, unit = column.unit("SI"), column.unit(system)
    if not isinstance(column.default, float) or si == "-":
        return column.default_text
    other = f" ({column.default * conversion(si, unit):.5g} {unit})" if unit != si else ""
    return f"{column.default_text} {si}{other}"


def _unit(column: Column, system: System) -> str:
    if column.quantity == "force or line load":
        return "kN or kN/m" if system == "SI" else "kip or kip/ft"
    return column.unit(system)


def _choices(column: Column) -> str:
    if column.kind in LISTS:
        return "list, separated by ;"
    return "yes, no" if column.kind == "yesno" else ", ".join(column.choices) or "-"


def _limit(column: Column) -> str:
    numeric = column.kind in ("number", "integer", *LISTS) and column.limit != "any"
    return LIMITS[column.limit][1] if numeric else "-"
