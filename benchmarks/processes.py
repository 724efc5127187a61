"""Whole runs of the command in a process of their own: how long from start to exit, and how much memory."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from benchmarks.rows import write_rows
from benchmarks.table import Table

ROOT = Path(__file__).parent.parent
LAUNCHER = """
import subprocess, sys, time
start = time.perf_counter()
code = subprocess.call([sys.executable, "-m", "ptbatch", *sys.argv[1:]], stdout=subprocess.DEVNULL)
seconds = time.perf_counter() - start
try:
    from resource import RUSAGE_CHILDREN, getrusage
    print(seconds, getrusage(RUSAGE_CHILDREN).ru_maxrss)
except ImportError:
    print(seconds, "nan")
sys.exit(code)
"""  # a small process in between: the memory of one that starts another counts as that one's
LIMITS = {"--help": 0.3, "warm": 2.0, "cold": 40.0}  # s, that are wanted


class Usage(NamedTuple):
    """Wall time and largest resident memory of a process; nan where the system does not tell."""

    seconds: float
    megabytes: float


def ptbatch(*args: str, cache: Path | None = None, failed_rows: bool = False) -> Usage:
    """Run the command line and wait. failed_rows: some may fail, which makes its exit code 1."""
    paths = os.pathsep.join([str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])])
    changed = {"PYTHONPATH": paths} | ({"PTBATCH_CACHE": str(cache)} if cache else {})
    done = subprocess.run(
        [sys.executable, "-c", LAUNCHER, *args], capture_output=True, text=True, env=os.environ | changed
    )
    if done.returncode not in ((0, 1) if failed_rows else (0,)):
        raise RuntimeError(f"ptbatch {' '.join(args)}: exit code {done.returncode}\n{done.stderr}")
    seconds, memory = map(float, done.stdout.split())
    return Usage(seconds, memory / (1e6 if sys.platform == "darwin" else 1e3))


def start_table(repeats: int, cold: bool) -> Table:
    """Start-up of the command with a workbook of one row."""
    table = Table("Start-up [s]", ["what", "least", "most", "wanted", "peak memory [MB]"])
    with tempfile.TemporaryDirectory() as folder:
        path, cache = Path(folder) / "one.xlsx", Path(folder) / "cache"
        write_rows(path, 1)
        _add(table, "ptbatch --help", [ptbatch("--help") for _ in range(repeats)], LIMITS["--help"])
        _add(table, "ptbatch check, one row", [ptbatch("check", str(path)) for _ in range(repeats)], None)
        if cold:
            compiled = [ptbatch("run", str(path), cache=cache)]
            _add(table, "ptbatch run, one row, nothing compiled", compiled, LIMITS["cold"])
            table.note = _kept(cache)
        else:
            ptbatch("run", str(path))
        warm = [ptbatch("run", str(path), cache=cache if cold else None) for _ in range(repeats)]
        _add(table, "ptbatch run, one row", warm, LIMITS["warm"])
    return table


def _add(table: Table, what: str, usages: list[Usage], wanted: float | None) -> None:
    seconds = [usage.seconds for usage in usages]
    memory = max(usage.megabytes for usage in usages)
    table.add(what, min(seconds), max(seconds), "" if wanted is None else f"{wanted:g}", memory)


def _kept(cache: Path) -> str:
    files = list(cache.rglob("*.nbc"))
    kernels = {path.name.partition("-")[0] for path in files}
    size = sum(path.stat().st_size for path in files) / 1e6
    return f"Compiled: {len(kernels)} kernels in {len(files)} versions, {size:.0f} MB."
