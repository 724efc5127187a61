"""Rows of a sheet as finished XML, which takes a twentieth of the time that openpyxl needs for as many cells.

openpyxl has no public way to write such rows. Where it is built in another way than expected (or writes by
lxml), `takes_markup` says no, and rows go the usual way.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import repeat
from math import inf
from typing import Any
from xml.sax.saxutils import escape

import orjson
from openpyxl.utils import get_column_letter

from ptbatch.workbook.sayable import sayable
from ptbatch.workbook.stored_values import Formula

TEXTS = 256  # of a column that are kept: most come again and again

Pieces = list[Iterable[str]]  # of which the cells of a column are made, one after the other


class Markup(str):
    """Row elements of a sheet."""


class Styles:
    """Numbers of the styles of a column: of its numbers, its texts, its texts that begin like a formula; and
    how a cell with a fraction or a whole number in it starts, before and behind the number of the row."""

    def __init__(self, cell: Callable[[Any], Any], column: int) -> None:
        self._number, self._whole, self._text, self._quoted = (
            _style(cell(example)) for example in (1.5, 1, "a", "=a")
        )
        self.start, self.fraction = f'<c r="{get_column_letter(column)}', f'"{self._number}><v>'
        self.whole = f'"{self._whole}><v>'
        self.texts = Texts(self._text, self._quoted)

    def cell(self, value: Any, row: str) -> str | None:
        """A cell with what `sayable` makes of a value; None where that is nothing for Markup."""
        if isinstance(value, str):
            return f"{self.start}{row}{self.texts[value]}" if value else ""
        value = in_row(sayable(value), row)
        if value is None:
            return ""
        place = f'{self.start}{row}"'
        if isinstance(value, Formula):  # its value is a text
            return f'{place}{self._number} t="str"><f>{escape(value.text[1:])}</f><v>{value.value}</v></c>'
        if isinstance(value, bool):
            return f'{place}{self._whole} t="b"><v>{value:d}</v></c>'
        if isinstance(value, float):
            return f"{place}{self._number}><v>{value!r}</v></c>"
        if isinstance(value, int):
            return f"{place}{self._whole}><v>{value}</v></c>"
        return self.cell(value, row) if isinstance(value, str) else None


class Texts(dict[str, str]):
    """By text, what stands behind the number of the row of a cell with it. TEXTS of them are kept."""

    def __init__(self, plain: str, quoted: str) -> None:
        super().__init__()
        self._plain, self._quoted = plain, quoted

    def __missing__(self, text: str) -> str:
        if len(self) >= TEXTS:
            self.clear()
        self[text] = behind = self._behind(sayable(text))
        return behind

    def _behind(self, text: str) -> str:
        if not text:  # of control characters alone
            return '"/>'
        style = self._quoted if text[0] in "=+-@" else self._plain
        space = "" if text == text.strip() and "\n" not in text else ' xml:space="preserve"'
        return f'"{style} t="inlineStr"><is><t{space}>{escape(text)}</t></is></c>'


def _style(cell: Any) -> str:
    return f' s="{cell.style_id}"' if cell.has_style else ""


def in_row(value: Any, row: int | str) -> Any:
    """A formula for that row; anything else as it is."""
    return value._replace(text=value.text.format(row=row)) if isinstance(value, Formula) else value


def rows_markup(columns: Sequence[Sequence[Any]], styles: Sequence[Styles], first: int) -> Markup | None:
    """Rows of cells from the row `first` on, column by column; None where a value is nothing for Markup."""
    rows = [str(row) for row in range(first, first + len(columns[0]))]
    pieces: Pieces = [repeat('<row r="'), rows, repeat('">')]
    for values, style in zip(columns, styles, strict=True):
        cells = _numbers(values, style, rows) or _texts(values, style, rows) or _mixed(values, style, rows)
        if cells is None:
            return None
        assert len(values) == len(rows)
        pieces += cells
    pieces.append(repeat("</row>"))
    return Markup("".join(map("".join, zip(*pieces, strict=False))))  # as far as there are rows


def _numbers(values: Sequence[Any], style: Styles, rows: Sequence[str]) -> Pieces | None:
    """Cells of a column of finite fractions, or of whole numbers; None where there is anything else in it."""
    kinds = set(map(type, values))
    if kinds == {int}:  # which may have more digits than orjson writes
        behind, digits = style.whole, list(map(str, values))
    elif kinds == {float}:
        behind, digits = style.fraction, _digits(values)
    else:
        return None
    if "null" in digits:  # of what is not finite
        return None
    return [repeat(style.start), rows, repeat(behind), digits, repeat("</v></c>")]


def _digits(values: Sequence[Any]) -> list[str]:
    """What repr() makes of fractions, many times as fast; null where one is not finite."""
    return orjson.dumps(values).decode()[1:-1].split(",")


def _texts(values: Sequence[Any], style: Styles, rows: Sequence[str]) -> Pieces | None:
    """Cells of a column of texts; None where there is anything else in it."""
    if set(map(type, values)) != {str} or "" in values:
        return None
    return [repeat(style.start), rows, [style.texts[text] for text in values]]


def _mixed(values: Sequence[Any], style: Styles, rows: Sequence[str]) -> Pieces | None:
    """Cells of any column; None where there is a value that is nothing for Markup."""
    start, fraction, texts, cell = style.start, style.fraction, style.texts, style.cell
    digits = iter(_digits([value for value in values if type(value) is float and -inf < value < inf]))
    cells = [
        f"{start}{row}{texts[value]}"
        if type(value) is str and value
        else f"{start}{row}{fraction}{next(digits)}</v></c>"
        if type(value) is float and -inf < value < inf
        else cell(value, row)
        for row, value in zip(rows, values, strict=True)
    ]
    known = [text for text in cells if text is not None]
    return [known] if len(known) == len(cells) else None


@dataclass
class RowNumber:
    """Number of the row that is written next."""

    next: int = 2


def takes_markup(sheet: Any, number: RowNumber) -> bool:
    """Have a write-only sheet, whose first row is written, take rows of Markup, many at once, and give others
    their number; whether it does."""
    writer: Any = getattr(sheet, "_writer", None)
    as_cells, write = getattr(sheet, "_values_to_row", None), getattr(writer, "write_row", None)
    if as_cells is None or write is None or not _plain_stream():
        return False
    sheet._values_to_row = lambda row, _: row[0] if _finished(row) else as_cells(row, number.next)
    writer.write_row = lambda stream, row, _: (
        stream._file(row) if isinstance(row, Markup) else write(stream, row, number.next)
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
