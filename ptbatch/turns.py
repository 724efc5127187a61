"""Whose turn it is to run Python.

Python runs one thread at a time and lets each wait for the others in a circle, 5 ms each: the thread that has
a member all but ready for its kernel waits for others who are nowhere near theirs, and processors stand idle.
Here a thread keeps its turn until it waits or is in a long kernel, and those that analyse go before the one
that reads and writes. It is a courtesy: who has waited for long goes on all the same, so that nobody hangs on
anybody.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from threading import Condition, Lock, get_ident

PATIENCE = 0.1  # s


class Turns:
    """The turns of some threads. Sooner or later: those of the first kind go before those of the second."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._sooner, self._later = Condition(self._lock), Condition(self._lock)
        self._waiting = 0  # of the first kind
        self._holder: int | None = None
        self._kinds: dict[int, bool] = {}  # of the threads that take turns: whether they are of the first

    @contextmanager
    def taken(self, sooner: bool = True) -> Iterator[None]:
        """It is this thread's turn within. A turn within a turn is the same one."""
        me = get_ident()
        if me in self._kinds:
            yield
            return
        self._kinds[me] = sooner
        self._take(me)
        try:
            yield
        finally:
            self._give(me)
            del self._kinds[me]

    @contextmanager
    def left(self) -> Iterator[None]:
        """It is somebody else's turn within and this thread's afterwards, also where others have stopped
        waiting for it before. Nothing happens to a thread that takes no turns.

        Worth it for kernels of many milliseconds: after a short one a thread would have to wait anew.
        """
        me = get_ident()
        if me not in self._kinds:
            yield
            return
        self._give(me)
        try:
            yield
        finally:
            self._take(me)

    def offered(self) -> None:
        """Whoever is waiting has a turn first."""
        with self.left():
            pass

    def _take(self, me: int) -> None:
        with self._lock:
            if self._kinds[me]:
                self._waiting += 1
                try:
                    self._sooner.wait_for(lambda: self._holder is None, PATIENCE)
                finally:
                    self._waiting -= 1
            else:
                self._later.wait_for(lambda: self._holder is None and not self._waiting, PATIENCE)
            self._holder = me

    def _give(self, me: int) -> None:
        with self._lock:
            if self._holder == me:  # or else somebody's patience was at an end
                self._holder = None
                (self._sooner if self._waiting else self._later).notify()


turns = Turns()  # there is one interpreter
