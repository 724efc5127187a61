"""`python tests/slow.py LOG ARGS`: ptbatch with an engine that takes its time and logs whom it analyses."""

import sys
from pathlib import Path
from time import sleep

from ptbatch import cli, runner
from ptbatch.workbook.results import CURVES, SUMMARY, Outcome

LOG, SECONDS = Path(sys.argv[1]), 0.02


def analyse(member):
    with LOG.open("a") as log:
        log.write(f"{member.member}\n")
    sleep(SECONDS)
    value = member.fc / 3.0
    curves = dict.fromkeys(CURVES[1:-1], [value]) | {"event": ["peak"]}
    return Outcome("ok", "", dict.fromkeys(SUMMARY, value), {}, curves)


if __name__ == "__main__":
    runner.engine = lambda: analyse
    cli.main(sys.argv[2:])
