"""The file itself: is it a workbook at all, and small enough to be opened."""

import re
from collections.abc import Iterator
from typing import BinaryIO
from zipfile import BadZipFile, ZipFile

from ptbatch.errors import ReadError

MAX_FILE = 64 * 2**20
MAX_UNPACKED = 192 * 2**20  # of all XML parts; fifty thousand full rows take less

_OLE = b"\xd0\xcf\x11\xe0"
_FORMULA = re.compile(rb"<(\w+:)?f[\s/>]")
_CHUNK, _OVERLAP = 2**20, 64


def check_file(file: BinaryIO, bounds: int = 1) -> None:
    """Raise ReadError unless this looks like an xlsx workbook of bearable size: `bounds` times that of an
    input."""
    start = file.read(4)
    size = file.seek(0, 2)
    if size > bounds * MAX_FILE:
        limit = bounds * MAX_FILE // 2**20
        raise ReadError(f"the file is larger than {limit} MB; keep only the sheets with members")
    if start == _OLE:
        raise ReadError("the file is password-protected or in the old .xls format; save it as plain .xlsx")
    try:
        _check_parts(ZipFile(file), bounds * MAX_UNPACKED)
    except BadZipFile as error:
        raise ReadError("the file is not an Excel workbook; save the table as .xlsx") from error


def _check_parts(archive: ZipFile, most: int) -> None:
    names = archive.namelist()
    if "xl/workbook.xml" not in names:
        raise ReadError("the file is not an .xlsx workbook (ods and xlsb are not read); save it as .xlsx")
    unpacked = sum(info.file_size for info in archive.infolist() if info.filename.endswith((".xml", ".rels")))
    if unpacked > most:
        limit = most // 2**20
        raise ReadError(f"the workbook unpacks to more than {limit} MB; keep only the sheets with members")


def has_formulas(file: BinaryIO) -> bool:
    """Whether any worksheet holds a formula."""
    with ZipFile(file) as archive:
        parts = [name for name in archive.namelist() if name.startswith("xl/worksheets/")]
        return any(_FORMULA.search(chunk) for name in parts for chunk in _chunks(archive, name))


def _chunks(archive: ZipFile, name: str) -> Iterator[bytes]:
    with archive.open(name) as part:
        tail = b""
        while chunk := part.read(_CHUNK):
            yield tail + chunk
            tail = chunk[-_OVERLAP:]
