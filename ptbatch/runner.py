"""Members to outcomes, on threads: the kernels let go of the interpreter, each row stands for itself.

A run needs one callable, `Outcomes`: it takes members one by one, as they are read, and gives their outcomes
in the same order. Threads of this process are one, a cluster may be another.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from threading import Event
from time import perf_counter

from ptbatch.first_run import compile_ahead
from ptbatch.member import Member
from ptbatch.turns import turns
from ptbatch.workbook.results import DETAILS, NOT_ANALYSED, SUMMARY, Columns, Outcome

Outcomes = Callable[[Iterable[Member]], Iterator[Outcome]]
AHEAD = 32  # members taken in advance, a worker: a slow one shall not let the others wait
POLL = 0.5  # s; on Windows a wait without end does not hear Ctrl-C

CRASHED = f"{NOT_ANALYSED}: internal error"
STOPPED = f"{NOT_ANALYSED}: interrupted"


def on_threads(jobs: int, stop: Event | None = None) -> Outcomes:
    """Outcomes from so many threads. After `stop` is set, members that have not begun are not analysed."""

    def outcomes(members: Iterable[Member]) -> Iterator[Outcome]:
        pool = ThreadPoolExecutor(max_workers=jobs)
        try:
            yield from _in_order(pool, members, jobs * AHEAD, stop or Event())
        finally:
            pool.shutdown(wait=False, cancel_futures=True)

    return outcomes


def _in_order(
    pool: ThreadPoolExecutor, members: Iterable[Member], ahead: int, stop: Event
) -> Iterator[Outcome]:
    """Outcomes in the order of the members, of which at most so many are taken ahead. This thread, which
    reads members and uses outcomes, has its turns after those that analyse."""
    analyse: Callable[[Member], Outcome] | None = None
    queue: deque[Future[Outcome]] = deque()
    with turns.taken(sooner=False):
        for member in members:
            analyse = analyse or _compiling_engine()
            queue.append(pool.submit(_unless_stopped, analyse, member, stop))
            turns.offered()
            while queue and (queue[0].done() or len(queue) >= ahead):
                yield _result(queue.popleft())
        while queue:
            yield _result(queue.popleft())


def _compiling_engine() -> Callable[[Member], Outcome]:
    """The engine of this process, for which another one compiles ahead."""
    compile_ahead()
    return engine()


def _unless_stopped(analyse: Callable[[Member], Outcome], member: Member, stop: Event) -> Outcome:
    return not_analysed(STOPPED) if stop.is_set() else analyse(member)


def _result(future: Future[Outcome]) -> Outcome:
    with turns.left():
        while not wait([future], POLL).done:
            pass
    return future.result()


def engine() -> Callable[[Member], Outcome]:
    """The analysis of one member, which raises nothing: an exception in one row stays in that row.

    What it needs is imported here, before any thread starts.
    """
    from ptbatch.analysis import analyse
    from ptbatch.design.checks import checks, subject
    from ptbatch.tables import (
        check_table,
        crack_table,
        curve_table,
        elongation_table,
        loss_table,
        moment_table,
        reaction_table,
        summary_row,
        tendon_table,
    )

    @turns.taken()
    def run(member: Member) -> Outcome:
        start = perf_counter()
        try:
            response = analyse(member)
            time = 1e3 * (perf_counter() - start)
            about = subject(member, response)
            found = checks(about)
            summary = {"time [ms]": time} | summary_row(member, response, found)
            tables = {
                "tendon": tendon_table(member, response),
                "curves": curve_table(response),
                "cracks": crack_table(response),
                "checks": check_table(found),
                "elongation": elongation_table(member, response),
                "losses": loss_table(response),
                "moments": moment_table(about),
                "reactions": reaction_table(about),
            }
            return Outcome(
                response.status,
                response.message,
                {header: summary[header] for header in SUMMARY},
                **{name: _checked(table, DETAILS[name][1:]) for name, table in tables.items()},
            )
        except Exception as error:
            return _crashed(error)

    return run


def not_analysed(why: str, status: str = NOT_ANALYSED, message: str = "") -> Outcome:
    """Outcome of a member of which there are no results."""
    return Outcome(status, message or why, dict.fromkeys(SUMMARY, why))


def _checked(table: Columns, headers: Sequence[str]) -> Columns:
    """A table with its columns in order, all of one length."""
    if not table:
        return {}
    columns = {header: table[header] for header in headers}
    assert len({len(values) for values in columns.values()}) == 1
    return columns


def _crashed(error: Exception) -> Outcome:
    message = f"internal error: {type(error).__name__}: {error}; please report it, with this row"
    return not_analysed(CRASHED, "not converged", message)
