"""Every column of input and results as a page of the documentation."""

from collections.abc import Iterator, Sequence

from ptbatch.workbook.column import LIMITS, Column
from ptbatch.workbook.columns import MEMBERS
from ptbatch.workbook.legend import MEANINGS
from ptbatch.workbook.optional import OPTIONAL_SHEETS
from ptbatch.workbook.results import DETAILS, HEAD, SUMMARY
from ptbatch.workbook.site import SHEET, site_headers
from ptbatch.workbook.systems import headers_in
from ptbatch.workbook.units import QUANTITIES, parse_header

PAGE = "docs/columns.md"
INTRODUCTION = """# Every column

Written by `python -m examples.build`. A header is `name` or `name [unit]`; without a unit the one below
holds, that of the US if the sheet `settings` says `units` = `US`. Columns may stand in any order; unknown
ones are kept, and warned about. A list has `;` between its numbers.
"""


def columns_page() -> str:
    """The page."""
    return "\n".join([INTRODUCTION, *_input(), *_units(), *_results()]) + "\n"


def _table(heads: Sequence[str], rows: Iterator[Sequence[str]]) -> Iterator[str]:
    yield f"| {' | '.join(heads)} |"
    yield "|" + "---|" * len(heads)
    for row in rows:
        yield f"| {' | '.join(cell.replace('|', '/') for cell in row)} |"
    yield ""


def _input() -> Iterator[str]:
    yield "## Input: sheet `members`\n"
    yield from _table(("column", "SI, US", "meaning", "allowed", "default", "source"), map(_line, MEMBERS))
    for name, columns in OPTIONAL_SHEETS.items():
        yield f"## Input: optional sheet `{name}`\n"
        yield from _table(
            ("column", "SI, US", "meaning", "allowed", "default", "source"), map(_line, columns)
        )


def _line(column: Column) -> tuple[str, ...]:
    units = [unit for unit in (column.unit("SI"), column.unit("US")) if unit != "-"]
    numbers = column.kind in ("number", "integer", "list", "integers")
    allowed = ", ".join(column.choices) or (LIMITS[column.limit][1] if numbers else column.kind)
    unit = ", ".join(dict.fromkeys(units)) or "-"
    return f"`{column.name}`", unit, column.meaning, allowed, column.default_text, column.source or "-"


def _units() -> Iterator[str]:
    yield "## Units that a header may name\n"
    kinds = ((quantity, ", ".join(units)) for quantity, units in QUANTITIES.items() if len(units) > 1)
    yield from _table(("quantity", "units"), kinds)


def _results() -> Iterator[str]:
    sheets = {"summary": (*HEAD, *SUMMARY), **DETAILS, SHEET: site_headers("SI")}
    for name, headers in sheets.items():
        yield f"## Results: sheet `{name}`\n"
        pairs = zip(headers, headers_in(headers, "US"), strict=True)
        yield from _table(("column", "SI, US", "meaning"), (_meaning(name, *pair) for pair in pairs))


def _meaning(sheet: str, si: str, us: str) -> tuple[str, ...]:
    (name, unit), other = parse_header(si), parse_header(us).unit
    return f"`{name}`", ", ".join(dict.fromkeys(filter(None, (unit, other)))) or "-", MEANINGS[sheet][name]
