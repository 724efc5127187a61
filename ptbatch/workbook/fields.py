"""What the columns of the tables hold where each column holds one kind of value."""

from collections.abc import Sequence

from ptbatch.workbook.echo import TABLES as ECHO
from ptbatch.workbook.parquet import Fields
from ptbatch.workbook.results import DETAILS, HEAD, SUMMARY

_TEXTS = {
    *(*HEAD, "failure", "stage", "event", "checks", "governing_check"),
    *("check", "clause", "formula", "numbers", "unit", "outcome", "reason"),
    *("end", "to_read", "warning"),
    *("cause", "source"),
}
_COUNTS = {"support", "step", "newton_iterations"}
_OF_KIND = {"number": float, "integer": int}


def fields(table: str, headers: Sequence[str]) -> Fields:
    """Types of the columns of `summary`, `tendon`, `curves`, `cracks` or the echo of the input, by header."""
    if table in ECHO:
        kinds = [_OF_KIND.get(column.kind, str) for column in ECHO[table]]
        return dict(zip(headers, kinds, strict=True))
    own = DETAILS.get(table, (*HEAD, *SUMMARY))
    kinds = [*map(_type, own), *[str] * (len(headers) - len(own))]
    return dict(zip(headers, kinds, strict=True))


def _type(header: str) -> type[str] | type[int] | type[float]:
    if header in _TEXTS:
        return str
    return int if header in _COUNTS else float
