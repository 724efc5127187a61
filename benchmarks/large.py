"""Time and memory of a large job: `python -m benchmarks.large 10000 [RUN OPTIONS]`.

Writes a CSV of so many light members (4 elements, 8 layers) into a temporary folder and runs it there. With
`--no-analysis` the engine is left out: what remains is reading, validating and writing.
"""

import csv
import resource
import sys
import tempfile
from pathlib import Path
from time import perf_counter

from ptbatch import cli, runner
from ptbatch.workbook.results import DETAILS, SUMMARY, Outcome

BEAM = {"member": "", "span": 12000, "b": 300, "h": 600, "fc": 40, "Aps": 592, "dp": "300; 500; 300"}
LIGHT = BEAM | {"fpj": 1395, "elements": 4, "layers": 8}
ROWS = {"tendon": 28, "curves": 66, "cracks": 4, "checks": 0, "elongation": 1}  # of such a member


def write(path: Path, count: int) -> None:
    """Members that differ in name and span."""
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, list(LIGHT))
        table.writeheader()
        for i in range(count):
            table.writerow(LIGHT | {"member": f"B{i}", "span": 12000 + i % 100})


def made_up() -> Outcome:
    """An outcome as large as that of a light member."""
    texts = dict.fromkeys(("stage", "event", "failure"), "peak")
    rows = {
        name: [{header: texts.get(header, 1 / 3) for header in headers[1:]}] * ROWS[name]
        for name, headers in DETAILS.items()
    }
    return Outcome("ok", "", {header: texts.get(header, 1 / 3) for header in SUMMARY}, **rows)


def main(count: int, *options: str) -> None:
    """Run so many members and tell what it took."""
    if "--no-analysis" in options:
        outcome = made_up()
        runner.engine = lambda: lambda member: outcome
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "members.csv"
        write(path, count)
        start = perf_counter()
        code = cli.exit_code(["run", str(path), *(o for o in options if o != "--no-analysis")])
        seconds = perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    each = 1e3 * seconds / count
    print(f"exit code {code}: {count} rows, {seconds:.1f} s, {each:.2f} ms a row, {peak:.0f} MB at most")


if __name__ == "__main__":
    main(int(sys.argv[1]), *sys.argv[2:])
