"""A results workbook read back: values by member, looked up by quantity."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from operator import itemgetter
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ptbatch.compare.cracks import MEASURES, measure
from ptbatch.compare.entry import Query, Value
from ptbatch.errors import ReadError
from ptbatch.validation import likely
from ptbatch.workbook.read import LAST_ROW, RawSheet, read_sheets
from ptbatch.workbook.systems import times, written
from ptbatch.workbook.table import find_header
from ptbatch.workbook.units import Header, parse_header

KEYS = {  # to find a value by
    "summary": ("member",),
    "tendon": ("stage", "x"),
    "curves": ("deflection",),
    "cracks": ("stage", "x", "crack_from", "crack_to"),
}

Row = dict[str, Any]


class NoValueError(Exception):
    """Nothing among the results answers a query; the message says why."""


class Reading(NamedTuple):
    """A value in the unit of the results."""

    value: Value
    unit: str


@dataclass(frozen=True)
class ResultSheet:
    """A sheet of results in SI units: headers, and rows by member and then by header, under their folded
    names (as typed where a name stands there twice)."""

    headers: dict[str, Header]
    rows: dict[str, list[Row]]


@dataclass(frozen=True)
class Results:
    """A results workbook: the sheets asked for that it has."""

    path: Path
    sheets: dict[str, ResultSheet]

    @property
    def summary(self) -> ResultSheet:
        """One row a member."""
        return self.sheets["summary"]

    def look_up(self, query: Query) -> Reading:
        """Value of a quantity of `summary`, `tendon` or `curves`, or of a measure of the cracks. Raises
        NoValueError."""
        if query.member not in self.summary.rows:
            cure = likely(query.member, self.summary.rows)
            raise NoValueError(f"the results have no member {query.member}; {cure}")
        name = query.name.casefold()
        for title, sheet in self.sheets.items():
            if name in sheet.headers:
                value = _LOOK_UP[title](sheet.rows.get(query.member, []), name, query)
                return Reading(value, sheet.headers[name].unit)
        known = [header.name for sheet in self.sheets.values() for header in sheet.headers.values()]
        raise NoValueError(f"the results have no quantity {query.name}; {likely(query.name, known)}")


def read_results(path: Path, others: Iterable[str] = ("tendon", "curves", "cracks")) -> Results:
    """Read `summary` and other sheets of a results workbook. Raises ReadError."""
    raw = read_sheets(path, "summary", others, most_rows=LAST_ROW)
    summary = raw["summary"]
    if summary.name.casefold() != "summary" or find_header(summary, "member") is None:
        raise ReadError(f"{path}: no sheet summary; give a results workbook, as `ptbatch run` writes it")
    sheets = {name: _sheet(sheet) for name, sheet in raw.items()}
    for name, sheet in sheets.items():
        for key in KEYS[name]:
            if sheet.headers and key not in sheet.headers:
                raise ReadError(
                    f"{path}: sheet {name} has no column {key}; compare results as they were written"
                )
    if "cracks" in sheets:
        headers = {name: Header(name, made.unit) for name, made in MEASURES.items()}
        sheets["cracks"] = ResultSheet(headers, sheets["cracks"].rows)
    return Results(path, sheets)


def _sheet(raw: RawSheet) -> ResultSheet:
    top = find_header(raw, "member")
    if top is None:
        return ResultSheet({}, {})
    headers: dict[str, Header] = {}
    columns: dict[int, tuple[str, float]] = {}
    for i, text in raw.rows[top].items():
        in_si, factor = written(str(text), "SI")
        header = parse_header(in_si)
        name = str(text) if header.name.casefold() in headers else header.name.casefold()
        columns[i], headers[name] = (name, factor), header
    rows: dict[str, list[Row]] = {}
    for number, cells in raw.rows.items():
        if number > top:
            row = {name: times(cells.get(i), factor) for i, (name, factor) in columns.items()}
            rows.setdefault(str(row["member"]).strip(), []).append(row)
    return ResultSheet(headers, rows)


def as_value(cell: Any) -> Value:
    """A cell as number or text, blank ones as an empty text."""
    return cell if _is_number(cell) else "" if cell is None else str(cell)


def _is_number(cell: Any) -> bool:
    return isinstance(cell, int | float) and not isinstance(cell, bool)


def _of_summary(rows: list[Row], name: str, query: Query) -> Value:
    return as_value(rows[0][name])


def _of_tendon(rows: list[Row], name: str, query: Query) -> float:
    """Interpolated between the tendon elements and anchors of a stage."""
    if query.x is None or query.stage is None:
        raise NoValueError(f"{query.name} needs stage and x")
    at = [(row["x"], row[name]) for row in rows if row["stage"] == query.stage and _is_number(row["x"])]
    if not at:
        raise NoValueError(f"the sheet tendon has no stage {query.stage} of {query.member}")
    x, values = zip(*sorted(at, key=itemgetter(0)), strict=True)
    if not all(map(_is_number, values)):
        raise NoValueError(f"the sheet tendon has no {query.name} at the stage {query.stage}")
    if not x[0] <= query.x <= x[-1] * (1.0 + 1e-9):
        raise NoValueError(f"x = {query.x:g} mm lies beyond the member, which ends at {x[-1]:g} mm")
    return float(np.interp(query.x, x, values))


def _of_curves(rows: list[Row], name: str, query: Query) -> float:
    """Interpolated where the deflection first comes to that of the query; it may go back later."""
    if query.deflection is None:
        raise NoValueError(f"{query.name} needs deflection")
    rows = [row for row in rows if _is_number(row[name]) and _is_number(row["deflection"])]
    if not rows:
        raise NoValueError(f"the sheet curves has no {query.name} of {query.member}")
    for before, after in zip(rows, rows[1:], strict=False):
        ends = before["deflection"], after["deflection"]
        if min(ends) <= query.deflection <= max(ends):
            order = np.argsort(ends)
            values = np.array([before[name], after[name]])
            return float(np.interp(query.deflection, np.array(ends)[order], values[order]))
    furthest = max(row["deflection"] for row in rows)
    raise NoValueError(f"the curve goes to {furthest:.6g} mm, not to {query.deflection:.6g} mm")


def _of_cracks(rows: list[Row], name: str, query: Query) -> float:
    """Made of all cracks of a stage."""
    if query.stage is None:
        raise NoValueError(f"{query.name} needs stage")
    rows = [row for row in rows if row["stage"] == query.stage]
    if not rows:
        raise NoValueError(f"the sheet cracks has no cracks of {query.member} at the stage {query.stage}")
    x, top, bottom = np.array([[row[key] for key in KEYS["cracks"][1:]] for row in rows]).T
    return measure(name, x, top, bottom)


_LOOK_UP: dict[str, Callable[[list[Row], str, Query], Value]] = {
    "summary": _of_summary,
    "tendon": _of_tendon,
    "curves": _of_curves,
    "cracks": _of_cracks,
}
