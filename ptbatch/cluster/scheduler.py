"""The workers of a Dask scheduler, as a place that chunks of rows are sent to and collected from.

What a lost worker had, in work or finished, Dask gives to another one. Workers of another version are found
out when they are first seen, or else by their first chunk.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from math import inf
from threading import Event
from time import monotonic
from typing import TYPE_CHECKING

from ptbatch.cluster.worker import Values, analyse_rows, identity
from ptbatch.errors import ClusterError
from ptbatch.runner import CRASHED, POLL, STOPPED, not_analysed
from ptbatch.workbook.results import Outcome

if TYPE_CHECKING:
    from distributed import Client, Future

Chunk = list[Values]

CONNECT_SECONDS = 10
PATIENCE = 60.0  # seconds without any worker
GRACE = 5.0  # seconds that a stopped run waits for chunks in flight
LEAD = 4  # chunks in flight for each thread of the cluster
DIED = "internal error: every worker that took this row died; please report it, with this row"
CURE = "install the same ptbatch, with the same libraries, for the scheduler and all workers"


class Cluster:
    """The workers of a scheduler, as a place that chunks are sent to and collected from."""

    def __init__(self, address: str, stop: Event) -> None:
        self.address, self.stop = address, stop
        self.client = _connected(address)
        self.threads, self.known = 1, set[str]()
        self.stopped: float | None = None
        self.looked, self.seen = -inf, monotonic()  # when workers were last looked for, and last there

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
            result = None if error else future.result()
        if result:
            _compare(result["worker"], result["identity"])
            return [Outcome(**outcome) for outcome in result["outcomes"]]
        if not isinstance(error, KilledWorker):
            raise ClusterError(f"{self.address} cannot run ptbatch ({_short(error)}); {CURE}") from error
        if len(rows) == 1:
            return [not_analysed(CRASHED, "not converged", DIED)]
        return [outcome for row in rows for outcome in self.collect(self.submit([row]), [row])]

    def _done(self, future: "Future") -> bool:
        """Wait for a task; false if the run is stopped and it takes too long."""
        while not self._late():
            with self._connection(), suppress(TimeoutError):
                future.exception(timeout=POLL)
                return True
            self._look()
        return bool(future.done())

    def _late(self) -> bool:
        """Whether the run was stopped, GRACE seconds ago."""
        if not self.stop.is_set():
            return False
        self.stopped = self.stopped or monotonic()
        return monotonic() > self.stopped + GRACE

    def _look(self) -> None:
        """Count the threads of all workers, and ask new ones what they are. Raises ClusterError if one is of
        another version, or if there has been none for long."""
        with self._connection():
            threads = self.client.nthreads()
            new = list(threads.keys() - self.known)
            found = self.client.run(identity, workers=new, on_error="return") if new else {}
        for worker, there in found.items():
            if not isinstance(there, OSError):  # gone meanwhile
                _compare(worker, there)
                self.known.add(worker)
        self.looked = monotonic()
        if threads:
            self.threads, self.seen = sum(threads.values()), self.looked
        elif self.looked > self.seen + PATIENCE:
            raise ClusterError(
                f"{self.address} has had no worker for {PATIENCE:g} s; start some: dask worker {self.address}"
            )

    @contextmanager
    def _connection(self) -> Iterator[None]:
        """A lost connection as ClusterError."""
        from distributed import CancelledError

        try:
            yield
        except Exception as error:
            if self.client.status == "running" and not isinstance(error, OSError | CancelledError):
                raise
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


def _compare(worker: str, there: Mapping[str, str] | Exception) -> None:
    """Raise ClusterError if a worker has not what there is here, or could not say."""
    if isinstance(there, Exception):
        raise ClusterError(f"the worker at {worker} cannot run ptbatch ({_short(there)}); {CURE}")
    unlike = [name for name, here in identity().items() if there.get(name) != here]
    if unlike:
        texts = [f"{name} {there.get(name)} (here {identity()[name]})" for name in unlike]
        raise ClusterError(f"the worker at {worker} has {', '.join(texts)}; {CURE}")


def _short(error: BaseException) -> str:
    return f"{type(error).__name__}: {' '.join(str(error).split())}"[:200]
