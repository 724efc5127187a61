"""How time and memory grow: with elements, with rows, with workers."""

import os
import tempfile
from pathlib import Path
from time import perf_counter, process_time

from openpyxl import load_workbook

from benchmarks.named import FOLLOWED, REFERENCE
from benchmarks.population import population
from benchmarks.processes import Usage, ptbatch
from benchmarks.rows import write_rows
from benchmarks.stagewise import timed
from benchmarks.table import Table
from ptbatch.analysis import analyse
from ptbatch.member import Member
from ptbatch.runner import on_threads
from ptbatch.workbook.echo import echo
from ptbatch.workbook.write import write_workbook


def element_table(counts: list[int], repeats: int) -> Table:
    """The reference beam with ever more elements, short of yield and to the end."""
    table = Table(
        "Growth with elements: the 15 m beam",
        ["elements", "deflection [mm]", "iterations", "us/iteration", "ms in all"],
        note=f"Bars yield beyond {FOLLOWED:g} mm. From there on sections soften one after the other, "
        "and the shorter the elements are, the more of them do.",
    )
    for limit in (FOLLOWED, None):
        for elements in counts:
            member = Member(
                member="15 m beam", **REFERENCE | {"elements": elements, "deflection_limit": limit}
            )
            response = analyse(member)
            if response.status != "ok":
                table.add(elements, member.deflection_limit, response.newton_iterations, "", response.status)
                table.note += f" {elements} elements: {response.message}."
                continue
            t = timed(member, 1, repeats)
            per_iteration = 1e6 * t.iterating / t.iterations
            table.add(elements, member.deflection_limit, t.iterations, per_iteration, 1e3 * t.whole)
    return table


def worker_table(count: int) -> Table:
    """A mixed population on one worker and on two."""
    members = population(count)
    list(on_threads(2)(members[:2]))
    table = Table(
        f"Members a second: {count} of the random population, tables included",
        ["workers", "members/s", "s", "cores used"],
        note="Cores used: CPU time by wall time. Well below the workers, the machine had other work.",
    )
    for workers in (1, 2):
        seconds, cores = min(_run(members, workers) for _ in range(3))
        table.add(workers, count / seconds, seconds, cores)
    return table


def _run(members: list[Member], workers: int) -> tuple[float, float]:
    """Seconds, and CPU time by wall time."""
    start, used = perf_counter(), process_time()
    list(on_threads(workers)(members))
    seconds = perf_counter() - start
    return seconds, (process_time() - used) / seconds


def row_table(counts: list[int]) -> Table:
    """`ptbatch run` of workbooks with ever more light rows, from start to exit."""
    table = Table(
        f"Growth with rows: ptbatch run of light rows (8 elements, 10 layers), {os.cpu_count()} workers",
        ["rows", "s", "ms/row", "peak memory [MB]", "results [MB]"],
    )
    for rows in counts:
        usage, size = run_rows(rows)
        table.add(rows, usage.seconds, 1e3 * usage.seconds / rows, usage.megabytes, size)
    return table


def mixed_table(count: int) -> Table:
    """`ptbatch run` of a workbook of the random population, from start to exit."""
    table = Table(
        f"Mixed rows: ptbatch run of {count} of the random population, {os.cpu_count()} workers",
        ["rows", "least s", "most s", "peak memory [MB]", "results [MB]"],
        note="Reading, analysis and writing, five times, all compiled. The input is saved as by Excel.",
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mixed.xlsx"
        write_workbook(path, echo(population(count)))
        load_workbook(path).save(path)  # as Excel does: texts are shared, the size of a sheet is said ahead
        runs = [_timed(path) for _ in range(5)]
    seconds = [usage.seconds for usage, _ in runs]
    table.add(count, min(seconds), max(seconds), max(usage.megabytes for usage, _ in runs), runs[0][1])
    return table


def run_rows(rows: int) -> tuple[Usage, float]:
    """What a run of that many rows used, and the size of its results [MB]."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "rows.xlsx"
        write_rows(path, rows)
        return _timed(path)


def _timed(path: Path) -> tuple[Usage, float]:
    usage = ptbatch("run", str(path), failed_rows=True)
    return usage, path.with_name(f"{path.stem}.results.xlsx").stat().st_size / 1e6
