"""Members from a CSV file: UTF-8, cells separated by commas, semicolons or tabs. It is never held whole."""

import csv
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import Any, TextIO

from ptbatch.errors import ReadError
from ptbatch.workbook.read import MAX_COLUMNS, Block, RawSheet
from ptbatch.workbook.source import BLOCK, Source, no_header
from ptbatch.workbook.table import HEADER_WITHIN, find_header

SUFFIXES = (".csv", ".tsv", ".txt")
SEPARATORS = (",", ";", "\t")

Cells = dict[int, str]


def csv_source(path: Path) -> Source:
    """The table in a CSV file; its separator is the one that makes a column `member`. Raises ReadError."""
    for separator in SEPARATORS:
        head = RawSheet(path.name, dict(islice(_records(path, separator), HEADER_WITHIN)), _cell)
        header = find_header(head, "member")
        if header is not None:
            break
    else:
        raise ReadError(no_header(RawSheet(path.name, dict(islice(_records(path, ","), 1)))))
    names = head.rows[header]
    known = RawSheet(path.name, {header: names}, _cell, max(names))

    def blocks() -> Iterator[Block]:
        records = ((line, cells) for line, cells in _records(path, separator) if line > header)
        while block := dict(islice(records, BLOCK)):
            yield block

    return Source(known, header, blocks)


def _cell(line: int, column: int) -> str:
    return f"line {line}, column {column}"


def _records(path: Path, separator: str) -> Iterator[tuple[int, Cells]]:
    """Filled cells of the records that have some, with the line on which each begins."""
    with _text(path) as file:
        reader = csv.reader(file, delimiter=separator, strict=True)
        line = 1
        with _errors(reader):
            for fields in reader:
                cells = {i: field for i, field in enumerate(fields, 1) if field.strip()}
                if cells and max(cells) > MAX_COLUMNS:
                    raise ReadError(f"line {line} has more than {MAX_COLUMNS} cells")
                if cells:
                    yield line, cells
                line = reader.line_num + 1


@contextmanager
def _text(path: Path) -> Iterator[TextIO]:
    with path.open("rb") as file:
        if b"\0" in file.read(4096):
            raise ReadError("the file is not a text in UTF-8; save it as CSV UTF-8, or as .xlsx")
    with path.open(encoding="utf-8-sig", newline="") as text:
        yield text


@contextmanager
def _errors(reader: Any) -> Iterator[None]:
    """What is wrong with the file as such, with its line."""
    try:
        yield
    except UnicodeDecodeError as error:
        after = f"after line {reader.line_num}" if reader.line_num else "near its beginning"
        strange = f"byte {error.object[error.start]:#x} {after}"
        raise ReadError(f"the file is not in UTF-8 ({strange}); save it as CSV UTF-8") from error
    except csv.Error as error:
        raise ReadError(f"line {reader.line_num}: {error}; check the quotes") from error
