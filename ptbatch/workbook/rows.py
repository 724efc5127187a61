"""From one row of the sheet `members`, with settings and optional sheets, to a member or its problems."""

import re
from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass, replace
from typing import Any

from ptbatch.member import Member, MemberError
from ptbatch.rules.fault import Fault
from ptbatch.validation import member_faults
from ptbatch.workbook.column import System
from ptbatch.workbook.columns import BY_NAME
from ptbatch.workbook.joined import BUILDERS, Attached
from ptbatch.workbook.problems import Place, Problem, message
from ptbatch.workbook.read import Block
from ptbatch.workbook.settings import Setting
from ptbatch.workbook.systems import NEUTRAL, sentence_in
from ptbatch.workbook.table import Table
from ptbatch.workbook.units import is_us

ALTERNATIVES = {"fpj": "fpe", "fpe": "fpj", "K": "k_ec2", "k_ec2": "K"}

Values = dict[str, Any]

_ITEM = re.compile(r"(\w+)\[(\d+)\]\.?(\w*)")
_SHEET_OF = {argument: sheet for sheet, (argument, _) in BUILDERS.items()}


@dataclass(frozen=True)
class Row:
    """One row: its member (None where invalid), its problems, the cells of the unknown columns, its sound
    values by column in N, mm, MPa."""

    number: int
    name: str
    member: Member | None
    problems: list[Problem]
    extra: tuple[Any, ...]
    values: Mapping[str, Any]

    @property
    def message(self) -> str:
        """The first problem and how many more there are; empty if there is none."""
        return message(self.problems) if self.problems else ""


class RowReader:
    """Reads the rows of one workbook.

    attached: rows of the optional sheets by sheet name, then by member. repeated: rows that share a name.
    unnamed: unit system of headers without a unit. system: that of most headers.
    """

    def __init__(
        self,
        table: Table,
        defaults: Mapping[str, Setting],
        attached: Mapping[str, Mapping[str, Attached]],
        repeated: Mapping[str, list[int]],
        errors: list[Problem],
        unnamed: System,
        system: System,
    ) -> None:
        self.table, self.defaults, self.attached = table, defaults, attached
        self.repeated, self.unnamed, self.system = repeated, unnamed, system
        self.errors = errors + table.errors()

    def over(self, block: Block) -> "RowReader":
        """The same for a part of the table."""
        reader = copy(self)
        reader.table = replace(self.table, rows=block)
        return reader

    def read(self, number: int) -> Row:
        """Member or problems of one row."""
        values, problems, bad = self.table.parse_row(number)
        name = values.get("member", "")
        problems = self.errors + problems + self._duplicates(number, name)
        self._take_defaults(number, values, problems, bad)
        attached = {sheet: rows[name] for sheet, rows in self.attached.items() if name in rows}
        self._attach(attached, values, problems, bad)
        member, faults = _member_or_faults(values, bad, bool(problems))
        problems += [self._problem(fault, number, attached) for fault in faults]
        if member is not None:
            problems += [self._problem(fault, number, attached, True) for fault in member.warnings]
        cells = self.table.rows[number]
        extra = tuple(cells.get(index) for index in self.table.others)
        return Row(number, name or f"(row {number})", member, problems, extra, values)

    def _duplicates(self, number: int, name: str) -> list[Problem]:
        others = [other for other in self.repeated.get(name, []) if other != number]
        if not others or not name:
            return []
        place = self.table.place(number, "member")
        elsewhere = self.table.place(others[0], "member").cell
        return [
            Problem(place, name, f"the same name stands in {elsewhere}", "give every member its own name")
        ]

    def _take_defaults(self, number: int, values: Values, problems: list[Problem], bad: set[str]) -> None:
        """Fill blank cells from the settings; of two alternatives the row's own one counts."""
        typed = values.keys() | bad
        for name, setting in self.defaults.items():
            if name in typed or ALTERNATIVES.get(name) in typed:
                continue
            if setting.problem is None:
                values[name] = setting.value
            else:
                problems.append(setting.problem)
                bad.add(name)

    def _attach(
        self, attached: Mapping[str, Attached], values: Values, problems: list[Problem], bad: set[str]
    ) -> None:
        """Turn the member's rows of the optional sheets into its points, bars and loads."""
        end = sum(values.get("span", ()))
        fy = values.get("fy", BY_NAME["fy"].default_value)
        for sheet, rows in attached.items():
            argument, build = BUILDERS[sheet]
            problems += rows.problems
            if rows.problems or "span" not in values:
                bad.add(argument)
            else:
                values[argument] = build(rows, end, fy)

    def _problem(
        self, fault: Fault, number: int, attached: Mapping[str, Attached], warning: bool = False
    ) -> Problem:
        """A fault with its place: the cell, the setting it came from, or the row of an optional sheet."""
        if item := _ITEM.fullmatch(fault.column):
            rows, index = attached[_SHEET_OF[item[1]]], int(item[2])
            table, line, name = rows.table, rows.numbers[index], item[3]
            place, raw = rows.place(index, name), table.raw(line, name)
        else:
            table, line, name = self.table, number, fault.column
            place, raw = self._where(name, line)
        wrong = fault.wrong
        if wrong == "missing" and fault.column not in self.table.found:
            wrong = "there is no such column"
        system = self._system(table, line, name)
        return Problem(place, raw, sentence_in(wrong, system), sentence_in(fault.cure, system), warning)

    def _system(self, table: Table, row: int, name: str) -> System:
        """Unit system that a cell is in; where it is blank or has no unit, that of most headers."""
        found = table.at(row, name)
        if found is None or found.column.unit("SI") in NEUTRAL:
            return self.system
        return "US" if is_us(found.unit or found.column.unit(self.unnamed)) else "SI"

    def _where(self, name: str, number: int) -> tuple[Place, Any]:
        raw = self.table.raw(number, name)
        if raw is None and name in self.defaults:
            return self.defaults[name].place, self.defaults[name].raw
        return self.table.place(number, name), raw


def _member_or_faults(
    values: Mapping[str, Any], bad: set[str], faulty: bool
) -> tuple[Member | None, list[Fault]]:
    """A row that has problems already makes no member, but is searched for more."""
    if faulty or bad:
        return None, member_faults(values, bad)
    try:
        return Member(**values), []
    except MemberError as error:
        return None, error.faults
