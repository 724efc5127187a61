"""Many machines: a real scheduler with two worker processes on the loopback, one of which is killed."""

import operator
import os
import signal
import sys
from itertools import count
from threading import Event, Timer
from time import monotonic

import pytest
from openpyxl import load_workbook

from benchmarks.population import population
from ptbatch.cli import exit_code
from ptbatch.cluster import scheduler, worker
from ptbatch.cluster.outcomes import on_cluster
from ptbatch.errors import ClusterError
from ptbatch.member import Member
from ptbatch.runner import on_threads
from tests.members import SMALL

distributed = pytest.importorskip("distributed", reason="needs the extra `cluster`")

HERE = {"host": "127.0.0.1", "dashboard_address": "127.0.0.1:0"}  # nothing listens at a fixed port
LIGHT = {"elements": 4, "layers": 8}

# What workers load first: every row is noted with its process; some are made to crash, to kill or to wait.
PRELOAD = """
import os, time
from pathlib import Path
from ptbatch import analysis

LOG = Path({log!r})
REAL = vars(analysis).setdefault("real", analysis.analyse)  # this file may be loaded twice

def analyse(member):
    with LOG.open("a") as log:
        log.write(f"{{member.member}}\\t{{os.getpid()}}\\n")
    if member.member == "crash":
        raise ZeroDivisionError("of the test")
    if member.member == "fatal":
        os._exit(1)
    time.sleep(0.02)
    return REAL(member)

analysis.analyse = analyse
"""


def light(name: str) -> Member:
    """A member of 10 ms."""
    return Member(**SMALL | LIGHT | {"member": name})


def digits(outcome) -> tuple:
    """All of an outcome but the time."""
    return vars(outcome) | {"summary": dict(outcome.summary) | {"time [ms]": 0.0}}


@pytest.fixture(scope="module")
def members():
    """Forty members, all different."""
    return [Member(**worker.values(member) | LIGHT) for member in population(40)]


@pytest.fixture(scope="module")
def here(members):
    """Their outcomes on this machine."""
    return [digits(outcome) for outcome in on_threads(2)(members)]


@pytest.fixture(scope="module")
def machines(here, tmp_path_factory):
    """Two workers of one thread; `here` comes first, so that they load what is compiled."""
    preload = tmp_path_factory.mktemp("preload") / "preload.py"
    log = preload.with_name("rows.log")
    preload.write_text(PRELOAD.format(log=str(log)))
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, **HERE, preload=str(preload)) as started:
        started.log = log
        yield started


@pytest.fixture
def small_chunks(monkeypatch):
    """Sixteen rows in flight, in chunks of four."""
    monkeypatch.setattr("ptbatch.cluster.outcomes.MOST_ROWS", 4)
    monkeypatch.setattr(scheduler, "LEAD", 2)


def test_a_killed_worker_loses_no_row(machines, members, here, small_chunks):
    victim, outcomes = next(iter(machines.workers.values())).pid, []
    for outcome in on_cluster(machines.scheduler_address)(members):
        outcomes.append(digits(outcome))
        if len(outcomes) == len(members) // 2:
            os.kill(victim, signal.SIGKILL)
    assert outcomes == here
    tried = [line.split("\t") for line in machines.log.read_text().splitlines()]
    lost = {name for name, pid in tried if int(pid) == victim}
    assert lost & {name for name, pid in tried if int(pid) != victim}


def test_a_crash_stays_in_its_row(machines):
    names = ["a", "crash", "b"]
    outcomes = list(on_cluster(machines.scheduler_address)(map(light, names)))
    assert [outcome.status for outcome in outcomes] == ["ok", "not converged", "ok"]
    assert "ZeroDivisionError: of the test" in outcomes[1].message


def test_a_row_that_kills_its_worker_stays_alone(machines, monkeypatch):
    monkeypatch.setattr(machines.scheduler, "allowed_failures", 0)
    names = ["a", "b", "fatal", "c"]
    outcomes = list(on_cluster(machines.scheduler_address)(map(light, names)))
    assert [outcome.status for outcome in outcomes] == ["ok", "ok", "not converged", "ok"]
    assert outcomes[2].message == scheduler.DIED


