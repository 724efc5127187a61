"""Bounded reading of a workbook into raw cells. Nothing is converted here and nothing is guessed."""

import warnings
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple, TypeVar

from openpyxl import load_workbook
from openpyxl.utils import get_column_letter

from ptbatch.errors import ReadError
from ptbatch.workbook.archive import check_file, has_formulas

MAX_ROWS = 50_000  # rows with something in them
MAX_COLUMNS = 1_000
MAX_CELLS = 30_000_000  # blank but formatted ones included
LAST_ROW = 1_048_576  # of Excel

T = TypeVar("T")
Formulas = dict[tuple[int, int], str]
Block = dict[int, dict[int, Any]]  # filled cells by row and column number


class UnsavedFormula(NamedTuple):
    """A formula whose value was never stored in the file."""

    text: str

    def __str__(self) -> str:
        return self.text


def address(row: int, column: int) -> str:
    """`F7`."""
    return f"{get_column_letter(column)}{row}"


@dataclass(frozen=True)
class RawSheet:
    """Cells that hold something, by row and column number (both from 1).

    cell: how users name a place. width: number of headers where a row with more cells is a mistake.
    """

    name: str
    rows: Block
    cell: Callable[[int, int], str] = address
    width: int | None = None


def read_sheets(
    path: Path, main: str, optional: Iterable[str], most_rows: int | None = None
) -> dict[str, RawSheet]:
    """Raw sheets by the name asked for; the first sheet is main if none has its name. Raises ReadError."""
    return guarded(path, lambda file: _read(file, main, optional, most_rows or MAX_ROWS))


def guarded(path: Path, reader: Callable[[BinaryIO], T], bounds: int = 1) -> T:
    """What the reader makes of a file that is a workbook; whatever goes wrong becomes a ReadError.

    bounds: how many times larger than an input the file may be.
    """
    try:
        with path.open("rb") as file:
            check_file(file, bounds)
            return reader(file)
    except ReadError as error:
        raise ReadError(f"{path}: {error}") from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror or error}") from error
    except Exception as error:  # whatever a damaged or hostile file does to the parsers
        cause = type(error.__cause__ or error).__name__
        raise ReadError(f"{path}: damaged ({cause}); open it in Excel and save it again") from error


def _read(file: BinaryIO, main: str, optional: Iterable[str], most_rows: int) -> dict[str, RawSheet]:
    formulas = _formulas(file, {main, *optional}) if has_formulas(file) else {}
    book = open_book(file)
    if not book.worksheets:
        raise ReadError("the workbook has no worksheet")
    by_name = {_key(sheet.title): sheet for sheet in reversed(book.worksheets)}
    by_name.setdefault(main, book.worksheets[0])
    return {
        name: RawSheet(
            by_name[name].title, _rows(by_name[name], formulas.get(by_name[name].title, {}), most_rows)
        )
        for name in (main, *optional)
        if name in by_name
    }


def open_book(file: BinaryIO, data_only: bool = True) -> Any:
    """The workbook, to be walked through row by row."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about extensions that openpyxl does not keep
        return load_workbook(file, read_only=True, data_only=data_only)


def _key(title: str) -> str:
    return title.strip().casefold()


def _formulas(file: BinaryIO, names: set[str]) -> dict[str, Formulas]:
    """Text of the formulas, by sheet and place."""
    book = open_book(file, data_only=False)
    wanted = [s for i, s in enumerate(book.worksheets) if i == 0 or _key(s.title) in names]
    return {
        sheet.title: {
            (row, column): str(getattr(cell.value, "text", cell.value))
            for row, cells in _walk(sheet)
            for column, cell in enumerate(cells, 1)
            if cell.data_type == "f"
        }
        for sheet in wanted
    }


def _rows(sheet: Any, formulas: Formulas, most: int) -> Block:
    rows: Block = {}
    for number, cells in _walk(sheet):
        values = {c: _value(cell, formulas.get((number, c))) for c, cell in enumerate(cells, 1)}
        filled = {c: value for c, value in values.items() if value is not None}
        if not filled:
            continue
        if max(filled) > MAX_COLUMNS:
            far = address(number, max(filled))
            raise ReadError(f"sheet {sheet.title}: cell {far} lies beyond column {MAX_COLUMNS}; clear it")
        rows[number] = filled
        if len(rows) > most:
            raise ReadError(f"sheet {sheet.title} has more than {most} rows; save it as CSV or Parquet")
    return rows


def _walk(sheet: Any) -> Iterator[tuple[int, tuple[Any, ...]]]:
    """Rows that have cells, with their numbers; the size that the file declares is not believed."""
    sheet.reset_dimensions()
    walked = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for number, cells in enumerate(sheet.iter_rows(), 1):
            if number > LAST_ROW:
                raise ReadError(f"sheet {sheet.title} goes beyond row {LAST_ROW}")
            walked += len(cells)
            if walked > MAX_CELLS:
                raise ReadError(f"sheet {sheet.title} is formatted far beyond its table; clear the rest")
            if cells:
                yield number, cells


def _value(cell: Any, formula: str | None) -> Any:
    """Value of a cell, None if blank. A formula for an empty text is blank, one never calculated is not."""
    value = cell.value
    if isinstance(value, str):
        return value if value.strip() else None
    if value is None and formula is not None and cell.data_type != "str":
        return UnsavedFormula(formula)
    return value
