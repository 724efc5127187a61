"""Writing a new workbook: texts that cannot become formulas, a file that is whole or not there at all."""

import os
from collections.abc import Iterable, Sequence
from datetime import date, time, timedelta
from math import isfinite
from numbers import Integral, Real
from pathlib import Path
from typing import Any, NamedTuple
from zipfile import ZipFile

from openpyxl import Workbook, load_workbook
from openpyxl.cell import WriteOnlyCell
from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE
from openpyxl.styles import Alignment, Font
from openpyxl.utils import get_column_letter

from ptbatch.errors import WriteError
from ptbatch.workbook.formats import number_format, width

LONGEST_TEXT = 32_767  # of an Excel cell
NAMES_TRIED = 99
_BOLD = Font(name="Calibri", size=11, bold=True)
_WRAPPED = Alignment(wrap_text=True, vertical="top")
_TWO_LINES = 30  # height of a row


class Sheet(NamedTuple):
    """A sheet to be written: its name, its headers, its rows from below the header on."""

    name: str
    headers: Sequence[str]
    rows: Iterable[Sequence[Any]]


def write_workbook(path: Path, sheets: Iterable[Sheet], replace: bool = True) -> Path:
    """Write a workbook and return its path: the next free name if the file is there and held open.

    The old file, or the complete new one, is there at any moment. replace=False refuses an existing file.
    Raises WriteError.
    """
    if not replace and path.exists():
        raise WriteError(f"{path} is there already; give another name or delete it")
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        _save(temporary, sheets)
        return _move(temporary, path)
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
    finally:
        temporary.unlink(missing_ok=True)


def _save(path: Path, sheets: Iterable[Sheet]) -> None:
    """Write, force to disk, and read back what was written."""
    book = Workbook(write_only=True)
    with path.open("xb") as file:
        for sheet in sheets:
            _fill(book, sheet)
        book.save(file)
        file.flush()
        os.fsync(file.fileno())
    with path.open("rb") as file:
        if ZipFile(file).testzip() or load_workbook(file, read_only=True).sheetnames != book.sheetnames:
            raise OSError("the file on disk is not what was written")


def _move(temporary: Path, path: Path) -> Path:
    """Put the file in its place, or under the next free name if the old one is held open by Excel."""
    try:
        os.replace(temporary, path)
        return path
    except PermissionError:
        for i in range(2, NAMES_TRIED):
            free = path.with_stem(f"{path.stem}-{i}")
            if not free.exists():
                os.replace(temporary, free)
                return free
        raise


def _fill(book: Any, sheet: Sheet) -> None:
    page = book.create_sheet(sheet.name)
    page.freeze_panes = "B2"
    for i, header in enumerate(sheet.headers, 1):
        page.column_dimensions[get_column_letter(i)].width = width(header)
    page.row_dimensions[1].height = _TWO_LINES
    page.append([_header(page, text) for text in sheet.headers])
    formats = [number_format(header) for header in sheet.headers]
    for row in sheet.rows:
        page.append([_cell(page, value, form) for value, form in zip(row, formats, strict=True)])


def _header(page: Any, text: str) -> Any:
    cell = _cell(page, text, "General")
    cell.font, cell.alignment = _BOLD, _WRAPPED
    return cell


def _cell(page: Any, value: Any, form: str) -> Any:
    value = sayable(value)
    cell = WriteOnlyCell(page, value)
    if isinstance(value, str):
        cell.data_type = "s"  # also where it begins like a formula
        cell.quotePrefix = value[:1] in ("=", "+", "-", "@")
    elif isinstance(value, float):
        cell.number_format = form
        cell._value = repr(value)  # openpyxl itself writes 16 digits, which may be one too few
    return cell


def sayable(value: Any) -> Any:
    """A value as it can stand in a cell or in JSON: finite, not too long, without control characters."""
    if value is None or isinstance(value, bool | date | time | timedelta):
        return value
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Real):
        return float(value) if isfinite(value) else "not a finite number"
    text = ILLEGAL_CHARACTERS_RE.sub("", str(value))
    return text if len(text) <= LONGEST_TEXT else text[: LONGEST_TEXT - 4] + " ..."
