"""The native charts of the sheet `viewer`."""

from math import floor, isfinite
from typing import Any, NamedTuple

from openpyxl.chart import Reference, ScatterChart, Series
from openpyxl.chart.shapes import GraphicalProperties
from openpyxl.drawing.line import LineProperties
from openpyxl.utils import get_column_letter

from ptbatch.workbook.column import System
from ptbatch.workbook.systems import headers_in

COLOURS = {"jacked": "1F4E79", "set": "7F7F7F", "anchored": "2E8B57", "service": "7030A0", "peak": "C00000"}
MARKERS = {"cracking": ("triangle", "E69F00"), "yield": ("square", "7030A0"), "peak": ("circle", "C00000")}
WIDTH, HEIGHT = 26.0, 11.0  # cm
THIN, THICK = 12_700, 22_225  # EMU
ROUND = {"SI": 100.0, "US": 10.0}  # MPa, ksi
PLACES = ("D3", "D26")


class Block(NamedTuple):
    """Cells that hold the points of a chart: first column, first row, number of rows, its columns."""

    column: int
    row: int
    rows: int
    columns: tuple[tuple[str, str], ...]

    @property
    def width(self) -> int:
        """Number of columns."""
        return len(self.columns)

    @property
    def after(self) -> int:
        """The column for a next block, one left free."""
        return self.column + self.width + 1

    @property
    def names(self) -> list[str]:
        """Heads of the columns."""
        return [" ".join(filter(None, column)) for column in self.columns]

    def cell(self, column: int, row: int) -> str:
        """Address of a cell, counted from 0 within the block."""
        return f"${get_column_letter(self.column + column)}{self.row + row}"

    def reference(self, sheet: Any, column: int) -> Reference:
        """The cells of a column."""
        place = self.column + column
        return Reference(sheet, place, self.row, place, self.row + self.rows - 1)


def add_charts(sheet: Any, points: Block, steps: Block, least_stress: float, system: System) -> None:
    """Tendon stress along the member, from a round number below the least of all; load over deflection
    with what happened; in the units of that system."""
    heads = headers_in(("x [mm]", "stress [MPa]", "deflection [mm]", "load [kN]"), system)
    stress = _chart("Tendon stress along the member", *heads[:2])
    least = floor(least_stress / ROUND[system]) * ROUND[system] if isfinite(least_stress) else 0.0
    stress.y_axis.scaling.min = max(0.0, least)
    for i, (name, stage) in enumerate(points.columns[2:], 2):
        analytic = name == "stress_analytic"
        _line(stress, sheet, points, i, f"{stage}, analytic" if analytic else stage, COLOURS[stage], analytic)
    curve = _chart("Live load over deflection", *heads[2:])
    _line(curve, sheet, steps, 2, "load", "1F4E79")
    for i, (_, event) in enumerate(steps.columns[3:], 3):
        _marks(curve, sheet, steps, i, event)
    for chart, place in zip((stress, curve), PLACES, strict=True):
        sheet.add_chart(chart, place)


def _chart(title: str, x: str, y: str) -> ScatterChart:
    chart = ScatterChart(scatterStyle="lineMarker")
    chart.title, chart.x_axis.title, chart.y_axis.title = title, x, y
    chart.width, chart.height, chart.legend.position = WIDTH, HEIGHT, "r"
    for axis in (chart.x_axis, chart.y_axis):
        axis.delete, axis.number_format, axis.majorTickMark = False, "0", "out"
        axis.tickLblPos = "low"
    chart.x_axis.majorGridlines = None
    chart.y_axis.majorGridlines.spPr = GraphicalProperties(ln=LineProperties(solidFill="D9D9D9"))
    chart.display_blanks = "gap"
    return chart


def _series(chart: ScatterChart, sheet: Any, block: Block, column: int, title: str) -> Any:
    series = Series(block.reference(sheet, column), block.reference(sheet, 1), title=title)
    series.smooth = False
    chart.series.append(series)
    return series


def _line(
    chart: ScatterChart, sheet: Any, block: Block, column: int, title: str, colour: str, dashed: bool = False
) -> None:
    series = _series(chart, sheet, block, column, title)
    series.marker.symbol = "none"
    line = series.graphicalProperties.line
    line.solidFill, line.width = colour, THIN if dashed else THICK
    if dashed:
        line.dashStyle = "dash"


def _marks(chart: ScatterChart, sheet: Any, block: Block, column: int, event: str) -> None:
    series = _series(chart, sheet, block, column, event)
    series.graphicalProperties.line.noFill = True
    series.marker.symbol, series.marker.size = MARKERS[event][0], 9
    for part in (series.marker.graphicalProperties, series.marker.graphicalProperties.line):
        part.solidFill = MARKERS[event][1]
