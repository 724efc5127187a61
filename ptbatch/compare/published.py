"""Reading a published table: rows to entries, or to what is wrong with them."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from ptbatch.compare.columns import COLUMNS
from ptbatch.compare.cracks import MEASURES
from ptbatch.compare.entry import Entry, Query, Value
from ptbatch.compare.figures import SHEET as FIGURES
from ptbatch.compare.figures import Figure, read_figures
from ptbatch.compare.table import Fault, Faulty, Values, gaps, open_table, parsed
from ptbatch.workbook.cells import CellError, parse
from ptbatch.workbook.column import Column
from ptbatch.workbook.problems import Problem
from ptbatch.workbook.read import LAST_ROW, read_sheets
from ptbatch.workbook.results import CURVES, TENDON
from ptbatch.workbook.table import Table
from ptbatch.workbook.units import parse_header

SHEET = "published"
QUANTITIES = ("quantity", "against_quantity", "share_of")
# What a quantity of these sheets cannot do without.
NEEDS: dict[str, tuple[str, ...]] = {
    **{parse_header(header).name: ("stage", "x") for header in TENDON[2:]},
    **{parse_header(header).name: ("deflection",) for header in CURVES[1:]},
    **dict.fromkeys(MEASURES, ("stage",)),
}
_NUMBER = Column("value", "a number", limit="any")


class Published(NamedTuple):
    """A published table in the order of its rows, entries and figures, with the faulty ones among them.
    warnings concern its headers."""

    rows: list[Entry | Faulty]
    figures: list[Figure | Faulty]
    warnings: list[Problem]


def read_published(path: Path) -> Published | None:
    """Read the sheet `published`, or the first sheet, and `figures`; None if the file is a results workbook
    instead.

    Raises ReadError where there is nothing to compare with.
    """
    sheets = read_sheets(path, SHEET, ["summary", FIGURES], most_rows=LAST_ROW)
    raw = sheets[SHEET]
    if "summary" in sheets and raw.name.casefold() != SHEET:
        return None
    table = open_table(path, raw, "member", COLUMNS, needed=("value",))
    figures, warnings = read_figures(path, sheets.get(FIGURES))
    return Published([_row(table, number) for number in table.rows], figures, table.problems + warnings)


def _row(table: Table, number: int) -> Entry | Faulty:
    values, problems = parsed(table, number, _faults)
    if problems:
        return Faulty(values.get("member", ""), values.get("quantity", ""), problems)
    return _entry(values, table.raw(number, "value"))


def _faults(v: Values, bad: set[str]) -> Iterator[Fault]:
    """Every fault of a row that its single cells do not show."""
    yield from gaps(COLUMNS, v, bad)
    if "value" not in v and "value" not in bad and "not_reproducible" not in v:
        yield "value", "missing", "give the expected number, or say under not_reproducible why there is none"
    yield from _needs(v, bad)
    yield from _comparison(v, bad)


def _needs(v: Values, bad: set[str]) -> Iterator[Fault]:
    for name in QUANTITIES:
        quantity = parse_header(v.get(name, "")).name
        for need in NEEDS.get(quantity, ()):
            if need not in v and need not in bad:
                yield need, "missing", f"give {need}: {quantity} is looked up by it"


def _comparison(v: Values, bad: set[str]) -> Iterator[Fault]:
    other = [name for name in ("against", "against_quantity", "against_x") if name in v]
    if "as" in bad:
        return
    how = v.get("as", "value")
    if how == "value" and other:
        yield "as", f"{other[0]} is given, but not what is made of it", "give ratio or difference"
    if how != "value" and not other:
        yield "against", "missing", "give the other member, against_quantity or against_x"
    if how != "difference" and "share_of" in v:
        yield "share_of", "is for differences alone", "give difference under as, or leave share_of blank"


def _entry(v: Values, raw: Any) -> Entry:
    of = Query(v["member"], v["quantity"], v.get("stage"), v.get("x"), v.get("deflection"))
    against = base = None
    if v.get("as", "value") != "value":
        against = of._replace(
            member=v.get("against", of.member),
            quantity=v.get("against_quantity", of.quantity),
            x=v.get("against_x", of.x),
        )
        base = against._replace(quantity=v["share_of"]) if "share_of" in v else None
    return Entry(
        case=v.get("case", of.member),
        of=of,
        value=None if raw is None else _value(raw),
        source=v["source"],
        kind=v["class"].replace("-", " "),
        how=v.get("as", "value"),
        against=against,
        base=base,
        bound=v.get("bound", "equal").replace("-", " "),
        rtol=v.get("rtol"),
        atol=v.get("atol"),
        not_reproducible=v.get("not_reproducible", ""),
        note=v.get("note", ""),
    )


def _value(raw: Any) -> Value:
    """A number wherever it is one."""
    try:
        return float(parse(_NUMBER, raw))
    except CellError:
        return str(raw).strip()
