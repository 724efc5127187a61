"""Long tables that are no sheets of the results but Parquet files: where they are, rows of some members."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ptbatch.errors import ReadError
from ptbatch.workbook.arrow import load_arrow
from ptbatch.workbook.read import RawSheet

LONG_TABLES = "long tables"  # a name in the sheet run
HERE = "in this workbook"


def place_of(folder: Path | None, results: Path) -> str:
    """Folder of the files as it is recorded: its name if it lies beside the results, so that both can be
    moved."""
    if folder is None:
        return HERE
    beside = folder.resolve().parent == results.resolve().parent
    return folder.name if beside else str(folder.resolve())


def folder_in(book: Any, results: Path) -> Path | None:
    """Folder of the files; None if the workbook has all tables."""
    if "run" not in book.sheetnames:
        return None
    run = {row[0]: row[1] for row in book["run"].iter_rows(values_only=True) if len(row) > 1}
    place = run.get(LONG_TABLES, HERE)
    return None if place == HERE else results.parent / str(place)


def rows_of(folder: Path, table: str, members: Iterable[str]) -> list[dict[str, Any]]:
    """Rows of some members by header, none if there is no such table. Raises ReadError, MissingArrowError."""
    arrow = load_arrow()
    if not folder.is_dir():
        raise ReadError(f"the long tables are in {folder}, which is not there")
    path = folder / f"{table}.parquet"
    if not path.exists():
        return []
    try:
        wanted = [("member", "in", sorted(members))]
        return list(arrow.parquet.read_table(path, filters=wanted).to_pylist())
    except arrow.ArrowException as error:
        raise ReadError(f"{path} is damaged ({type(error).__name__}); run the input again") from error


def sheet_of(folder: Path, table: str, members: Iterable[str]) -> RawSheet:
    """The same as a sheet, with headers in its first row."""
    rows = rows_of(folder, table, members)
    lines = [list(rows[0]), *(row.values() for row in rows)] if rows else []
    return RawSheet(
        table,
        {n: {i: v for i, v in enumerate(line, 1) if v is not None} for n, line in enumerate(lines, 1)},
    )
