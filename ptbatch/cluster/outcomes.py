"""Outcomes from a cluster, in the order of the members.

Finished chunks stay on their workers until their turn comes, so that memory here does not grow with the rows.
"""

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice
from statistics import median
from threading import Event
from typing import TYPE_CHECKING

from ptbatch.cluster.scheduler import Chunk, Cluster
from ptbatch.cluster.worker import Values, values
from ptbatch.member import Member
from ptbatch.runner import STOPPED, Outcomes, not_analysed
from ptbatch.workbook.results import Outcome

if TYPE_CHECKING:
    from distributed import Future

CHUNK_SECONDS = 1.5  # of work in a chunk
FIRST_ROWS, MOST_ROWS = 4, 200  # in a chunk: before a time is known, and at most


def on_cluster(address: str, stop: Event | None = None) -> Outcomes:
    """Outcomes from the workers of the scheduler at `address`.

    An exception in one row stays in that row, and so does the death of all workers that take it. After `stop`
    is set nothing more is sent, and what is in flight is waited for GRACE seconds. Raise ClusterError.
    """

    def outcomes(members: Iterable[Member]) -> Iterator[Outcome]:
        rows = map(values, members)
        first = next(rows, None)
        if first is None:
            return
        cluster = Cluster(address, stop or Event())
        try:
            yield from _in_order(cluster, chain([first], rows))
        finally:
            cluster.close()

    return outcomes


def _in_order(cluster: Cluster, rows: Iterator[Values]) -> Iterator[Outcome]:
    """Outcomes in the order of the rows, of which a window of chunks is taken ahead."""
    flying: deque[tuple[Future, Chunk]] = deque()
    size = FIRST_ROWS
    while True:
        while len(flying) < cluster.window() and (chunk := list(islice(rows, size))):
            flying.append((cluster.submit(chunk), chunk))
        if not flying:
            break
        outcomes = cluster.collect(*flying.popleft())
        size = rows_of_a_chunk(outcomes)
        yield from outcomes
    yield from (not_analysed(STOPPED) for _ in rows)  # there are some left only if the run was stopped


def rows_of_a_chunk(outcomes: Sequence[Outcome]) -> int:
    """As many rows as take CHUNK_SECONDS; the median leaves out a row that waited for the compiler."""
    times = [time for outcome in outcomes if isinstance(time := outcome.summary["time [ms]"], float)]
    return min(max(int(1e3 * CHUNK_SECONDS / median(times)), 1), MOST_ROWS) if times else FIRST_ROWS
