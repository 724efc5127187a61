"""A large workbook is read by a second process while the first one loads what an analysis needs: either takes
most of a second for a thousand members, and threads would wait for each other.
"""

import os
import pickle
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ptbatch.workbook.read import RawSheet

LARGE = 200_000  # bytes; a smaller one is read before a process has started


class ReadAhead:
    """The raw sheets of a workbook, on their way. Whatever becomes of the second process, and where none is
    started, this one reads them."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._process: subprocess.Popen[bytes] | None = None
        with suppress(OSError):
            if self._is_worth_it():
                # -P: a file in the working folder is not to be taken for a module
                command = [sys.executable, "-P", "-m", "ptbatch.workbook.read_ahead", str(path)]
                quiet = subprocess.DEVNULL
                self._process = subprocess.Popen(command, stdin=quiet, stdout=subprocess.PIPE, stderr=quiet)

    def _is_worth_it(self) -> bool:
        large = self._path.suffix.lower() == ".xlsx" and self._path.stat().st_size > LARGE
        return large and (os.cpu_count() or 1) > 1 and bool(sys.executable)

    @property
    def under_way(self) -> bool:
        """Whether a second process is reading."""
        return self._process is not None

    def sheets(self) -> "dict[str, RawSheet]":
        """The sheets as of `raw_sheets`. Raises ReadError."""
        return self._sent() or raw_sheets(self._path)

    def _sent(self) -> "dict[str, RawSheet] | None":
        """What the second process has sent; None if it has not."""
        process, self._process = self._process, None
        if process is None:
            return None
        assert process.stdout is not None  # it is a pipe
        sheets: dict[str, RawSheet] | None = None
        with process, suppress(Exception):
            sheets = pickle.load(process.stdout)
        return sheets if process.returncode == 0 else None


def raw_sheets(path: Path) -> "dict[str, RawSheet]":
    """The sheets that concern members, by name. Raises ReadError."""
    from ptbatch.workbook.optional import MAIN, OPTIONAL_SHEETS
    from ptbatch.workbook.read import read_sheets

    return read_sheets(path, MAIN, [*OPTIONAL_SHEETS, "settings"])


if __name__ == "__main__":
    pickle.dump(raw_sheets(Path(sys.argv[1])), sys.stdout.buffer, pickle.HIGHEST_PROTOCOL)
