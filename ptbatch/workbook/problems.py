"""What is reported to the user, with its place in the workbook."""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple


class Place(NamedTuple):
    """Where something stands: sheet, cell such as F7, and the header as typed."""

    sheet: str
    cell: str
    column: str


class Problem(NamedTuple):
    """One line of the sheet `problems`. value: the cell as typed."""

    place: Place
    value: Any
    wrong: str
    cure: str
    warning: bool = False

    def row(self) -> tuple[Any, ...]:
        """The line: sheet, cell, column, value, what is wrong, how to put it right."""
        value = "blank" if self.value is None else self.value
        return *self.place, value, f"warning: {self.wrong}" if self.warning else self.wrong, self.cure

    def __str__(self) -> str:
        sheet, cell, column = self.place
        value = "" if self.value is None else f" = {self.value}"
        kind = "warning: " if self.warning else ""
        return f"{sheet}!{cell}  {column}{value}: {kind}{self.wrong}; {self.cure}"


def message(problems: list[Problem]) -> str:
    """One line for a row: its first problem and how many more there are."""
    first = problems[0]
    more = f" (and {len(problems) - 1} more, see the sheet problems)" if len(problems) > 1 else ""
    return f"{first.place.column} in {first.place.sheet}!{first.place.cell}: {first.wrong}{more}"


class Listed:
    """Remembers which problems were listed: one of a header or a setting turns up again with every row.

    Of each problem its hash alone is kept, so that this stays small beside a long table.
    """

    def __init__(self) -> None:
        self._hashes: set[int] = set()

    def new(self, problems: Iterable[Problem]) -> Iterator[Problem]:
        """Those that were not listed before."""
        for problem in problems:
            before = len(self._hashes)
            self._hashes.add(hash(problem))
            if len(self._hashes) > before:
                yield problem
