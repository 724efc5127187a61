"""A table of members in, a workbook of results out."""

import os
import platform
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from threading import Event
from time import perf_counter
from typing import Any

from ptbatch import __version__
from ptbatch.errors import WriteError
from ptbatch.journal.journal import Journal, journal_path
from ptbatch.pairing import Pair, Pairing
from ptbatch.runner import Outcomes, on_threads
from ptbatch.spool import Lines
from ptbatch.workbook import columnar, delimited
from ptbatch.workbook.arrow import has_arrow, load_arrow
from ptbatch.workbook.column import System
from ptbatch.workbook.filed import LONG_TABLES, place_of
from ptbatch.workbook.inputs import Inputs, read_inputs
from ptbatch.workbook.output import Output
from ptbatch.workbook.read_ahead import ReadAhead
from ptbatch.workbook.results import NOT_ANALYSED, summary_headers, summary_line

STATUSES = ("ok", "warning", "invalid", "not converged", NOT_ANALYSED)
MANY = 2_000  # members whose long tables make a workbook that Excel can still open at ease
NO_WORKBOOKS = (*delimited.SUFFIXES, *columnar.SUFFIXES)

Progress = Callable[[int, int, Sequence[Any]], None]  # rows done, rows in all, the last one's summary


@dataclass(frozen=True)
class Batch:
    """What a run gave: the summary, how many rows of each status, the file wanted and the one written.

    known: rows whose outcomes were in the journal. tables: folder of the long tables if they are files.
    """

    inputs: Inputs
    headers: list[str]
    lines: Lines
    counts: dict[str, int]
    wanted: Path
    path: Path
    known: int = 0
    tables: Path | None = None

    @property
    def failed(self) -> bool:
        """Whether a row is invalid or did not converge."""
        return bool(self.counts["invalid"] or self.counts["not converged"])

    @property
    def checks_failed(self) -> bool:
        """Whether a check by a standard fails."""
        at = self.headers.index("checks")
        return any(line[at] == "fail" for line in self.lines)

    @property
    def interrupted(self) -> bool:
        """Whether rows were not reached."""
        return bool(self.counts[NOT_ANALYSED])


def results_path(source: Path) -> Path:
    """`beams.xlsx` gives `beams.results.xlsx`, beside it."""
    return source.with_name(f"{source.stem}.results.xlsx")


def run_workbook(
    source: Path,
    output: Path | None = None,
    jobs: int = 1,
    only: Iterable[str] = (),
    progress: Progress | None = None,
    outcomes: Outcomes | None = None,
    *,
    resume: bool = False,
    parquet: Path | None = None,
    stop: Event | None = None,
    units: System | None = None,
    ahead: ReadAhead | None = None,
) -> Batch:
    """Analyse the members of a workbook, a CSV or a Parquet file and write the results workbook.

    only: names of members, all if empty. outcomes: who analyses them, `jobs` threads if None. resume: take
    what an unfinished run of the same output left in its journal. parquet: folder for the long tables; one
    is made if there are MANY members. stop: once it is set, rows that have not begun are not analysed. units:
    of the results, those of the input if None. ahead: who may be reading the workbook already.

    Raises ReadError, UnknownMemberError, WriteError, MissingArrowError; KeyboardInterrupt if `stop` is set
    before the first row.
    """
    start, started = perf_counter(), datetime.now()
    only, stop = tuple(only), stop or Event()
    path = output or results_path(source)
    inputs = read_inputs(source, ahead)
    inputs = inputs.only(only) if only else inputs
    check_target(path, source)
    if stop.is_set():
        raise KeyboardInterrupt  # there is nothing yet to be written
    folder, system = tables_folder(path, len(inputs.rows), parquet), units or inputs.system
    with Journal(journal_path(path), resume) as journal, _output(path, inputs, folder, system) as results:
        pairs = Pairing(inputs.rows, outcomes or on_threads(jobs, stop), journal, stop)
        lines = _run(pairs, results, len(inputs.rows), progress, system)
        counts = _counts(lines)
        run = {
            **_identity(started, inputs),
            **{"jobs": "on other machines" if outcomes else jobs, "only": "; ".join(only) or "all rows"},
            "units of the results": system,
            **{f"setting {name}": setting.raw for name, setting in inputs.settings.defaults.items()},
            **{"rows": len(lines), **{f"rows {status}": count for status, count in counts.items()}},
            **{"rows from the journal": journal.used, LONG_TABLES: place_of(folder, path)},
            "wall time [s]": perf_counter() - start,
        }
        written = results.finish(run)
        if not counts[NOT_ANALYSED]:
            journal.remove()
    return Batch(inputs, summary_headers(inputs, system), lines, counts, path, written, journal.used, folder)


def _run(
    pairs: Iterable[Pair], results: Output, total: int, progress: Progress | None, system: System
) -> Lines:
    """Put every row with its outcome into the results as it comes; the lines of the summary."""
    lines = Lines()
    for row, found in pairs:
        outcome = found and found.in_system(system)
        line = summary_line(row, outcome, system)
        lines.add(line)
        results.add(row, line, outcome)
        if progress:
            progress(len(lines), total, line)
    return lines


def _counts(lines: Lines) -> dict[str, int]:
    """Number of rows of each status."""
    tally = Counter(line[1] for line in lines)
    return {status: tally[status] for status in STATUSES}


def tables_folder(path: Path, rows: int, wanted: Path | None) -> Path | None:
    """Folder of Parquet files for the long tables, None where the workbook holds them: `beams.results.xlsx`
    has `beams.results.tables`, beside it. Raises MissingArrowError if they are wanted and cannot be."""
    if wanted:
        load_arrow()
        return wanted
    return path.with_suffix(".tables") if rows > MANY and has_arrow() else None


@contextmanager
def _output(path: Path, inputs: Inputs, folder: Path | None, system: System) -> Iterator[Output]:
    """Results whose temporary files are gone at the end, whatever happens."""
    output = Output(path, inputs, folder, system)
    try:
        yield output
    finally:
        output.discard()


def check_target(path: Path, source: Path) -> None:
    """Raise WriteError before the work rather than after it."""
    if path.resolve() == source.resolve():
        raise WriteError(f"{path} is the input, which is never touched; give another name with -o")
    if path.suffix.lower() in NO_WORKBOOKS:
        raise WriteError(f"{path}: results are a workbook, .xlsx; --parquet FOLDER writes tables to files")
    if not path.parent.is_dir():
        raise WriteError(f"{path} cannot be written: there is no folder {path.parent}")
    if not os.access(path.parent, os.W_OK):
        raise WriteError(f"{path} cannot be written: the folder is read-only; give another one with -o")


def _identity(started: datetime, inputs: Inputs) -> dict[str, Any]:
    """What was run on what, and where."""
    return {
        "ptbatch": __version__,
        **{name: _version(name) for name in ("numba", "numpy", "scipy")},
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
