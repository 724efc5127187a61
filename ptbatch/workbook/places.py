"""Where the rows of each member stand in the long sheets, for the formulas of the sheet `viewer`."""

from collections.abc import Mapping
from itertools import chain
from math import inf, isfinite
from typing import Any, NamedTuple

from ptbatch.workbook.column import System
from ptbatch.workbook.results import Columns, Outcome, rows_in
from ptbatch.workbook.systems import written

VIEWED = ("jacked", "set", "anchored", "service", "peak")  # stages
PLACES = ("member", "summary", *VIEWED, "points", "curves", "steps")
NONE = "none"  # where a member has no such rows


class Place(NamedTuple):
    """A member: its row in each sheet, counted from 1 below the headers; how many tendon points a stage has
    and how many steps its curve."""

    member: str
    summary: int
    stages: tuple[int | str, ...]
    points: int
    curves: int | str
    steps: int

    def line(self) -> list[Any]:
        """Its line under PLACES."""
        return [self.member, self.summary, *self.stages, self.points, self.curves, self.steps]


class Places:
    """Places of all members with results, in their order; the results of the first of them are kept.

    system: of the results.
    """

    def __init__(self, system: System = "SI") -> None:
        self.system = system
        self._stress = written("stress_fe [MPa]", system)[0]
        self.places: list[Place] = []
        self.first: tuple[Mapping[str, Any], Outcome] | None = None
        self.least_stress = inf
        self.rows = {"summary": 0, "tendon": 0, "curves": 0}

    def add(self, line: Mapping[str, Any], outcome: Outcome | None) -> None:
        """Count a row of the summary, by header, and the rows of its outcome."""
        self.rows["summary"] += 1
        if outcome is None or not rows_in(outcome.tendon):
            return
        self.first = self.first or (line, outcome)
        self.places.append(self._place(line["member"], outcome))
        self.least_stress = min(chain([self.least_stress], filter(isfinite, outcome.tendon[self._stress])))
        self.rows["tendon"] += rows_in(outcome.tendon)
        self.rows["curves"] += rows_in(outcome.curves)

    def _place(self, member: str, outcome: Outcome) -> Place:
        stages, steps = outcome.tendon["stage"], rows_in(outcome.curves)
        return Place(
            member,
            self.rows["summary"],
            tuple(self.rows["tendon"] + stages.index(s) + 1 if s in stages else NONE for s in VIEWED),
            stages.count(stages[0]),
            self.rows["curves"] + 1 if steps else NONE,
            steps,
        )

    @property
    def most_points(self) -> int:
        """Of a member at a stage."""
        return max(place.points for place in self.places)

    @property
    def most_steps(self) -> int:
        """Of a member's curve, at least 1."""
        return max(1, *(place.steps for place in self.places))


def at_stage(outcome: Outcome, stage: str) -> Columns:
    """What the sheet `tendon` has of a stage."""
    rows = [i for i, name in enumerate(outcome.tendon["stage"]) if name == stage]
    return {header: [values[i] for i in rows] for header, values in outcome.tendon.items()}
