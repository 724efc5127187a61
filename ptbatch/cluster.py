"""Members to outcomes on many machines: chunks of rows to the workers of a Dask scheduler, back in order.

Finished chunks stay on their workers until their turn comes, so that memory here does not grow with the rows.
What a lost worker had, in work or finished, Dask gives to another one. A worker of another version is found out
by its first chunk.
"""

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from itertools import islice
from statistics import median
from time import monotonic
from typing import TYPE_CHECKING

from ptbatch.errors import ClusterError
from ptbatch.member import Member
from ptbatch.runner import crashed
from ptbatch.worker import Values, analyse_rows, identity, values
from ptbatch.workbook.results import Outcome

if TYPE_CHECKING:
    from distributed import Client, Future

CONNECT_SECONDS = 10
PATIENCE = 60.0  # seconds without any worker
CHUNK_SECONDS = 1.5  # of work in a chunk
FIRST_ROWS, MOST_ROWS = 4, 200  # in a chunk: before a time is known, and at most
LEAD = 4  # chunks in flight for each thread of the cluster
CURE = "install the same ptbatch, with the same libraries, for the scheduler and all workers"


def cluster_outcomes(members: Iterable[Member], address: str) -> Iterator[Outcome]:
    """Outcomes in the order of the members, from the workers of the scheduler at `address`.

    An exception in one row stays in that row, and so does the death of all workers that try it. Members are
    taken as they are needed. Raises ClusterError.
    """
    cluster, rows = _Cluster(address), map(values, members)
    flying: deque[tuple[Future, list[Values]]] = deque()
    size = FIRST_ROWS
    try:
        while True:
            while len(flying) < cluster.window() and (chunk := list(islice(rows, size))):
                flying.append((cluster.submit(chunk), chunk))
            if not flying:
                return
            outcomes = cluster.collect(*flying.popleft())
            size = rows_of_a_chunk(outcomes)
            yield from outcomes
    finally:
        cluster.close()


def rows_of_a_chunk(outcomes: Sequence[Outcome]) -> int:
    """As many rows as take CHUNK_SECONDS; the median leaves out a row that waited for the compiler."""
    times = [time for outcome in outcomes if isinstance(time := outcome.summary["time [ms]"], float)]
    return min(max(int(1e3 * CHUNK_SECONDS / median(times)), 1), MOST_ROWS) if times else FIRST_ROWS


class _Cluster:
    """The workers of a scheduler, as a place that chunks are sent to and collected from."""

    def __init__(self, address: str) -> None:
        self.address = address
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
        return LEAD * self.threads

    def submit(self, rows: list[Values]) -> "Future":
        """Send rows off."""
        with self._connection():
            return self.client.submit(analyse_rows, identity(), rows, pure=False)

    def collect(self, future: "Future", rows: list[Values]) -> list[Outcome]:
        """Wait for a chunk. Where workers die of it, its rows go one by one, to find the one that does it."""
        from distributed import KilledWorker

        error = self._wait(future)
        if isinstance(error, KilledWorker):
            if len(rows) == 1:
                return [crashed(RuntimeError("every worker that took this row died"))]
            return [outcome for row in rows for outcome in self.collect(self.submit([row]), [row])]
        if error is not None:
            kind = type(error).__name__
            raise ClusterError(f"{self.address} cannot run ptbatch ({kind}: {error}); {CURE}") from error
        with self._connection():
            result = future.result()
        if result["identity"] != identity():
            raise ClusterError(f"{difference(result['worker'], result['identity'])}; {CURE}")
        return [Outcome(**outcome) for outcome in result["outcomes"]]

    def _wait(self, future: "Future") -> BaseException | None:
        """The error of a task, None once it is done without one."""
        while True:
            try:
                with self._connection():
                    return future.exception(timeout=1.0)
            except TimeoutError:
                self._look()

    def _look(self) -> None:
        """Count the threads of all workers. Raises ClusterError if there has been none for long."""
        with self._connection():
            threads = sum(self.client.nthreads().values())
        self.looked = monotonic()
        if threads:
            self.threads, self.seen = threads, self.looked
        elif self.looked > self.seen + PATIENCE:
            raise ClusterError(
                f"{self.address} has had no workers for {PATIENCE:g} s; start some: dask worker {self.address}"
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


def difference(worker: str, there: Mapping[str, str]) -> str:
    """What a worker has that is not as it is here."""
    unlike = [
        f"{name} {there.get(name)} (here {here})" for name, here in identity().items() if there.get(name) != here
    ]
    return f"the worker at {worker} has {', '.join(unlike)}"
