"""What a results workbook says of its run, and of the faults in its input."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePath, PureWindowsPath
from typing import Any, BinaryIO

from ptbatch.workbook.read import guarded, open_book
from ptbatch.workbook.stored import BOUNDS

ROW = re.compile(r"(?P<sheet>[^!]+)!(?:[A-Z]+|(?:line|row) )(?P<row>\d+)")
PLACE = re.compile(r" in (?P<place>[^!]+![^:]+):")


@dataclass(frozen=True)
class Source:
    """The sheets `run`, by name, and `problems`, without its header."""

    run: Mapping[str, Any]
    problems: Sequence[tuple[Any, ...]]

    def about(self) -> dict[str, str]:
        """The title block: what was run, when, by which version; a path by its name alone."""
        name = str(self.run.get("input", ""))
        file = PureWindowsPath(name).name if "\\" in name else PurePath(name).name
        told = {
            "Input": file,
            "SHA-256 of the input": self.run.get("input sha256"),
            "Analysed": self.run.get("started"),
            "Program": f"ptbatch {self.run.get('ptbatch', '')}".strip(),
        }
        return {title: str(value or "not in the results") for title, value in told.items()}

    def faults(self, message: str) -> list[tuple[str, ...]]:
        """The lines of `problems` that stand in the same row as the first one, which the message of a member
        names: column, cell, value, what is wrong, how to put it right."""
        found = PLACE.search(message)
        row = _row(found["place"]) if found else None
        lines = [line for line in self.problems if row and _row(f"{line[0]}!{line[1]}") == row]
        return [tuple("" if cell is None else str(cell) for cell in (*line[2:3], line[1], *line[3:6]))
                for line in lines]  # fmt: skip


def _row(place: str) -> tuple[str, str] | None:
    """Sheet and row of `members!F7`."""
    found = ROW.match(place)
    return (found["sheet"], found["row"]) if found else None


def read_source(path: Path) -> Source:
    """What a results workbook says of itself. Raises ReadError."""
    return guarded(path, _read, BOUNDS)


def _read(file: BinaryIO) -> Source:
    book = open_book(file)
    run = {str(row[0]): row[1] for row in _lines(book, "run") if len(row) > 1}
    return Source(run, [row for row in _lines(book, "problems")[1:] if len(row) >= 6])


def _lines(book: Any, name: str) -> list[tuple[Any, ...]]:
    return list(book[name].iter_rows(values_only=True)) if name in book.sheetnames else []
