"""The sheets of a results workbook, their columns exactly as offices rely on them."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import repeat
from typing import Any

from ptbatch.workbook.column import System
from ptbatch.workbook.inputs import Inputs
from ptbatch.workbook.rows import Row
from ptbatch.workbook.sayable import sayable
from ptbatch.workbook.systems import columns_in, headers_in, record_in, sentence_in

HEAD = ("member", "status", "message")
SUMMARY = (
    "jacking_stress [MPa]",
    "elongation_before_set [mm]",
    "elongation_after_set [mm]",
    "loss_jacking_end_fe [%]",
    "loss_jacking_end_analytic [%]",
    "loss_fixed_end_fe [%]",
    "loss_fixed_end_analytic [%]",
    "set_length_fe [mm]",
    "set_length_analytic [mm]",
    "stress_anchored_min [MPa]",
    "stress_anchored_mean [MPa]",
    "stress_anchored_max [MPa]",
    "camber_anchored [mm]",
    "load_cracking [kN]",
    "load_yield [kN]",
    "load_peak [kN]",
    "load_factor_peak",
    "deflection_peak [mm]",
    "moment_peak [kN m]",
    "tendon_stress_peak_mean [MPa]",
    "tendon_stress_peak_max [MPa]",
    "failure",
    "residual_max",
    "newton_iterations",
    "time [ms]",
    "failure_x [mm]",
    "failure_load [kN]",
    "failure_deflection [mm]",
    "checks",
    "utilisation_max",
    "governing_check",
    "stress_service_mean [MPa]",
    "camber_service [mm]",
)
TENDON = ("member", "stage", "x [mm]", "stress_fe [MPa]", "stress_analytic [MPa]", "slip [mm]")
CURVES = (
    "member",
    "step",
    "load_factor",
    "load [kN]",
    "deflection [mm]",
    "moment_max [kN m]",
    "tendon_stress_min [MPa]",
    "tendon_stress_mean [MPa]",
    "tendon_stress_max [MPa]",
    "event",
)
CRACKS = ("member", "stage", "step", "x [mm]", "crack_from [mm]", "crack_to [mm]")
CHECKS = (
    "member",
    "check",
    "clause",
    "x [mm]",
    "formula",
    "numbers",
    "demand",
    "limit",
    "unit",
    "utilisation",
    "outcome",
    "reason",
)
ELONGATION = (
    "member",
    "end",
    "jack_force [kN]",
    "before_set [mm]",
    "after_set [mm]",
    "least [mm]",
    "most [mm]",
    "to_read",
    "warning",
)
LOSSES = ("member", "cause", "source", "loss [MPa]", "share [%]", "stress_after [MPa]")
MOMENTS = (
    "member",
    "x [mm]",
    "self_weight [kN m]",
    "dead [kN m]",
    "live [kN m]",
    "live_max [kN m]",
    "live_min [kN m]",
    "primary [kN m]",
    "secondary [kN m]",
    "service [kN m]",
)
REACTIONS = ("member", "support", "x [mm]", "self_weight [kN]", "dead [kN]", "live [kN]", "secondary [kN]")
# Tables of many rows a member; its name stands in the first column
DETAILS = {
    "losses": LOSSES,
    "tendon": TENDON,
    "curves": CURVES,
    "cracks": CRACKS,
    "checks": CHECKS,
    "moments": MOMENTS,
    "reactions": REACTIONS,
    "elongation": ELONGATION,
}
PROBLEMS = ("sheet", "cell", "column", "value", "what is wrong", "how to put it right")
INVALID = "invalid input"
NOT_ANALYSED = "not analysed"


Columns = Mapping[str, Sequence[Any]]  # a table of one member by header, but for its name; {} without rows


@dataclass(frozen=True)
class Outcome:
    """Result of one member: a summary and the tables in DETAILS, by the headers above, or by those of another
    unit system."""

    status: str
    message: str
    summary: Mapping[str, Any]
    tendon: Columns = field(default_factory=dict)
    curves: Columns = field(default_factory=dict)
    cracks: Columns = field(default_factory=dict)
    checks: Columns = field(default_factory=dict)
    elongation: Columns = field(default_factory=dict)
    losses: Columns = field(default_factory=dict)
    moments: Columns = field(default_factory=dict)
    reactions: Columns = field(default_factory=dict)

    @property
    def analysed(self) -> bool:
        """Whether these are results: no interruption, no internal error."""
        return not any(str(value).startswith(NOT_ANALYSED) for value in self.summary.values())

    def in_system(self, system: System) -> "Outcome":
        """The same by the headers of a unit system."""
        if system == "SI":
            return self
        tables = {name: columns_in(getattr(self, name), system) for name in DETAILS}
        message = sentence_in(self.message, system)
        return Outcome(self.status, message, record_in(self.summary, system), **tables)


def summary_headers(inputs: Inputs, system: System) -> list[str]:
    """Headers of the summary, the unknown columns of the input last."""
    own = [*HEAD, *headers_in(SUMMARY, system)]
    return own + [f"{header} (input)" if header in own else header for header in inputs.extra_headers]


def summary_line(row: Row, outcome: Outcome | None, system: System) -> list[Any]:
    """Line of a row; outcome, in that system, is None where the row is invalid."""
    if outcome is None:
        return [row.name, "invalid", row.message, *[INVALID] * len(SUMMARY), *row.extra]
    status = "warning" if outcome.status == "ok" and row.problems else outcome.status
    message = "; ".join(text for text in (outcome.message, row.message) if text)
    return [
        row.name,
        status,
        message,
        *(outcome.summary[header] for header in headers_in(SUMMARY, system)),
        *row.extra,
    ]


def summary_records(headers: Sequence[str], lines: Iterable[Sequence[Any]]) -> Iterator[dict[str, Any]]:
    """The summary for JSON, a dictionary by header for each row."""
    return (dict(zip(headers, map(sayable, line), strict=True)) for line in lines)


def rows_in(columns: Columns) -> int:
    """How many rows a table has."""
    return len(next(iter(columns.values()), ()))


def named(name: str, columns: Columns) -> list[Sequence[Any]]:
    """The columns of one of the DETAILS, the name of the member before them."""
    return [list(repeat(name, rows_in(columns))), *columns.values()]
