"""Turns at running Python: one at a time, who analyses first, and nobody for ever."""

from concurrent.futures import ThreadPoolExecutor
from threading import Event, Thread
from time import monotonic, sleep

import pytest

from ptbatch import turns as module
from ptbatch.turns import Turns

LONG = 20.0  # s; no test takes as long


@pytest.fixture
def turns(monkeypatch):
    monkeypatch.setattr(module, "PATIENCE", LONG)
    return Turns()


def started(target):
    thread = Thread(target=target, daemon=True)
    thread.start()
    return thread


def until(condition):
    end = monotonic() + LONG
    while not condition() and monotonic() < end:
        sleep(0.001)
    assert condition()


def test_one_at_a_time(turns):
    inside, most = 0, 0

    def work(i):
        nonlocal inside, most
        for _ in range(20):
            with turns.taken(sooner=i % 2 == 0):
                inside += 1
                most = max(most, inside)
                sleep(1e-4)
                inside -= 1

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(work, range(4)))
    assert (inside, most) == (0, 1)


def test_who_analyses_goes_first(turns):
    order, late, early = [], Event(), Event()

    def wait(name, begun, sooner):
        begun.set()
        with turns.taken(sooner):
            order.append(name)

    with turns.taken():
        threads = [started(lambda: wait("later", late, False))]
        assert late.wait(LONG)
        sleep(0.05)
        threads.append(started(lambda: wait("sooner", early, True)))
        until(lambda: turns._waiting == 1)
    for thread in threads:
        thread.join(LONG)
    assert order == ["sooner", "later"]


def test_a_turn_is_left_and_taken_again(turns):
    order = []
    with turns.taken(sooner=False):
        thread = started(lambda: _append(turns, order, "other"))
        with turns.left(sooner=False):
            thread.join(LONG)
        order.append("this")
        thread = started(lambda: _append(turns, order, "other again"))
        until(lambda: turns._waiting == 1)
        assert order == ["other", "this"]
        turns.offered(sooner=False)
        order.append("this again")
    thread.join(LONG)
    assert order == ["other", "this", "other again", "this again"]


def _append(turns, order, name):
    with turns.taken():
        order.append(name)


def test_who_has_no_turn_leaves_none(turns):
    with turns.taken():
        thread = started(lambda: _leave(turns))
        thread.join(LONG)
        assert not thread.is_alive()
        assert turns._holder is not None


def _leave(turns):
    with turns.left():
        pass


def test_an_exception_ends_a_turn(turns):
    with pytest.raises(ValueError, match="within"), turns.taken():
        raise ValueError("within")
    with pytest.raises(ValueError, match="away"), turns.taken(), turns.left():
        raise ValueError("away")
    assert turns._holder is None
    assert turns._waiting == 0


def test_who_never_gives_it_up_keeps_nobody(monkeypatch):
    monkeypatch.setattr(module, "PATIENCE", 0.02)
    turns, order = Turns(), []
    with turns.taken():
        for sooner in (True, False):
            thread = started(lambda sooner=sooner: _go_on(turns, order, sooner))
            thread.join(LONG)
    assert order == [True, False]
    assert turns._holder is None


def _go_on(turns, order, sooner):
    with turns.taken(sooner):
        order.append(sooner)
