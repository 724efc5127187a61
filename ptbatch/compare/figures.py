"""The figures that a published table names, sheet `figures`: one row a figure of the report."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from ptbatch.compare.columns import FIGURES
from ptbatch.compare.table import Fault, Faulty, Values, gaps, open_table, parsed
from ptbatch.workbook.problems import Problem
from ptbatch.workbook.read import RawSheet

SHEET = "figures"


class Figure(NamedTuple):
    """A figure: its file's name, the kind that `ptbatch plot` knows, the members in it, where it stands."""

    name: str
    kind: str
    members: tuple[str, ...]
    caption: str
    case: str


def read_figures(path: Path, raw: RawSheet | None) -> tuple[list[Figure | Faulty], list[Problem]]:
    """The figures in the order of their rows, faulty ones among them, and warnings about the headers; none
    without a sheet. Raises ReadError where a header is faulty."""
    if raw is None:
        return [], []
    table = open_table(path, raw, "figure", FIGURES)
    rows: list[Figure | Faulty] = []
    taken: set[str] = set()
    for number in table.rows:
        values, problems = parsed(table, number, lambda v, bad: _faults(v, bad, taken))
        name = values.get("figure", "")
        taken.add(name.casefold())
        faulty = Faulty(values.get("members", ""), f"figure {name}".strip(), problems)
        rows.append(faulty if problems else _figure(values))
    return rows, table.problems


def _faults(v: Values, bad: set[str], taken: set[str]) -> Iterator[Fault]:
    yield from gaps(FIGURES, v, bad)
    name = v.get("figure", "plain")
    if not re.fullmatch(r"\w[\w.+-]*", name):
        yield "figure", "is no name for a file", "use letters, digits, - and _"
    if name.casefold() in taken:
        yield "figure", "this name is given twice", "give every figure a name of its own"
    if not all(member.strip() for member in v.get("members", "B1").split(";")):
        yield "members", "a name is missing", "give a name on either side of each ;"


def _figure(v: Values) -> Figure:
    members = tuple(member.strip() for member in v["members"].split(";"))
    return Figure(v["figure"], v["kind"], members, v["caption"], v.get("case", members[0]))
