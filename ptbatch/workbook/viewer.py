"""The sheet `viewer`: a member chosen from a list, and its charts, by formulas over the long sheets.

Left what the summary says and the charts; on the right, from column DATA on, the points that the charts show.
The values stored with the formulas are those of the first member.
"""

from collections.abc import Iterator
from itertools import zip_longest
from typing import Any

from openpyxl.cell import WriteOnlyCell
from openpyxl.styles import Font, PatternFill
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.datavalidation import DataValidation

from ptbatch.workbook.charts import Block, add_charts
from ptbatch.workbook.column import System
from ptbatch.workbook.page import TEXT, on_one_page
from ptbatch.workbook.places import PLACES, VIEWED, Places
from ptbatch.workbook.results import CURVES, SUMMARY, TENDON
from ptbatch.workbook.sayable import sayable
from ptbatch.workbook.stored_values import Formula, store_values
from ptbatch.workbook.systems import headers_in, written
from ptbatch.workbook.viewed import CURVE_COLUMNS, POINT_COLUMNS, Names, curve_values, point_values
from ptbatch.workbook.write import Book

HINT = (
    "choose a member in B1. The charts count on the order of the sheets tendon and curves: filter, never sort"
)
CHOSEN = "$B$1"
SHOWN = (
    "status",
    "failure",
    "load_cracking [kN]",
    "load_yield [kN]",
    "load_peak [kN]",
    "deflection_peak [mm]",
)
KEYS = 3 + len(SHOWN)  # row of the place of the member; those of PLACES follow
PRINTED = "A1:S48"
DATA = 20  # column of the points
FIRST = 3  # row of the points

Cell = Any
_HEAD = Font(name="Calibri", size=11, bold=True)
_GREY = Font(name="Calibri", size=11, color="808080")
_CHOICE = PatternFill("solid", fgColor="FFF2CC")


def write_viewer(book: Book, places: Places, place: int) -> None:
    """Add the sheet before the one that has this place, and the hidden sheet `places`."""
    page = book.page("places", PLACES)
    for member in places.places:
        page.add(member.line())
    book.hide("places")
    sheet = book.sheet("viewer", place)
    for column, width in (("A", 22), ("B", 30), ("C", 12)):
        sheet.column_dimensions[column].width = width
    on_one_page(sheet, PRINTED)
    points = Block(DATA, FIRST, places.most_points, _columns(POINT_COLUMNS, places.system))
    steps = Block(points.after, FIRST, places.most_steps, _columns(CURVE_COLUMNS, places.system))
    _choice(sheet, len(places.places))
    add_charts(sheet, points, steps, places.least_stress, places.system)
    stored: dict[str, float | str] = {}
    for number, row in enumerate(_rows(places, points, steps), 1):
        sheet.append([_cell(sheet, value) for value in row])
        for i, value in enumerate(row, 1):
            if isinstance(value, Formula):
                stored[f"{get_column_letter(i)}{number}"] = value.value
    store_values(sheet, stored)


def _columns(columns: Names, system: System) -> Names:
    """Columns of the points with their units."""
    return tuple((written(name, system)[0], key) for name, key in columns)


def _choice(sheet: Any, members: int) -> None:
    rule = DataValidation(type="list", formula1=f"places!$A$2:$A${members + 1}", allow_blank=False)
    rule.showErrorMessage, rule.error = True, "There are no results of such a member"
    rule.add("B1")
    sheet.data_validations.append(rule)


def _rows(places: Places, points: Block, steps: Block) -> Iterator[list[Any]]:
    """All cells, row by row: the left block, a gap, the points and the steps."""
    right = zip_longest(_points(places, points), _steps(places, steps), fillvalue=())
    heads: list[list[Any]] = [[], [*points.names, None, *steps.names]]
    data = [[*p, *[None] * (points.width - len(p) + 1), *s] for p, s in right]
    lefts = _left(places)
    for left, values in zip_longest(lefts, [*heads, *data], fillvalue=list[Any]()):
        yield [*left, *[None] * (DATA - 1 - len(left)), *values]


