"""The optional sheets `profile`, `rebar` and `loads`: their rows, joined to members by name."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from ptbatch.along import Bar, Load, Point
from ptbatch.validation import closest
from ptbatch.workbook.cells import parse
from ptbatch.workbook.column import UNITS, System
from ptbatch.workbook.optional import OPTIONAL_SHEETS
from ptbatch.workbook.problems import Place, Problem
from ptbatch.workbook.read import RawSheet, address
from ptbatch.workbook.table import Table, find_header, make_table
from ptbatch.workbook.units import UnitError, factor

Values = dict[str, Any]


@dataclass(frozen=True)
class Attached:
    """Rows of one optional sheet that belong to one member; problems are those of its cells."""

    table: Table
    numbers: list[int]
    values: list[Values]
    problems: list[Problem]

    def place(self, item: int, name: str) -> Place:
        """Place of a value in one of these rows, counted from 0."""
        return self.table.place(self.numbers[item], name)


@dataclass(frozen=True)
class Joined:
    """An optional sheet: its rows by member, and problems that concern nobody's row."""

    by_member: dict[str, Attached]
    problems: list[Problem]


def join(name: str, raw: RawSheet, system: System, members: set[str]) -> Joined:
    """Join the rows of an optional sheet to the members; rows of strangers are warned about."""
    header = find_header(raw, "member")
    if header is None:
        return Joined({}, _no_member_column(raw))
    table = make_table(raw, header, OPTIONAL_SHEETS[name], system)
    by_member: dict[str, Attached] = {}
    for number in table.rows:
        values, problems, bad = table.parse_row(number)
        problems += _gaps(table, number, values, bad)
        problems += _load_in_unit(table, number, values, system) if "type" in values else []
        member = values.pop("member", "")
        attached = by_member.setdefault(member, Attached(table, [], [], table.errors()))
        attached.numbers.append(number)
        attached.values.append(values)
        attached.problems.extend(problems)
    strangers = [by_member.pop(member) for member in by_member.keys() - members]
    return Joined(by_member, table.problems + [p for s in strangers for p in _strange(s, members)])


def _no_member_column(raw: RawSheet) -> list[Problem]:
    if not raw.rows:
        return []
    place = Place(raw.name, address(min(raw.rows), 1), "member")
    cure = "head the names with member if the sheet is meant for ptbatch"
    return [Problem(place, None, "no column member: the sheet is not used", cure, warning=True)]


def _strange(attached: Attached, members: set[str]) -> Iterator[Problem]:
    for number in attached.numbers:
        name = attached.table.raw(number, "member")
        meant = closest(str(name), members)
        cure = f"did you mean {meant}?" if meant else "check the name, or delete the row"
        wrong = "there is no such member; the row is not used"
        yield Problem(attached.table.place(number, "member"), name, wrong, cure, warning=True)


def _gaps(table: Table, number: int, values: Values, bad: set[str]) -> Iterator[Problem]:
    """Values that the row needs and does not have."""
    needed = [column.name for column in table.columns if column.required]
    needed += ["x"] if values.get("type") == "point" else []
    for name in needed:
        if name not in values and name not in bad:
            yield Problem(table.place(number, name), None, "missing", f"give {name}")


def _load_in_unit(table: Table, number: int, values: Values, system: System) -> Iterator[Problem]:
    """Read the value of a load once more, now that its type tells the quantity."""
    found, raw = table.at(number, "value"), table.raw(number, "value")
    if found is None or "value" not in values:
        return
    quantity = {"point": "force", "uniform": "line load"}[values["type"]]
    try:
        unit = found.unit or UNITS[quantity][system == "US"]
        values["value"] = parse(found.column, raw, factor(quantity, unit))
    except UnitError as error:
        cure = "leave the unit out of the header: it is then kN or kip, and for uniform loads kN/m or kip/ft"
        yield Problem(table.place(number, "value"), raw, error.wrong, cure)


def points(attached: Attached, end: float, fy: float) -> tuple[Point, ...]:
    """Points of the tendon from rows of the sheet `profile`."""
    return tuple(Point(row["x"], row["dp"]) for row in attached.values)


def bars(attached: Attached, end: float, fy: float) -> tuple[Bar, ...]:
    """Bars from rows of the sheet `rebar`; by default over the whole member [mm] and of its fy [MPa]."""
    return tuple(
        Bar(row.get("x_start", 0.0), row.get("x_end", end), row["depth"], row["area"], row.get("fy", fy))
        for row in attached.values
    )


def loads(attached: Attached, end: float, fy: float) -> tuple[Load, ...]:
    """Loads from rows of the sheet `loads`; uniform ones go up to the end of the member by default."""
    return tuple(
        Load(
            row["case"],
            row["type"],
            row.get("x", 0.0),
            row["x"] if row["type"] == "point" else row.get("x_end", end),
            row["value"],
        )
        for row in attached.values
    )


BUILDERS: dict[str, tuple[str, Callable[[Attached, float, float], tuple[Any, ...]]]] = {
    "profile": ("profile_points", points),
    "rebar": ("bars", bars),
    "loads": ("loads", loads),
}
