"""Lines that are looked at once more at the end of a run: they wait on disk, not in memory."""

import json
from collections.abc import Iterator, Sequence
from tempfile import TemporaryFile
from typing import Any

from ptbatch.workbook.sayable import sayable


class Lines:
    """Lines in their order, as often as they are asked for; dates come back as texts."""

    def __init__(self) -> None:
        self._file = TemporaryFile("w+", encoding="utf-8")
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[list[Any]]:
        self._file.seek(0)
        return map(json.loads, self._file)

    def add(self, line: Sequence[Any]) -> None:
        """Add a line."""
        self._file.write(json.dumps(list(map(sayable, line)), default=str) + "\n")
        self._count += 1