def _left(places: Places) -> list[list[Any]]:
    """The choice, where its rows are, what the summary says."""
    assert places.first
    line, first = places.first[0], places.places[0]
    names = _range("places", 1, len(places.places))
    rows: list[list[Any]] = [["member", _Text(first.member), HINT]]
    headers = headers_in(("member", "status", "message", *SUMMARY), places.system)
    for header in headers_in(SHOWN, places.system):
        cells = _range("summary", headers.index(header) + 1, places.rows["summary"])
        rows.append([header, Formula(f"=INDEX({cells},{_key('summary')})", sayable(line[header]))])
    place = f"=SUMPRODUCT(EXACT({names},{CHOSEN})*(ROW({names})-1))"
    rows += [[], ["place", Formula(place, 1)]]
    for i, (name, value) in enumerate(zip(PLACES[1:], first.line()[1:], strict=True), 2):
        found = f"INDEX({_range('places', i, len(places.places))},$B${KEYS})"
        rows.append([name, Formula(f"=IF($B${KEYS}=0,NA(),{found})", value)])
    return rows


def _points(places: Places, block: Block) -> Iterator[list[Any]]:
    """Number of the point, x, stress at each stage, analytic stress where there is one."""
    assert places.first
    values = point_values(places.first[1], block.rows, places.system)
    total = places.rows["tendon"]
    x = _range("tendon", TENDON.index("x [mm]") + 1, total)
    stress = {
        name: _range("tendon", TENDON.index(f"{name} [MPa]") + 1, total)
        for name in ("stress_fe", "stress_analytic")
    }
    count = _key("points")
    for i in range(block.rows):
        n = block.cell(0, i)
        texts = [f"=INDEX({x},{_key(VIEWED[0])}+MIN({n},{count})-1)"]
        for name, stage in POINT_COLUMNS[2:]:
            found = f"IFERROR(INDEX({stress[name]},{_key(stage)}+{n}-1),NA())"
            texts.append(f"=IF({n}>{count},NA(),{found})")
        yield [i + 1, *map(Formula, texts, values[i])]


def _steps(places: Places, block: Block) -> Iterator[list[Any]]:
    """Number of the step, deflection, load, and the load again where something happened."""
    assert places.first
    values = curve_values(places.first[1], block.rows, places.system)
    total = max(1, places.rows["curves"])
    columns = [
        _range("curves", CURVES.index(h) + 1, total) for h in ("deflection [mm]", "load [kN]", "event")
    ]
    start, count = _key("curves"), _key("steps")
    for i in range(block.rows):
        n = block.cell(0, i)
        x, y, event = (f"INDEX({column},{start}+{n}-1)" for column in columns)
        texts = [f"=IF({n}>{count},NA(),IFERROR({found},NA()))" for found in (x, y)]
        for _, name in CURVE_COLUMNS[3:]:
            texts.append(f'=IF({n}>{count},NA(),IF(ISNUMBER(FIND("{name}",{event})),{y},NA()))')
        yield [i + 1, *map(Formula, texts, values[i])]


def _key(name: str) -> str:
    """Cell of the viewer with what PLACES says of the chosen member."""
    return f"$B${KEYS + PLACES.index(name)}"


def _range(sheet: str, column: int, rows: int) -> str:
    letter = get_column_letter(column)
    return f"{sheet}!${letter}$2:${letter}${rows + 1}"


class _Text(str):
    """The name in the cell of choice."""


def _cell(sheet: Any, value: Any) -> Cell:
    """A formula, or a text that cannot become one."""
    if isinstance(value, Formula):
        cell = WriteOnlyCell(sheet, value.text)
        cell.number_format = "0.0" if isinstance(value.value, float) else "General"
        return cell
    cell = WriteOnlyCell(sheet, value)
    if isinstance(value, str):
        cell._value, cell.data_type = str(sayable(value)), "s"
        cell.font = _GREY if value == HINT else _HEAD
    if isinstance(value, _Text):
        cell.number_format, cell.fill = TEXT, _CHOICE
    return cell
