"""What is said while a run is under way: a line that is rewritten on a terminal, one per row if wanted."""

from collections import deque
from collections.abc import Callable, Sequence
from shutil import get_terminal_size
from time import perf_counter
from typing import Any

from ptbatch.core.cache import is_warm
from ptbatch.workbook.results import HEAD, SUMMARY

WINDOW = 200  # rows whose mean pace tells the time left
OFTEN = 0.1  # s between two states of the line
CLEAR = "\r\x1b[K"
_TIME = len(HEAD) + SUMMARY.index("time [ms]")


class Meter:
    """Rows done, pace, time left and the row just done, told through `write`.

    terminal: whether a line can be rewritten. verbose: whether each row gets a line that stays.
    """

    def __init__(
        self,
        write: Callable[[str], None],
        terminal: bool,
        verbose: bool = False,
        clock: Callable[[], float] = perf_counter,
    ) -> None:
        self._write, self._terminal, self._verbose, self._clock = write, terminal, verbose, clock
        self._ticks = deque([(clock(), 0)], WINDOW)
        self._shown = 0.0
        if terminal:
            write("analysing" if is_warm() else "compiling (first run only)")

    def __call__(self, done: int, total: int, line: Sequence[Any]) -> None:
        """A row is done: line is its line of the summary."""
        now = self._clock()
        self._ticks.append((now, done))
        if self._verbose:
            self._write(f"{CLEAR if self._terminal else ''}{row_line(done, total, line)}\n")
        if self._terminal and (done == total or now - self._shown >= OFTEN):
            self._shown = now
            self._write(f"{CLEAR}{self._state(done, total, line[0])[: get_terminal_size().columns - 1]}")
        if self._terminal and done == total:
            self._write("\n")

    def _state(self, done: int, total: int, member: str) -> str:
        (start, before), (now, _) = self._ticks[0], self._ticks[-1]
        pace = (done - before) / max(now - start, 1e-6)
        left = f"{duration((total - done) / pace)} left" if done < total else "all done"
        return f"{done} of {total}  {pace:.3g}/s  {left}  {printable(member)}"


def row_line(done: int, total: int, line: Sequence[Any]) -> str:
    """A row that is done: its status, its time where it was analysed, its message."""
    member, status, message = line[: len(HEAD)]
    time = line[_TIME]
    spent = f"  {time:.0f} ms" if isinstance(time, float) else ""
    said = f"  {printable(message)}" if message else ""
    return f"{done} of {total}  {printable(member)}  {status}{spent}{said}"


def duration(seconds: float) -> str:
    """`45 s`, `3:20 min`, `2:05 h`."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    return (
        f"{whole // 60}:{whole % 60:02} min" if whole < 3600 else f"{whole // 3600}:{whole // 60 % 60:02} h"
    )


def printable(text: Any) -> str:
    """A text that cannot move the cursor."""
    return "".join(letter if letter.isprintable() else " " for letter in str(text))
