"""What is said at the end of a run: its rows, those that did not pass first, and what came of them."""

from collections.abc import Iterator, Sequence
from itertools import chain, islice
from typing import TYPE_CHECKING, Any

from ptbatch.workbook.units import parse_header

if TYPE_CHECKING:
    from ptbatch.batch import Batch

PASSED = ("ok", "warning")
SHOWN_ROWS = 40
SHOWN = ("member", "status", "load_peak", "failure", "message")


def closing_table(batch: "Batch") -> list[str]:
    """Member, status, peak load and how it ended; then where the results are."""
    names = [parse_header(header).name for header in batch.headers]
    columns = [names.index(name) for name in SHOWN]
    unit = parse_header(batch.headers[columns[2]]).unit
    rows = [_row(*line) for line in islice(_by_concern(batch, columns), SHOWN_ROWS)]
    table = [("member", "status", f"peak [{unit}]", "end"), *rows]
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    lines = ["  ".join(text.ljust(w) for text, w in zip(row, widths, strict=True)).rstrip() for row in table]
    if len(batch.lines) > SHOWN_ROWS:
        lines.append(f"... and {len(batch.lines) - SHOWN_ROWS} more rows")
    return [*lines, *_results(batch)]


def _results(batch: "Batch") -> Iterator[str]:
    if batch.path != batch.wanted:
        yield f"{batch.wanted} is in use and could not be replaced"
    if batch.known:
        yield f"{batch.known} rows from the journal of an earlier run"
    if batch.tables:
        yield f"long tables: {batch.tables}"
    counts = ", ".join(f"{count} {status}" for status, count in batch.counts.items() if count)
    yield f"{counts}; results: {batch.path}"
    if batch.interrupted:
        yield "interrupted: the same command with --resume analyses the rows that are missing"


def _by_concern(batch: "Batch", columns: Sequence[int]) -> Iterator[list[Any]]:
    """What is shown of the rows, those first that did not pass."""
    failed = (line for line in batch.lines if line[1] not in PASSED)
    first = list(islice(failed, SHOWN_ROWS))
    passed = (line for line in batch.lines if line[1] in PASSED)
    return ([line[i] for i in columns] for line in chain(first, passed))


def _row(member: str, status: str, peak: Any, failure: Any, message: str) -> tuple[str, ...]:
    """A row that did not pass, or failed before its live load, has no peak, and its message says why."""
    has_peak = isinstance(peak, float)
    end = "; ".join(str(text) for text in (failure if has_peak else "", message) if text)
    return _short(member, 30), status, f"{peak:9.1f}" if has_peak else "-".rjust(9), _short(end, 100)


def _short(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 3] + "..."
