"""Lines of a comparison as a table for the terminal, a sheet and records for JSON."""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from ptbatch.compare.entry import FAIL, NOT_REPRODUCIBLE, PASS, Line, Value
from ptbatch.workbook.sayable import sayable
from ptbatch.workbook.write import Sheet

HEADERS = (
    *("case", "member", "quantity", "ours", "theirs", "unit", "ratio", "tolerance", "verdict", "because"),
    *("class", "source", "note"),
)
VERDICTS = (PASS, FAIL, NOT_REPRODUCIBLE)
_TITLES = ("verdict", "member", "quantity", "ours", "theirs", "tolerance")


def counts(lines: Sequence[Line]) -> dict[str, int]:
    """How many lines of each verdict."""
    tally = Counter(line.verdict for line in lines)
    return {verdict: tally[verdict] for verdict in VERDICTS}


def sheet(lines: Sequence[Line]) -> Sheet:
    """The sheet `comparison`."""
    return Sheet("comparison", HEADERS, [_cells(line) for line in lines])


def records(lines: Sequence[Line]) -> list[dict[str, Any]]:
    """A dictionary by header for each line."""
    return [dict(zip(HEADERS, map(sayable, _cells(line)), strict=True)) for line in lines]


def _cells(line: Line) -> list[Any]:
    return [
        *(line.case, line.member, line.what, _or(line.ours), _or(line.theirs), line.unit),
        *("-" if line.ratio is None else line.ratio, line.tolerance, line.verdict, line.because),
        *(line.kind, line.source, line.note),
    ]


def _or(value: Value | None) -> Value:
    return "none" if value is None else value


def table(lines: Sequence[Line]) -> list[str]:
    """Aligned lines for a terminal, each reason below its line."""
    rows = [_TITLES, *(_shown(line) for line in lines)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    reasons = ["", *(line.because for line in lines)]
    return [text for row, reason in zip(rows, reasons, strict=True) for text in _aligned(row, widths, reason)]


def _aligned(row: Sequence[str], widths: Sequence[int], reason: str) -> Iterator[str]:
    """Numbers to the right, texts to the left."""
    pairs = enumerate(zip(row, widths, strict=True))
    cells = [text.rjust(width) if i in (3, 4) else text.ljust(width) for i, (text, width) in pairs]
    yield "  ".join(cells).rstrip()
    if reason:
        yield f"{'':{widths[0]}}  {reason}"


def _shown(line: Line) -> tuple[str, ...]:
    verdict = line.verdict.upper() if line.verdict == FAIL else line.verdict
    what = f"{line.what} [{line.unit}]" if line.unit else line.what
    return verdict, line.member, what, number(line.ours), number(line.theirs), line.tolerance


def number(value: Value | None) -> str:
    """A number to seven digits, a text shortened, a dash for nothing."""
    if value is None:
        return "-"
    if isinstance(value, str):
        return value if len(value) <= 24 else value[:21] + "..."
    return f"{value:.7g}"
