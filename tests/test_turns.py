"""Turns at running Python: one at a time, who analyses first, and nobody for ever."""

from concurrent.futures import ThreadPoolExecutor
from threading import Thread, get_ident
from time import monotonic, sleep

import pytest

from ptbatch import runner, stages
from ptbatch import turns as module
from ptbatch.first_run import ANY
from ptbatch.member import Member
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
    order = []
    with turns.taken():
        threads = [started(lambda: _append(turns, order, "later", False))]
        until(lambda: turns._later._waiters)  # it has come first
        threads.append(started(lambda: _append(turns, order, "sooner")))
        until(lambda: turns._waiting == 1)
    for thread in threads:
        thread.join(LONG)
    assert order == ["sooner", "later"]


def test_a_turn_is_left_and_taken_again(turns):
    order = []
    with turns.taken(sooner=False):
        thread = started(lambda: _append(turns, order, "other"))
        with turns.left():
            thread.join(LONG)
        order.append("this")
        thread = started(lambda: _append(turns, order, "other again"))
        until(lambda: turns._waiting == 1)
        assert order == ["other", "this"]
        turns.offered()
        order.append("this again")
    thread.join(LONG)
    assert order == ["other", "this", "other again", "this again"]


def _append(turns, order, name, sooner=True):
    with turns.taken(sooner):
        order.append(name)


def test_who_has_no_turn_leaves_none(turns):
    with turns.taken():
        thread = started(lambda: _leave(turns))
        thread.join(LONG)
        assert not thread.is_alive()
        assert turns._holder == get_ident()


def _leave(turns):
    with turns.left():
        pass


def test_a_turn_within_a_turn(turns):
    with turns.taken(sooner=False):
        with turns.taken():
            assert turns._holder == get_ident()
        assert turns._holder == get_ident()
        turns.offered()
        assert turns._holder == get_ident()
    assert turns._holder is None


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
            thread = started(lambda sooner=sooner: _append(turns, order, sooner, sooner))
            thread.join(LONG)
    assert order == [True, False]
    assert turns._holder is None


def test_who_was_overtaken_has_a_turn_again(monkeypatch):
    monkeypatch.setattr(module, "PATIENCE", 0.02)
    turns = Turns()
    with turns.taken(sooner=False):
        started(lambda: _append(turns, [], "overtakes")).join(LONG)
        assert turns._holder is None
        turns.offered()
        assert turns._holder == get_ident()
    assert turns._holder is None


def test_a_run_takes_turns(monkeypatch):
    """Reading and analysing have the turn; the kernel of the live load, and who waits for it, leave it."""
    monkeypatch.setattr(module, "PATIENCE", LONG)  # loading kernels takes longer than others wait
    held = {}

    def seen(name, function=lambda *_: None):
        def instead(*arguments):
            held.setdefault(name, set()).add(module.turns._holder == get_ident())
            return function(*arguments)

        return instead

    monkeypatch.setattr(stages, "follow", seen("live load", stages.follow))
    monkeypatch.setattr(stages, "ramp", seen("other stages", stages.ramp))
    monkeypatch.setattr(runner, "wait", seen("waiting", runner.wait))
    reading = seen("reading")
    members = (reading() or Member(**ANY) for _ in range(2))
    for outcome in runner.on_threads(1)(members):
        seen("using")()
        assert outcome.status == "ok"
    assert held == {
        "reading": {True},
        "other stages": {True},
        "live load": {False},
        "waiting": {False},
        "using": {True},
    }
    assert module.turns._holder is None
