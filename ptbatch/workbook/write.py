"""Writing a new workbook: a file that is whole or not there at all."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple
from zipfile import ZipFile

from defusedxml.ElementTree import fromstring
from openpyxl import Workbook
from openpyxl.writer.excel import ExcelWriter

from ptbatch.errors import WriteError
from ptbatch.workbook.packing import Archive, Packer
from ptbatch.workbook.page import Page

NAMES_TRIED = 99
SHEET = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}sheet"

Dress = Callable[[Any], None]


class Sheet(NamedTuple):
    """A sheet to be written: its name, its headers, its rows from below the header on.

    notes: comments on headers. dress: what is done to the sheet of openpyxl before anything is in it.
    """

    name: str
    headers: Sequence[str]
    rows: Iterable[Sequence[Any]]
    notes: Mapping[str, str] | None = None
    dress: Dress | None = None


class Book:
    """A workbook that is written row by row; until it is saved it lies in temporary files."""

    def __init__(self) -> None:
        self._book = Workbook(write_only=True)
        self._packer = Packer()

    @property
    def names(self) -> list[str]:
        """Its sheets in their order."""
        return list(self._book.sheetnames)

    def sheet(self, name: str, place: int | None = None) -> Any:
        """Add a blank sheet of openpyxl, at the end or before the one that has this place."""
        return self._book.create_sheet(name, place)

    def hide(self, name: str) -> None:
        """Hide a sheet; Excel can show it again."""
        self._book[name].sheet_state = "hidden"

    def page(
        self,
        name: str,
        headers: Sequence[str],
        place: int | None = None,
        notes: Mapping[str, str] | None = None,
        dress: Dress | None = None,
    ) -> Page:
        """Add a table, at the end or before the sheet that has this place; the others as in `Sheet`."""
        sheet = self.sheet(name, place)
        if dress:
            dress(sheet)
        page = Page(sheet, headers, notes)
        if file := getattr(getattr(sheet, "_writer", None), "out", None):  # openpyxl promises neither
            self._packer.follow(file)
        return page

    def save(self, path: Path, replace: bool = True) -> Path:
        """Save it and return its path: the next free name if the file is there and held open.

        The old file, or the complete new one, is there at any moment. replace=False refuses an existing file.
        Raises WriteError.
        """
        if not replace and path.exists():
            raise WriteError(f"{path} is there already; give another name or delete it")
        temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        with unwritable(path):
            try:
                _save(self._book, temporary, self._packer)
                return _move(temporary, path)
            finally:
                temporary.unlink(missing_ok=True)

    def discard(self) -> None:
        """Delete the temporary files of a workbook that is not saved, or not saved any more."""
        self._packer.discard()
        for sheet in self._book.worksheets:
            with suppress(Exception):  # whatever is wrong with it, it is given up
                if not sheet.closed:
                    sheet.close()
                sheet._writer.cleanup()


def write_workbook(path: Path, sheets: Iterable[Sheet], replace: bool = True) -> Path:
    """Write a workbook as `Book.save` does. Raises WriteError."""
    book = Book()
    try:
        with unwritable(path):
            for sheet in sheets:
                page = book.page(sheet.name, sheet.headers, notes=sheet.notes, dress=sheet.dress)
                for row in sheet.rows:
                    page.add(row)
        return book.save(path, replace)
    finally:
        book.discard()


@contextmanager
def unwritable(path: Path) -> Iterator[None]:
    """What the disk refuses becomes a WriteError."""
    try:
        yield
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error


def _save(book: Any, path: Path, packer: Packer) -> None:
    """Write, force to disk, and read back what was written."""
    packer.stop()
    with path.open("xb") as file:
        ExcelWriter(book, Archive(file, packer)).save()  # closes the archive; book.save() knows of no level
        file.flush()
        os.fsync(file.fileno())
    with ZipFile(path) as written:
        if written.testzip() or _sheet_names(written) != book.sheetnames:
            raise OSError("the file on disk is not what was written")


def _sheet_names(written: ZipFile) -> list[str]:
    """Its sheets, as whoever opens it will see them."""
    return [sheet.get("name", "") for sheet in fromstring(written.read("xl/workbook.xml")).iter(SHEET)]


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
