"""The checks by a standard, as a report tells them."""

from typing import Any, NamedTuple

from ptbatch.report.words import Words, digits
from ptbatch.workbook.stored import Stored


class Line(NamedTuple):
    """A check: its name and place, clause, formula with the numbers put in, demand, limit, utilisation,
    outcome, and why."""

    name: str
    clause: str
    formula: str
    numbers: str
    demand: str
    limit: str
    utilisation: str
    outcome: str
    reason: str


def checks(stored: Stored) -> list[Line]:
    """All checks of a member, in the order of the sheet."""
    return [_line(row, Words(stored.system)) for row in stored.checks.rows]


def _line(row: dict[str, Any], words: Words) -> Line:
    x = row["x [mm]"]
    place = f" at x = {words.amount(x / 1e3, 'm')}" if isinstance(x, int | float) else ""
    unit = str(row["unit"] or "").replace("2", "²")
    demand, limit = (_amount(row[name], unit) for name in ("demand", "limit"))
    used = row["utilisation"]
    return Line(
        f"{row['check']}{place}",
        str(row["clause"]),
        str(row["formula"] or ""),
        str(row["numbers"] or ""),
        demand,
        limit,
        f"{used:.2f}" if isinstance(used, int | float) else "\u2013",
        str(row["outcome"]),
        str(row.get("reason") or ""),
    )


def _amount(value: Any, unit: str) -> str:
    return f"{digits(value)} {unit}" if isinstance(value, int | float) else "\u2013"
