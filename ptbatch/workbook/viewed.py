"""What the charts of the sheet `viewer` show of a member, as values: the twin of its formulas."""

from collections.abc import Sequence
from typing import Any

from ptbatch.workbook.column import System
from ptbatch.workbook.places import VIEWED, stage_rows
from ptbatch.workbook.results import Outcome
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
    stages = {stage: stage_rows(outcome, stage) for stage in VIEWED}
    points = stage_rows(outcome, outcome.tendon[0]["stage"])
    x, fe, analytic = headers_in(("x [mm]", "stress_fe [MPa]", "stress_analytic [MPa]"), system)
    headers = {"stress_fe": fe, "stress_analytic": analytic}
    return [
        [
            points[min(i, len(points) - 1)][x],
            *(_at(stages[stage], i, headers[name]) for name, stage in POINT_COLUMNS[2:]),
        ]
        for i in range(rows)
    ]


def curve_values(outcome: Outcome, rows: int, system: System) -> list[list[Value]]:
    """Values of CURVE_COLUMNS but the first."""
    curve = outcome.curves
    deflection, load = headers_in(("deflection [mm]", "load [kN]"), system)
    return [
        [
            _at(curve, i, deflection),
            _at(curve, i, load),
            *(
                _at(curve, i, load) if i < len(curve) and event in curve[i]["event"] else NOT_AVAILABLE
                for _, event in CURVE_COLUMNS[3:]
            ),
        ]
        for i in range(rows)
    ]


def _at(rows: Sequence[Any], i: int, header: str) -> Value:
    return rows[i][header] if i < len(rows) else NOT_AVAILABLE
