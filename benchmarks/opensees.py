"""The reference beam in OpenSees beside ours, if openseespy is installed.

The same: span, section, 40 layers and bars, elements with 2 Gauss sections each on a corotational chord, a
tendon of straight trusses on the same profile that slides with friction, 30 steps of jacking, 100 of
displacement control to the same deflection, Newton's method. Not the same: Concrete02 and Steel02 for our
laws; a tendon node stays opposite its beam node, held by a spring across the duct and an elastic-plastic one
along it, whose capacity is a constant; no wedge set, the jack is locked with its force; a residual of 1e-7 of
the jacking force (ours: 1e-9), and Krylov-Newton or a line search for steps that Newton's method does not
manage.
"""

import json
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from benchmarks.named import FOLLOWED, REFERENCE
from benchmarks.stagewise import finer, timed
from benchmarks.table import Table
from ptbatch.member import Member

ELEMENTS = (20, 60)
MODEL = Path(__file__).with_name("opensees_model.py")
REPORTED = (  # on a machine like these, 2 cores, one thread
    ("OpenSees as reported, 20 elements", "130", "590", "260", "150"),
    ("OpenSees as reported, 60 elements", "130", "", "", "1700"),
)


def opensees_table(repeats: int) -> Table:
    """Ours and theirs, one thread each, in one run."""
    table = Table(
        "The 15 m beam beside OpenSees, one thread",
        ["", "points", "iterations", "us/iteration", "ms"],
        note="Reported: the four stages with friction, 30 + 100 steps. Measured: see benchmarks/opensees.py "
        "for what is the same and what is not; theirs are the times of its `analyze` alone.",
    )
    for elements in ELEMENTS:
        values = REFERENCE | {"elements": elements, "deflection_limit": FOLLOWED}
        member = Member(member="15 m beam", **values)
        t = timed(member, finer(member), repeats)
        table.add(
            f"ptbatch, {elements} elements", t.points, t.iterations, 1e6 * t.iterating / t.iterations,
            1e3 * t.whole,
        )  # fmt: skip
    for row in REPORTED:
        table.add(*row)
    if find_spec("openseespy") is None:
        table.note += " openseespy is not installed: nothing of OpenSees was measured."
        return table
    for elements in ELEMENTS:
        points, iterations, seconds = measured(elements, repeats)
        label = f"OpenSees measured, {elements} elements"
        table.add(label, points, iterations, 1e6 * seconds / iterations, 1e3 * seconds)
    return table


def measured(elements: int, repeats: int) -> tuple[int, int, float]:
    """(points, iterations, least seconds) of OpenSees, in processes of its own: it prints and holds state."""
    runs = []
    for _ in range(max(2, repeats // 2)):
        done = subprocess.run(
            [sys.executable, "-m", "benchmarks.opensees_model", str(elements)],
            capture_output=True,
            text=True,
            check=True,
            cwd=MODEL.parent.parent,
        )
        runs.append(json.loads(done.stdout.splitlines()[0]))
    points, iterations, seconds = min(runs, key=lambda run: run[2])
    return points, iterations, seconds