def test_members_are_taken_as_they_are_needed(machines, small_chunks):
    taken = []
    endless = (taken.append(i) or light(f"m{i}") for i in count())
    outcomes = on_cluster(machines.scheduler_address)(endless)
    for _ in range(8):
        next(outcomes)
    outcomes.close()
    assert len(taken) <= 8 + 16


def test_a_stopped_run_ends_with_what_is_in_flight(machines, small_chunks):
    stop, started = Event(), monotonic()
    outcomes = on_cluster(machines.scheduler_address, stop)(light(f"m{i}") for i in range(1000))
    first = next(outcomes)
    stop.set()
    statuses = [outcome.status for outcome in (first, *outcomes)]
    done = statuses.count("ok")
    assert 8 <= done <= 16  # of one worker, or of two if both are up again
    assert statuses == ["ok"] * done + ["not analysed"] * (1000 - done)
    assert monotonic() - started < 10.0


def test_other_versions_are_refused(machines, monkeypatch):
    other = worker.identity() | {"ptbatch": "9.9", "source": "123"}
    monkeypatch.setattr(scheduler, "identity", lambda: worker.identity() | other)
    monkeypatch.setattr(scheduler.Cluster, "window", lambda self: 1)  # does not look before it sends
    with pytest.raises(ClusterError, match=r"ptbatch [0-9.]+ \(here 9.9\), source \w+ \(here 123\); inst"):
        list(on_cluster(machines.scheduler_address)([light("a")]))


def test_workers_without_this_program_are_found_first(machines, monkeypatch):
    monkeypatch.setattr(scheduler, "identity", operator.attrgetter("no such program"))
    with pytest.raises(ClusterError, match=r"worker at tcp\S+ cannot run ptbatch \(\w+Error: .*; install"):
        list(on_cluster(machines.scheduler_address)([light("a")]))


def test_no_workers(monkeypatch):
    monkeypatch.setattr(scheduler, "PATIENCE", 0.5)
    with distributed.LocalCluster(n_workers=0, **HERE) as none:
        with pytest.raises(ClusterError, match="no worker .* dask worker tcp://127.0.0.1"):
            list(on_cluster(none.scheduler_address)([light("a")]))


def test_command_line(machines, book, beam):
    rows = [beam | LIGHT | {"member": name, "fc": fc} for name, fc in (("B1", 40), ("B2", "?"), ("B3", 35))]
    path, summaries = book(*rows), []
    for options in ([], ["--scheduler", machines.scheduler_address]):
        assert exit_code(["run", str(path), *options]) == 3
        summary = load_workbook(path.with_name("beams.results.xlsx"))["summary"]
        lines = summary.iter_rows(values_only=True)
        time = next(lines).index("time [ms]")
        summaries.append([line[:time] + line[time + 1 :] for line in lines])
    assert summaries[0] == summaries[1]


def test_a_lost_scheduler():
    lost = distributed.LocalCluster(n_workers=0, **HERE)
    end = Timer(1.0, lost.close)
    end.start()
    with pytest.raises(ClusterError, match="the scheduler at tcp\\S+ is gone"):
        list(on_cluster(lost.scheduler_address)([light("a")]))
    end.join()


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nowhere", "carrier-pigeon://a:1"])
def test_no_scheduler(book, beam, monkeypatch, capsys, address):
    monkeypatch.setattr(scheduler, "CONNECT_SECONDS", 1)
    assert exit_code(["run", str(book(beam)), "--scheduler", address]) == 4
    assert f"no scheduler answers at {address}; check the address" in capsys.readouterr().err


def test_without_dask(book, beam, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert exit_code(["run", str(book(beam)), "--scheduler", "tcp://127.0.0.1:9"]) == 4
    assert "install it: python -m pip install 'ptbatch[cluster]'" in capsys.readouterr().err


def test_jobs_are_of_this_machine(book, beam, capsys):
    assert exit_code(["run", str(book(beam)), "--scheduler", "a:1", "--jobs", "2"]) == 2
    assert "--jobs is for this machine" in capsys.readouterr().err


def test_values_make_the_same_member(members):
    assert [worker.member(worker.values(member)) for member in members] == members
