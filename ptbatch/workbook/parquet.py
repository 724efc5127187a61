"""Writing a table of results to a Parquet file as members come: a column holds texts or numbers, not both."""

import os
from collections.abc import Mapping, Sequence
from math import isfinite
from pathlib import Path
from typing import Any

from ptbatch.workbook.arrow import load_arrow
from ptbatch.workbook.sayable import sayable

ROWS_AT_ONCE = 20_000  # of a row group
REASONS = "without value"  # column for the texts that stand where a number is wanted

Fields = Mapping[str, type[str] | type[int] | type[float]]  # what the columns hold, by header


class ParquetTable:
    """A table that rows are added to. Its file is in place once it is finished.

    reasons: add a column that says, for each number that is not there, why. Raises OSError,
    MissingArrowError.
    """

    def __init__(self, path: Path, fields: Fields, reasons: bool = False) -> None:
        self._arrow = load_arrow()
        self._path, self._fields, self._reasons = path, dict(fields), reasons
        if reasons:
            self._fields[REASONS] = str
        types = {str: self._arrow.string(), int: self._arrow.int64(), float: self._arrow.float64()}
        self._schema = self._arrow.schema([(name, types[kind]) for name, kind in self._fields.items()])
        self._temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        self._file = self._arrow.parquet.ParquetWriter(self._temporary, self._schema, compression="zstd")
        self._columns: list[list[Any]] = [[] for _ in self._fields]

    def extend(self, columns: Sequence[Sequence[Any]]) -> None:
        """Add rows, column by column."""
        for values, column, kind in zip(columns, self._columns, self._fields.values(), strict=False):
            column += [_as(kind, value) for value in values]
        if self._reasons:
            self._columns[-1] += map(self._why, zip(*columns, strict=True))
        if len(self._columns[0]) >= ROWS_AT_ONCE:
            self._flush()

    def _why(self, row: Sequence[Any]) -> str:
        """The texts that stand where a number is wanted."""
        kinds = zip(self._fields.items(), row, strict=False)
        return "; ".join(
            f"{name}: {v}" for (name, kind), v in kinds if kind is not str and isinstance(v, str)
        )

    def finish(self) -> None:
        """Write what is left and put the file in its place."""
        self._flush()
        self._file.close()
        os.replace(self._temporary, self._path)

    def discard(self) -> None:
        """Delete the file if it is not finished."""
        self._file.close()
        self._temporary.unlink(missing_ok=True)

    def _flush(self) -> None:
        if self._columns[0]:
            columns = zip(self._columns, self._schema, strict=True)
            arrays = [self._arrow.array(values, field.type) for values, field in columns]
            self._file.write_table(self._arrow.Table.from_arrays(arrays, schema=self._schema))
            self._columns = [[] for _ in self._fields]


def _as(kind: type, value: Any) -> Any:
    """A value as its column holds it; None for a number that is a text."""
    if type(value) is kind is float and isfinite(value):  # nearly all of them
        return value
    value = sayable(value)
    if value is None or kind is str:
        return value if value is None else str(value)
    return kind(value) if isinstance(value, int | float) else None
