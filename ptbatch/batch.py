"""A workbook in, a workbook out."""

import os
import platform
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from time import perf_counter
from typing import Any

from ptbatch import __version__
from ptbatch.errors import WriteError
from ptbatch.runner import Progress, run_members
from ptbatch.workbook.inputs import Inputs, read_inputs
from ptbatch.workbook.results import Outcome, result_sheets, summary_headers, summary_line
from ptbatch.workbook.write import write_workbook

STATUSES = ("ok", "warning", "invalid", "not converged")


@dataclass(frozen=True)
class Batch:
    """What a run gave: the summary, how many rows of each status, the file wanted and the one written."""

    inputs: Inputs
    headers: list[str]
    lines: list[list[Any]]
    counts: dict[str, int]
    wanted: Path
    path: Path

    @property
    def failed(self) -> bool:
        """Whether a row is invalid or did not converge."""
        return bool(self.counts["invalid"] or self.counts["not converged"])


def results_path(source: Path) -> Path:
    """`beams.xlsx` gives `beams.results.xlsx`, beside it."""
    return source.with_name(f"{source.stem}.results.xlsx")


def run_workbook(
    source: Path,
    output: Path | None = None,
    jobs: int = 1,
    only: Iterable[str] = (),
    progress: Progress | None = None,
) -> Batch:
    """Analyse the members of a workbook and write the results workbook.

    only: names of members, all if empty. Raises ReadError, UnknownMemberError, WriteError.
    """
    start, started = perf_counter(), datetime.now()
    only = tuple(only)
    path = output or results_path(source)
    inputs = read_inputs(source)
    inputs = inputs.only(only) if only else inputs
    check_target(path, source)
    outcomes = _outcomes(inputs, jobs, progress)
    lines = [summary_line(row, outcome) for row, outcome in zip(inputs.rows, outcomes, strict=True)]
    tally = Counter(line[1] for line in lines)
    counts = {status: tally[status] for status in STATUSES}
    run = {
        **_identity(started, inputs),
        **{"jobs": jobs, "only": "; ".join(only) or "all rows"},
        **{f"setting {name}": setting.raw for name, setting in inputs.settings.defaults.items()},
        **{"rows": len(lines), **{f"rows {status}": count for status, count in counts.items()}},
        "wall time [s]": perf_counter() - start,
    }
    written = write_workbook(path, result_sheets(inputs, lines, outcomes, run))
    return Batch(inputs, summary_headers(inputs), lines, counts, path, written)


def check_target(path: Path, source: Path) -> None:
    """Raise WriteError before the work rather than after it."""
    if path.resolve() == source.resolve():
        raise WriteError(f"{path} is the input, which is never touched; give another name with -o")
    if not path.parent.is_dir():
        raise WriteError(f"{path} cannot be written: there is no folder {path.parent}")
    if not os.access(path.parent, os.W_OK):
        raise WriteError(f"{path} cannot be written: the folder is read-only; give another one with -o")


def _outcomes(inputs: Inputs, jobs: int, progress: Progress | None) -> list[Outcome | None]:
    """Outcomes of all rows in their order, None for invalid ones."""
    members = [row.member for row in inputs.rows if row.member is not None]
    done = iter(run_members(members, jobs, progress))
    return [None if row.member is None else next(done) for row in inputs.rows]


def _identity(started: datetime, inputs: Inputs) -> dict[str, Any]:
    """What was run on what, and where."""
    return {
        "ptbatch": __version__,
        **{name: _version(name) for name in ("numba", "numpy")},
        "started": started.isoformat(" ", "seconds"),
        "input": str(inputs.path),
        "input sha256": inputs.sha256,
        "units of headers without one": inputs.settings.system,
        "machine": f"{platform.platform()}, {os.cpu_count()} CPUs, Python {platform.python_version()}",
    }


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"
