"""Members from a Parquet file: its columns are headers, a list may be a list. It is never held whole."""

from collections.abc import Iterator, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any

from ptbatch.errors import ReadError
from ptbatch.workbook.archive import MAX_UNPACKED
from ptbatch.workbook.arrow import opened
from ptbatch.workbook.read import MAX_COLUMNS, Block, RawSheet
from ptbatch.workbook.source import BLOCK, Source, no_header
from ptbatch.workbook.table import find_header

SUFFIXES = (".parquet", ".pq")
HEADER = 0  # number of the row of headers; those of the members count from 1


def parquet_source(path: Path) -> Source:
    """The table in a Parquet file. Raises ReadError, MissingArrowError."""
    with opened(path) as file:
        _check(file.metadata)
        names = dict(enumerate(file.schema_arrow.names, 1))
    head = RawSheet(path.name, {HEADER: names}, _cell)
    if find_header(head, "member") is None:
        raise ReadError(no_header(head))
    return Source(head, HEADER, lambda: _blocks(path))


def _check(metadata: Any) -> None:
    """Raise ReadError where reading some rows would take too much memory."""
    if metadata.num_columns > MAX_COLUMNS:
        raise ReadError(f"the file has more than {MAX_COLUMNS} columns")
    groups = (metadata.row_group(i) for i in range(metadata.num_row_groups))
    if any(group.total_byte_size > MAX_UNPACKED for group in groups):
        limit = MAX_UNPACKED // 2**20
        raise ReadError(f"a row group unpacks to more than {limit} MB; write the file with smaller ones")


def _cell(row: int, column: int) -> str:
    return f"row {row}, column {column}" if row > HEADER else f"column {column}"


def _blocks(path: Path) -> Iterator[Block]:
    start = HEADER + 1
    with opened(path) as file:
        for batch in file.iter_batches(BLOCK):
            columns = [column.to_pylist() for column in batch.columns]
            block = {start + i: _filled(values) for i, values in enumerate(zip(*columns, strict=True))}
            yield {number: cells for number, cells in block.items() if cells}
            start += batch.num_rows


def _filled(values: Sequence[Any]) -> dict[int, Any]:
    typed = ((i, _typed(value)) for i, value in enumerate(values, 1))
    return {i: v for i, v in typed if v is not None and not (isinstance(v, str) and not v.strip())}


def _typed(value: Any) -> Any:
    """A value as it would be typed into a cell: a list of numbers as a text."""
    if isinstance(value, Decimal):
        return float(value)
    if isinstance(value, list):
        return "; ".join(str(_typed(item)) for item in value) or None
    return value
