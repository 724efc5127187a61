"""A sheet of a new workbook, filled row by row: texts that cannot become formulas, readable headers."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from openpyxl.cell import WriteOnlyCell
from openpyxl.comments import Comment
from openpyxl.styles import Alignment, Font, PatternFill
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.properties import PageSetupProperties

from ptbatch.errors import WriteError
from ptbatch.workbook.formats import number_format, width
from ptbatch.workbook.markup import RowNumber, Styles, in_row, rows_markup, takes_markup
from ptbatch.workbook.read import LAST_ROW
from ptbatch.workbook.sayable import sayable
from ptbatch.workbook.stored_values import Formula

TEXT = "@"  # format of a cell that Excel makes no number or date of
_BOLD = Font(name="Calibri", size=11, bold=True)
_WRAPPED = Alignment(wrap_text=True, vertical="top")
_SHADED = PatternFill("solid", fgColor="E8EDF3")
_TWO_LINES = 30  # height of a row
_AUTHOR, _COMMENT_WIDTH, _LETTERS, _LINE = (
    "ptbatch",
    300,
    44,
    18,
)  # of a comment: points, letters a line, points


class FullSheetError(WriteError):
    """A sheet of Excel takes no more rows."""


class Page:
    """A sheet that rows are added to; they go to disk at once.

    sheet: a write-only one of openpyxl; formats that its columns have already are kept. notes: comments on
    headers.
    """

    def __init__(self, sheet: Any, headers: Sequence[str], notes: Mapping[str, str] | None = None) -> None:
        self._sheet, self._width = sheet, len(headers)
        sheet.freeze_panes = "B2"
        self._formats = []
        for i, header in enumerate(headers, 1):
            column = sheet.column_dimensions[get_column_letter(i)]
            column.width = width(header)
            own = column.number_format
            self._formats.append(number_format(header) if own == "General" else own)
        sheet.row_dimensions[1].height = _TWO_LINES
        sheet.append([self._header(text, (notes or {}).get(text, "")) for text in headers])
        self._number = RowNumber()
        self._styles = [Styles(partial(self._cell, form=form), i) for i, form in enumerate(self._formats, 1)]
        self._quick = takes_markup(sheet, self._number)

    def add(self, values: Sequence[Any]) -> None:
        """Add a row. Raises FullSheetError."""
        self.extend([[value] for value in values])

    def extend(self, columns: Sequence[Sequence[Any]]) -> None:
        """Add rows, column by column. Raises FullSheetError, and adds none of them, if there is no room."""
        rows = len(columns[0])
        if self._number.next + rows - 1 > LAST_ROW:
            raise FullSheetError(f"sheet {self._sheet.title} has {LAST_ROW} rows, more than Excel takes")
        markup = rows_markup(columns, self._styles, self._number.next) if self._quick else None
        if markup is not None:
            self._sheet.append((markup,))
            self._number.next += rows
            return
        for values in zip(*columns, strict=True):
            said = [in_row(sayable(value), self._number.next) for value in values]
            self._sheet.append(list(map(self._cell, said, self._formats)))
            self._number.next += 1

    def filtered(self) -> None:
        """Give the headers buttons that filter the rows; once all rows are there."""
        self._sheet.auto_filter.ref = f"A1:{get_column_letter(self._width)}{self._number.next - 1}"

    def _header(self, text: str, note: str) -> Any:
        cell = self._cell(sayable(text), "General")
        cell.font, cell.alignment, cell.fill = _BOLD, _WRAPPED, _SHADED
        if note:
            lines = sum(1 + len(line) // _LETTERS for line in note.splitlines())
            cell.comment = Comment(note, _AUTHOR, height=_LINE * (lines + 1), width=_COMMENT_WIDTH)
        return cell

    def _cell(self, value: Any, form: str) -> Any:
        if isinstance(value, Formula):
            cell = WriteOnlyCell(self._sheet, value.text)
            cell.number_format = form
            return cell
        cell = WriteOnlyCell(self._sheet, value)
        if isinstance(value, str):
            cell.data_type = "s"  # also where it begins like a formula
            cell.quotePrefix = value[:1] in ("=", "+", "-", "@")
            if form == TEXT:
                cell.number_format = form
        elif isinstance(value, float):
            cell.number_format = form
            cell._value = repr(value)  # openpyxl itself writes 16 digits, which may be one too few
        return cell


def on_one_page(sheet: Any, area: str) -> None:
    """Have an area of a sheet printed on one page, lying."""
    sheet.print_area = area
    sheet.page_setup.orientation = "landscape"
    sheet.page_setup.fitToHeight = sheet.page_setup.fitToWidth = 1
    sheet.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)
