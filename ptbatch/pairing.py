"""Rows with their outcomes, in the order of the input, from whoever analyses them.

Members are fed as they are read and asked for, so that neither rows nor outcomes pile up. Rows that need no
analysis (invalid, known from the journal, not reached) wait for their turn.
"""

from collections import deque
from collections.abc import Iterable, Iterator
from threading import Event
from typing import NamedTuple

from ptbatch.journal.journal import Journal
from ptbatch.member import Member
from ptbatch.runner import STOPPED, Outcomes, not_analysed
from ptbatch.workbook.results import Outcome
from ptbatch.workbook.rows import Row

MOST_SETTLED = 1_000  # rows that wait and need no analysis: then the others are waited for

Pair = tuple[Row, Outcome | None]


class Waiting(NamedTuple):
    """A row that was read; fed: whether its outcome is on its way. key: of its outcome in the journal."""

    row: Row
    fed: bool
    key: bytes | None = None


class Pairing:
    """Walks through the rows once. The outcome of an invalid row is None."""

    def __init__(self, rows: Iterable[Row], outcomes: Outcomes, journal: Journal, stop: Event) -> None:
        self._rows, self._outcomes, self._journal, self._stop = iter(rows), outcomes, journal, stop
        self._waiting: deque[Waiting] = deque()
        self._settled = 0
        self._exhausted = False

    def __iter__(self) -> Iterator[Pair]:
        while not self._exhausted:
            for outcome in self._outcomes(self._feed()):
                yield from self._settled_pairs()
                row = self._waiting.popleft().row
                assert row.member is not None  # or else it would not have been fed
                self._journal.add(row.member, outcome)
                yield row, outcome
            yield from self._settled_pairs()

    def _feed(self) -> Iterator[Member]:
        """Members to be analysed, up to the end or until too many rows wait that need no analysis."""
        for row in self._rows:
            waiting = self._judge(row)
            self._waiting.append(waiting)
            if waiting.fed:
                assert row.member is not None
                yield row.member
            else:
                self._settled += 1
                if self._settled >= MOST_SETTLED:
                    return
        self._exhausted = True

    def _judge(self, row: Row) -> Waiting:
        if row.member is None:
            return Waiting(row, False)
        key = self._journal.key(row.member)
        return Waiting(row, key is None and not self._stop.is_set(), key)

    def _settled_pairs(self) -> Iterator[Pair]:
        """The rows in front that need no analysis."""
        while self._waiting and not self._waiting[0].fed:
            row, _, key = self._waiting.popleft()
            self._settled -= 1
            if row.member is None:
                yield row, None
            else:
                yield row, not_analysed(STOPPED) if key is None else self._journal.read(key)
