"""The members of a run as they were analysed, every default filled in: sheets that can be read as input.

Headers stand in SI or US units, and numbers are those that make the same member when they are read.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import inf, nextafter
from typing import Any

from ptbatch.member import Member
from ptbatch.workbook.column import LISTS, UNITS, Column, System
from ptbatch.workbook.columns import MEMBERS
from ptbatch.workbook.joined import BUILDERS
from ptbatch.workbook.optional import OPTIONAL_SHEETS
from ptbatch.workbook.units import factor
from ptbatch.workbook.write import Sheet

ECHOED = tuple(column for column in MEMBERS if column.name in Member.__dataclass_fields__)  # all but k_ec2
EITHER = "force or line load"
QUANTITIES = {"point": "force", "uniform": "line load"}  # of a load by its type


TABLES: Mapping[str, Sequence[Column]] = {"members": ECHOED} | OPTIONAL_SHEETS


def echo(members: Iterable[Member], system: System = "SI") -> Iterator[Sheet]:
    """Sheet `members`, and of `profile`, `rebar` and `loads` those that a member uses."""
    members = list(members)
    for name in TABLES:
        rows = [line for member in members for line in echo_lines(name, member, system)]
        if rows or name == "members":
            yield Sheet(name, echo_headers(name, system), rows)


def echo_headers(name: str, system: System) -> list[str]:
    """Headers of a sheet, with units."""
    return [_header(column, system) for column in TABLES[name]]


def echo_lines(name: str, member: Member, system: System) -> list[list[Any]]:
    """Lines of a member in a sheet."""
    if name == "members":
        return [_line(ECHOED, vars(member), system)]
    items = getattr(member, BUILDERS[name][0])
    return [_line(TABLES[name], {"member": member.member} | item._asdict(), system) for item in items]


def _header(column: Column, system: System) -> str:
    """Name and unit; a column of loads names no unit, which is then that of the system's forces or line loads
    as the row needs."""
    return column.name if column.quantity == EITHER else column.header(system)


def _line(columns: Sequence[Column], values: Mapping[str, Any], system: System) -> list[Any]:
    either = QUANTITIES.get(values.get("type", ""), "")
    return [_cell(column, values[column.name], either, system) for column in columns]


def _cell(column: Column, value: Any, either: str, system: System) -> Any:
    """A value as it is typed: nothing for None or an empty list, a text for several numbers. either: the
    quantity of a load."""
    if value is None or isinstance(value, str):
        return value
    if column.kind == "yesno":
        return "yes" if value else "no"
    quantity = either if column.quantity == EITHER else column.quantity
    name = UNITS[quantity][0 if system == "SI" else 1] if column.quantity == EITHER else column.unit(system)
    unit = factor(quantity, name)
    if column.kind not in LISTS:
        return _typed(value, unit)
    numbers = [_typed(number, unit) for number in value]
    return "; ".join(map(_shortest, numbers)) if len(numbers) > 1 else next(iter(numbers), None)


def _typed(value: float, unit: float) -> float:
    """The shortest of the nearest numbers that gives exactly this value in the unit, if one does."""
    if unit == 1.0:
        return value
    number = value / unit
    near = (float(f"{number:.15g}"), number, nextafter(number, inf), nextafter(number, -inf))
    return next((n for n in near if n * unit == value), number)


def _shortest(number: float) -> str:
    return repr(number).removesuffix(".0")
