"""Iterations and time of a member, stage by stage."""

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from benchmarks.table import Table
from ptbatch.analysis import Run, analyse, jacking_stress, prepare, serve, stress
from ptbatch.member import Member
from ptbatch.model.arrays import set_up

REPEATS = 7
POINTS = 130  # recorded at least, as OpenSees does of the reference beam


@dataclass(frozen=True)
class Timed:
    """Iterations and seconds of stages 1 to 3 and of the live load, seconds of all that is not iterated, and
    the steps recorded."""

    stressing: tuple[int, float]
    serving: tuple[int, float]
    whole: float
    points: int

    @property
    def iterations(self) -> int:
        """Of all stages."""
        return self.stressing[0] + self.serving[0]

    @property
    def iterating(self) -> float:
        """Seconds in the kernels."""
        return self.stressing[1] + self.serving[1]


def stressed(member: Member) -> Run:
    """A member after stage 3."""
    setup = set_up(member)
    run = prepare(setup, jacking_stress(setup))
    stress(run)
    return run


def timed(member: Member, refine: float = 1.0, repeats: int = REPEATS) -> Timed:
    """The least time of several analyses."""
    runs = [_once(member, refine) for _ in range(repeats)]
    whole = min(_seconds(lambda: analyse(member, refine=refine)) for _ in range(repeats))
    first = min(runs, key=lambda run: run.stressing[1])
    second = min(runs, key=lambda run: run.serving[1])
    return Timed(first.stressing, second.serving, whole, first.points)


def _seconds(work: Callable[[], object]) -> float:
    start = perf_counter()
    work()
    return perf_counter() - start


def _once(member: Member, refine: float) -> Timed:
    setup = set_up(member)
    run = prepare(setup, jacking_stress(setup))
    case = run.rig.case
    stressing = _seconds(lambda: stress(run))
    used = int(case.work.spent[0])
    serving = _seconds(lambda: serve(run, refine))
    return Timed((used, stressing), (int(case.work.spent[0]) - used, serving), 0.0, int(case.history.rows[0]))


def finer(member: Member) -> float:
    """The division of the live steps that records as many points as the reference, and hardly more."""
    for refine in np.arange(1.0, 8.0, 0.05):
        if _once(member, refine).points >= POINTS:
            return float(refine)
    raise RuntimeError(f"{member.member}: fewer than {POINTS} points")


def stage_table(members: dict[str, Member], repeats: int = REPEATS) -> Table:
    """A row for each member: iterations, and microseconds for each of them, by stage."""
    table = Table(
        "Iterations and time of a member, one thread",
        ["member", "points", "iterations", "stages 1-3", "us/iteration", "live load", "us/iteration"]
        + ["ms iterating", "ms in all"],
    )
    for name, member in members.items():
        refines = [1.0, finer(member)] if name == "15 m beam" else [1.0]
        for refine in refines:
            t = timed(member, refine, repeats)
            (a, first), (b, second) = t.stressing, t.serving
            label = name if refine == 1.0 else f"{name}, {t.points} points"
            table.add(
                label, t.points, t.iterations, a, 1e6 * first / a, b, 1e6 * second / b,
                1e3 * t.iterating, 1e3 * t.whole,
            )  # fmt: skip
    return table
