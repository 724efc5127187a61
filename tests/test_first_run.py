"""The process that helps the first run to compile: when it starts, and that it compiles what is used."""

import sys
from types import SimpleNamespace

import numba
import pytest

from ptbatch import first_run
from ptbatch.analysis import analyse, jacking_stress, prepare
from ptbatch.core import store
from ptbatch.core.case import still
from ptbatch.member import Member
from ptbatch.model.arrays import set_up


def test_types_are_those_of_an_analysis():
    setup = set_up(Member(**first_run.ANY | dict(member="another", elements=6, As=500, ds=550)))
    handle = prepare(setup, jacking_stress(setup)).rig.handle
    target = still(setup.pattern, False)
    assert first_run.kinds() == (*map(numba.typeof, (handle, target, setup.pattern)),)


@pytest.mark.skipif(store.FOLDER is None, reason="there is no cache")
def test_what_it_compiles_is_what_an_analysis_uses():
    """Analyses have filled the cache, since no test lets the second process start: in a new one there is only
    what they use."""
    analyse(Member(**first_run.ANY))
    for kernel, signature in first_run.late_kernels().items():
        assert kernel._cache._path((signature, kernel.targetctx.codegen().magic_tuple())).exists()


@pytest.fixture
def started(monkeypatch):
    """Commands that would be started."""
    commands = []
    monkeypatch.setattr(first_run, "_helpers", [])
    monkeypatch.setattr(first_run.subprocess, "Popen", lambda command, **_: commands.append(command))
    monkeypatch.setattr(first_run, "is_warm", lambda: False)
    monkeypatch.setattr(first_run, "os", SimpleNamespace(cpu_count=lambda: 2))
    return commands


def test_it_starts_once(started):
    first_run.compile_ahead()
    first_run.compile_ahead()
    assert started == [[sys.executable, "-P", "-m", "ptbatch.first_run"]]


def test_it_does_not_start_where_all_is_compiled(started, monkeypatch):
    monkeypatch.setattr(first_run, "is_warm", lambda: True)
    first_run.compile_ahead()
    assert not started


@pytest.mark.parametrize("processors", [1, None])
def test_it_does_not_start_on_one_processor(started, monkeypatch, processors):
    monkeypatch.setattr(first_run, "os", SimpleNamespace(cpu_count=lambda: processors))
    first_run.compile_ahead()
    assert not started


def test_a_process_that_cannot_be_started_is_done_without(started, monkeypatch):
    def refused(*_, **__):
        raise PermissionError

    monkeypatch.setattr(first_run.subprocess, "Popen", refused)
    first_run.compile_ahead()
