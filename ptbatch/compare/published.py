"""Reading a published table: rows to entries, or to what is wrong with them."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from ptbatch.compare.columns import COLUMNS
from ptbatch.compare.entry import Entry, Query, Value
from ptbatch.errors import ReadError
from ptbatch.validation import checked
from ptbatch.workbook.cells import CellError, parse
from ptbatch.workbook.column import Column
from ptbatch.workbook.problems import Problem
from ptbatch.workbook.read import LAST_ROW, RawSheet, read_sheets
from ptbatch.workbook.results import CURVES, TENDON
from ptbatch.workbook.table import Table, find_header, make_table
from ptbatch.workbook.units import parse_header

SHEET = "published"
NEEDED = ("value",)  # besides the required columns; a cell of it may be blank
# What a quantity of these sheets cannot do without.
NEEDS = {
    **{parse_header(header).name: ("stage", "x") for header in TENDON[2:]},
    **{parse_header(header).name: ("deflection",) for header in CURVES[1:]},
}

Values = dict[str, Any]
_NUMBER = Column("value", "a number", limit="any")


class Published(NamedTuple):
    """A published table in the order of its rows: an entry each, or the member, the quantity and the problems
    of a faulty one. warnings concern its headers."""

    rows: list[Entry | tuple[str, str, list[Problem]]]
    warnings: list[Problem]


def read_published(path: Path) -> Published | None:
    """Read the sheet `published`, or the first sheet; None if the file is a results workbook instead.

    Raises ReadError where there is nothing to compare with.
    """
    sheets = read_sheets(path, SHEET, ["summary"], most_rows=LAST_ROW)
    raw = sheets[SHEET]
    if "summary" in sheets and raw.name.casefold() != SHEET:
        return None
    table = _table(path, raw)
    return Published([_row(table, number) for number in table.rows], table.problems)


def _table(path: Path, raw: RawSheet) -> Table:
    """Its headers are sound: a faulty one would concern every row."""
    top = find_header(raw, "member")
    if top is None:
        cure = "give a published table, or a results workbook"
        raise ReadError(f"{path}: sheet {raw.name} has no column member; {cure}")
    table = make_table(raw, top, COLUMNS, "SI")
    faults = [str(problem) for problem in table.errors()]
    for column in COLUMNS:
        if (column.required or column.name in NEEDED) and column.name not in table.found:
            sheet, cell, name = table.place(top, column.name)
            faults.append(f"{sheet}!{cell}  {name}: there is no such column; give {column.meaning}")
    if faults:
        raise ReadError(f"{path}:\n" + "\n".join(faults))
    if not table.rows:
        raise ReadError(f"{path}: sheet {raw.name} has no rows below its headers; add one per number")
    return table


def _row(table: Table, number: int) -> Entry | tuple[str, str, list[Problem]]:
    values, problems, bad = table.parse_row(number)
    problems += [
        Problem(table.place(number, name), table.raw(number, name), wrong, cure)
        for name, wrong, cure in _faults(values, bad)
    ]
    if problems:
        return values.get("member", ""), values.get("quantity", ""), problems
    return _entry(values, table.raw(number, "value"))


def _faults(v: Values, bad: set[str]) -> Iterator[tuple[str, str, str]]:
    """Column, what is wrong and the cure, for every fault of a row that its single cells do not show."""
    for column in COLUMNS:
        if column.required and column.name not in v and column.name not in bad:
            yield column.name, "missing", f"give {column.name}: {column.meaning}"
        elif column.kind == "number" and column.name in v:
            _, wrong = checked(column, v[column.name])
            if wrong:
                yield column.name, *wrong
    if "value" not in v and "value" not in bad and "not_reproducible" not in v:
        yield "value", "missing", "give the expected number, or say under not_reproducible why there is none"
    yield from _needs(v, bad)
    yield from _comparison(v, bad)


def _needs(v: Values, bad: set[str]) -> Iterator[tuple[str, str, str]]:
    for name in ("quantity", "against_quantity"):
        quantity = parse_header(v.get(name, "")).name
        for need in NEEDS.get(quantity, ()):
            if need not in v and need not in bad:
                yield need, "missing", f"give {need}: {quantity} is looked up by it"


def _comparison(v: Values, bad: set[str]) -> Iterator[tuple[str, str, str]]:
    other = [name for name in ("against", "against_quantity", "against_x") if name in v]
    if "as" in bad:
        return
    if v.get("as", "value") == "value" and other:
        yield "as", f"{other[0]} is given, but not what is made of it", "give ratio or difference"
    if v.get("as", "value") != "value" and not other:
        yield "against", "missing", "give the other member, against_quantity or against_x"


def _entry(v: Values, raw: Any) -> Entry:
    of = Query(v["member"], v["quantity"], v.get("stage"), v.get("x"), v.get("deflection"))
    against = None
    if v.get("as", "value") != "value":
        against = of._replace(
            member=v.get("against", of.member),
            quantity=v.get("against_quantity", of.quantity),
            x=v.get("against_x", of.x),
        )
    figures = (name.strip() for name in v.get("figures", "").split(";"))
    return Entry(
        case=v.get("case", of.member),
        of=of,
        value=None if raw is None else _value(raw),
        source=v["source"],
        kind=v["class"].replace("-", " "),
        how=v.get("as", "value"),
        against=against,
        bound=v.get("bound", "equal").replace("-", " "),
        rtol=v.get("rtol"),
        atol=v.get("atol"),
        not_reproducible=v.get("not_reproducible", ""),
        figures=tuple(name for name in figures if name),
        note=v.get("note", ""),
    )


def _value(raw: Any) -> Value:
    """A number wherever it is one."""
    try:
        return float(parse(_NUMBER, raw))
    except CellError:
        return str(raw).strip()
