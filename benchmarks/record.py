"""The results that the repository keeps: one section a table, with its date."""

from collections.abc import Sequence
from datetime import date
from pathlib import Path

from benchmarks.machine import machine
from benchmarks.table import Table

RESULTS = Path(__file__).with_name("results.md")
HEAD = """# Speed

Written by `python -m benchmarks.speed --write`, which says what is measured; the least of several times.

{machine}

"""


class OtherMachineError(Exception):
    """The tables that stay were measured on something else."""


def write_results(tables: Sequence[Table], everything: bool) -> None:
    """Put tables in place of those with the same title, or of all."""
    head = HEAD.format(machine=machine())
    sections = {} if everything else _sections(head)
    for table in tables:
        sections[table.title] = f"{table.markdown()}\n\n*{date.today().isoformat()}*\n"
    RESULTS.write_text(head + "\n".join(sections.values()), encoding="utf-8")


def _sections(head: str) -> dict[str, str]:
    """The tables that are there, by title."""
    if not RESULTS.exists():
        return {}
    text = RESULTS.read_text(encoding="utf-8")
    if not text.startswith(head):
        raise OtherMachineError("the tables there are of another machine or version: measure all of them")
    parts = text.removeprefix(head).split("## ")[1:]
    return {part.partition("\n")[0]: f"## {part.rstrip()}\n" for part in parts}
