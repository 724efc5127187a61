"""What the charts of the sheet `viewer` show of a member, as values: the twin of its formulas."""

from collections.abc import Sequence
from typing import Any

from ptbatch.workbook.column import System
from ptbatch.workbook.places import VIEWED, at_stage
from ptbatch.workbook.results import Outcome, rows_in
from ptbatch.workbook.stored_values import NOT_AVAILABLE
from ptbatch.workbook.systems import headers_in

Value = float | str
Names = tuple[tuple[str, str], ...]

# Columns: (quantity, stage) and (quantity, event); the first numbers the rows, the second is the abscissa.
POINT_COLUMNS: Names = (
    ("point", ""),
    ("x [mm]", ""),
    *(("stress_fe", stage) for stage in VIEWED),
    *(("stress_analytic", stage) for stage in ("jacked", "anchored")),
)
CURVE_COLUMNS: Names = (
    ("step", ""),
    ("deflection [mm]", ""),
    ("load [kN]", ""),
    *(("load at", event) for event in ("cracking", "yield", "peak")),
)


def point_values(outcome: Outcome, rows: int, system: System) -> list[list[Value]]:
    """Values of POINT_COLUMNS but the first; x stays at the last point beyond it."""
    stages = {stage: at_stage(outcome, stage) for stage in VIEWED}
    points = at_stage(outcome, outcome.tendon["stage"][0])
    x, fe, analytic = headers_in(("x [mm]", "stress_fe [MPa]", "stress_analytic [MPa]"), system)
    headers = {"stress_fe": fe, "stress_analytic": analytic}
    return [
        [
            points[x][min(i, rows_in(points) - 1)],
            *(_at(stages[stage][headers[name]], i) for name, stage in POINT_COLUMNS[2:]),
        ]
        for i in range(rows)
    ]


def curve_values(outcome: Outcome, rows: int, system: System) -> list[list[Value]]:
    """Values of CURVE_COLUMNS but the first."""
    headers = headers_in(("deflection [mm]", "load [kN]"), system)
    deflection, load, events = (outcome.curves.get(header, ()) for header in (*headers, "event"))
    return [
        [
            _at(deflection, i),
            _at(load, i),
            *(
                _at(load, i) if i < len(events) and event in events[i] else NOT_AVAILABLE
                for _, event in CURVE_COLUMNS[3:]
            ),
        ]
        for i in range(rows)
    ]


def _at(column: Sequence[Any], i: int) -> Value:
    return column[i] if i < len(column) else NOT_AVAILABLE
