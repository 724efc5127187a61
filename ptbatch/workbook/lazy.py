"""Rows that are read and validated whenever they are walked through, so that a large table is never held."""

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import Any

from ptbatch.workbook.read import Block
from ptbatch.workbook.rows import Row, RowReader

Blocks = Callable[[], Iterator[Block]]  # the table from its start, some rows at a time


class Rows(Sequence[Row]):
    """Rows of a table in their order."""

    def __init__(self, reader: RowReader, blocks: Blocks, count: int) -> None:
        self._reader, self._blocks, self._count = reader, blocks, count

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Row]:
        for block in self._blocks():
            reader = self._reader.over(block)
            yield from map(reader.read, block)

    def __getitem__(self, place: Any) -> Any:
        """One row, or several by a slice; the rows before them are read as well."""
        if isinstance(place, slice):
            return list(self)[place]
        index = range(self._count)[place]
        return next(islice(self, index, None))
