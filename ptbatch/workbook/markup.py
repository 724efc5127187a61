"""Rows of a sheet as finished XML, which takes a twentieth of the time that openpyxl needs for as many cells.

openpyxl has no public way to write such rows. Where it is built in another way than expected (or writes by
lxml), `takes_markup` says no, and rows go the usual way.
"""

from collections.abc import Callable, Sequence
from typing import Any
from xml.sax.saxutils import escape

from openpyxl.utils import get_column_letter

from ptbatch.workbook.stored_values import Formula


class Markup(str):
    """A row element of a sheet."""


class Styles:
    """Numbers of the styles of a column: of its numbers, its texts, its texts that begin like a formula."""

    def __init__(self, cell: Callable[[Any], Any], column: int) -> None:
        self.letter = get_column_letter(column)
        self._number, self._whole, self._text, self._quoted = (
            _style(cell(example)) for example in (1.5, 1, "a", "=a")
        )

    def cell(self, value: Any, row: int) -> str:
        """A cell; value: None, a number, a truth value, a formula, or a text that `sayable` let through."""
        if value is None or value == "":
            return ""
        place = f'<c r="{self.letter}{row}"'
        if isinstance(value, Formula):  # its value is a text
            return f'{place}{self._number} t="str"><f>{escape(value.text[1:])}</f><v>{value.value}</v></c>'
        if isinstance(value, float):
            return f"{place}{self._number}><v>{value!r}</v></c>"
        if isinstance(value, bool):
            return f'{place}{self._whole} t="b"><v>{value:d}</v></c>'
        if isinstance(value, int):
            return f"{place}{self._whole}><v>{value}</v></c>"
        style = self._quoted if value[0] in "=+-@" else self._text
        space = "" if value == value.strip() and "\n" not in value else ' xml:space="preserve"'
        return f'{place}{style} t="inlineStr"><is><t{space}>{escape(value)}</t></is></c>'


def _style(cell: Any) -> str:
    return f' s="{cell.style_id}"' if cell.has_style else ""


def row_markup(values: Sequence[Any], columns: Sequence[Styles], row: int) -> Markup:
    """A row of cells, one below each header."""
    cells = [style.cell(value, row) for value, style in zip(values, columns, strict=True)]
    return Markup(f'<row r="{row}">{"".join(cells)}</row>')


def takes_markup(sheet: Any) -> bool:
    """Have a write-only sheet, whose first row is written, take rows of Markup; whether it does."""
    writer: Any = getattr(sheet, "_writer", None)
    as_cells, write = getattr(sheet, "_values_to_row", None), getattr(writer, "write_row", None)
    if as_cells is None or write is None or not _plain_stream():
        return False
    sheet._values_to_row = lambda row, number: row[0] if _finished(row) else as_cells(row, number)
    writer.write_row = lambda stream, row, number: (
        stream._file(row) if isinstance(row, Markup) else write(stream, row, number)
    )
    return True


def _finished(row: Any) -> bool:
    return isinstance(row, tuple) and len(row) == 1 and isinstance(row[0], Markup)


def _plain_stream() -> bool:
    """Whether sheets are written by et_xmlfile, in a version that hands texts on as they are."""
    from openpyxl.xml.functions import xmlfile

    texts: list[str] = []
    try:
        from et_xmlfile.xmlfile import _IncrementalFileWriter

        _IncrementalFileWriter(texts.append)._file("<x/>")
    except (ImportError, AttributeError, TypeError):
        return False
    return xmlfile.__module__.startswith("et_xmlfile") and texts == ["<x/>"]
