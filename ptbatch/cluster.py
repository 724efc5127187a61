"""Members to outcomes on many machines: chunks of rows to the workers of a Dask scheduler, back in order.

Finished chunks stay on their workers until their turn comes, so that memory here does not grow with the rows.
What a lost worker had, in work or finished, Dask gives to another one. A worker of another version is found
out by its first chunk.
"""

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from itertools import islice
from statistics import median
from threading import Event
from time import monotonic
from typing import TYPE_CHECKING, Any

from ptbatch.errors import ClusterError
from ptbatch.member import Member
from ptbatch.runner import CRASHED, POLL, STOPPED, Outcomes, not_analysed
from ptbatch.workbook.results import Outcome
from ptbatch.worker import Values, analyse_rows, identity, values

if TYPE_CHECKING:
    from distributed import Client, Future

Chunk = list[Values]

CONNECT_SECONDS = 10
PATIENCE = 60.0  # seconds without any worker
CHUNK_SECONDS = 1.5  # of work in a chunk
FIRST_ROWS, MOST_ROWS = 4, 200  # in a chunk: before a time is known, and at most
LEAD = 4  # chunks in flight for each thread of the cluster
DIED = "internal error: every worker that took this row died; please report it, with this row"
CURE = "install the same ptbatch, with the same libraries, for the scheduler and all workers"


def on_cluster(address: str, stop: Event | None = None) -> Outcomes:
    """Outcomes from the workers of the scheduler at `address`.

    An exception in one row stays in that row, and so does the death of all workers that take it. After `stop`
    is set, members that are not finished are not waited for. The outcomes raise ClusterError.
    """

    def outcomes(members: Iterable[Member]) -> Iterator[Outcome]:
        cluster = _Cluster(address, stop or Event())
        try:
            yield from _in_order(cluster, map(values, members))
        finally:
            cluster.close()

    return outcomes


def _in_order(cluster: "_Cluster", rows: Iterator[Values]) -> Iterator[Outcome]:
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


class _Cluster:
    """The workers of a scheduler, as a place that chunks are sent to and collected from."""

    def __init__(self, address: str, stop: Event) -> None:
        self.address, self.stop = address, stop
        self.client = _connected(address)
        self.threads = 1
        self.looked = self.seen = monotonic()  # when workers were last looked for, and last there
        self._look()

    def close(self) -> None:
        """Leave the scheduler, which then drops what is in flight."""
        with suppress(OSError):
            self.client.close(timeout=CONNECT_SECONDS)

    def window(self) -> int:
        """Most chunks in flight, as the cluster is now."""
        if monotonic() > self.looked + 1.0:
            self._look()
        return 0 if self.stop.is_set() else LEAD * self.threads

    def submit(self, rows: Chunk) -> "Future":
        """Send rows off."""
        with self._connection():
            return self.client.submit(analyse_rows, identity(), rows, pure=False)

    def collect(self, future: "Future", rows: Chunk) -> list[Outcome]:
        """Wait for a chunk. Where workers die of it, its rows go one by one, to find the one that does it."""
        from distributed import KilledWorker

        if not self._done(future):
            return [not_analysed(STOPPED)] * len(rows)
        with self._connection():
            error = future.exception()
            if error is None:
                return _received(future.result())
        if not isinstance(error, KilledWorker):
            what = f"{type(error).__name__}: {' '.join(str(error).split())}"
            raise ClusterError(f"{self.address} cannot run ptbatch ({what[:200]}); {CURE}") from error
        if len(rows) == 1:
            return [not_analysed(CRASHED, "not converged", DIED)]
        return [outcome for row in rows for outcome in self.collect(self.submit([row]), [row])]

    def _done(self, future: "Future") -> bool:
        """Wait for a task; false if the run is stopped before it is done."""
        while not self.stop.is_set():
            try:
                with self._connection():
                    future.exception(timeout=POLL)
                return True
            except TimeoutError:
                self._look()
        return bool(future.done())

    def _look(self) -> None:
        """Count the threads of all workers. Raises ClusterError if there has been none for long."""
        with self._connection():
            threads = sum(self.client.nthreads().values())
        self.looked = monotonic()
        if threads:
            self.threads, self.seen = threads, self.looked
        elif self.looked > self.seen + PATIENCE:
            raise ClusterError(
                f"{self.address} has had no worker for {PATIENCE:g} s; start some: dask worker {self.address}"
            )

    @contextmanager
    def _connection(self) -> Iterator[None]:
        """A lost connection as ClusterError. TimeoutError passes: the scheduler is there, but busy."""
        from distributed import CancelledError
        from distributed.client import ClosedClientError

        try:
            yield
        except TimeoutError:
            raise
        except (OSError, CancelledError, ClosedClientError) as error:
            raise ClusterError(f"the scheduler at {self.address} is gone; start it and run again") from error


def _connected(address: str) -> "Client":
    """A client of the scheduler. Raises ClusterError with a cure."""
    try:
        from distributed import Client
    except ImportError as error:
        cure = "install it: python -m pip install 'ptbatch[cluster]'"
        raise ClusterError(f"--scheduler needs Dask distributed ({error}); {cure}") from error
    try:
        return Client(address, timeout=CONNECT_SECONDS, set_as_default=False)
    except (OSError, ValueError) as error:
        cure = "check the address that `dask scheduler` printed when it started, like tcp://HOST:8786"
        raise ClusterError(f"no scheduler answers at {address}; {cure}, and the firewall") from error


def _received(result: Mapping[str, Any]) -> list[Outcome]:
    """Outcomes from what `analyse_rows` gave. Raises ClusterError if they are of another version."""
    here, there = identity(), result["identity"]
    unlike = [
        f"{name} {there.get(name)} (here {here[name]})" for name in here if there.get(name) != here[name]
    ]
    if unlike:
        raise ClusterError(f"the worker at {result['worker']} has {', '.join(unlike)}; {CURE}")
    return [Outcome(**outcome) for outcome in result["outcomes"]]
