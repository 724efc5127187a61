"""How fast it is: `python -m benchmarks.speed` times members, parts, workers, growth and start-up.

--only takes one of them (may be repeated), --quick less of each; --write puts the tables into
benchmarks/results.md, in place of what is there of them. Leave the machine alone meanwhile.
"""

import argparse
from collections.abc import Callable

from benchmarks.machine import machine
from benchmarks.named import named
from benchmarks.opensees import opensees_table
from benchmarks.parts import part_table
from benchmarks.processes import start_table
from benchmarks.record import write_results
from benchmarks.stagewise import stage_table
from benchmarks.table import Table
from benchmarks.volume import element_table, mixed_table, row_table, worker_table


def benchmarks(quick: bool) -> dict[str, Callable[[], Table]]:
    """What can be measured, by name."""
    repeats = 3 if quick else 7
    return {
        "members": lambda: stage_table(named(), repeats),
        "parts": lambda: part_table(named()),
        "opensees": lambda: opensees_table(repeats),
        "workers": lambda: worker_table(60 if quick else 300),
        "elements": lambda: element_table([20, 40] if quick else [20, 40, 80, 160], repeats),
        "rows": lambda: row_table([10, 100] if quick else [10, 100, 1_000, 10_000]),
        "mixed": lambda: mixed_table(100 if quick else 1_000),
        "start": lambda: start_table(repeats, cold=not quick),
    }


def main() -> None:
    """Run it."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("--only", action="append", choices=benchmarks(True), metavar="WHAT")
    options.add_argument("--quick", action="store_true")
    options.add_argument("--write", action="store_true")
    chosen = options.parse_args()
    if chosen.write and chosen.quick:
        options.error("--write goes without --quick: it is no measurement")
    print(machine())
    tables = []
    for name, measure in benchmarks(chosen.quick).items():
        if not chosen.only or name in chosen.only:
            tables.append(measure())
            print(f"\n{tables[-1].text()}", flush=True)
    if chosen.write:
        write_results(tables, everything=not chosen.only)


if __name__ == "__main__":
    main()
