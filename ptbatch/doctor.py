"""Is this installation able to work, and if not, what to do: `ptbatch doctor`."""

import os
import platform
import shutil
import tempfile
from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from math import exp
from pathlib import Path
from typing import NamedTuple

from ptbatch import __version__
from ptbatch.core import cache

NEEDED = (
    "numba",
    "llvmlite",
    "numpy",
    "scipy",
    "openpyxl",
    "orjson",
    "defusedxml",
    "matplotlib",
    "click",
    "jinja2",
)
OPTIONAL = {
    "pyarrow": ("Parquet tables", "pip install 'ptbatch[parquet]'"),
    "distributed": ("several machines", "pip install 'ptbatch[cluster]'"),
}
LEAST_DISK, ENOUGH_DISK = 200 * 2**20, 2 * 2**30
SYMBOLS = {"ok": "ok  ", "note": "note", "fault": "BAD "}


class Finding(NamedTuple):
    """One thing looked at: ok, note (works, but ...) or fault; what was found; what to do about it."""

    name: str
    state: str
    text: str
    cure: str = ""

    def __str__(self) -> str:
        cure = f"\n{'':25}-> {self.cure}" if self.cure else ""
        return f"{SYMBOLS[self.state]} {self.name:<20}{self.text}{cure}"


def examine() -> Iterator[Finding]:
    """All findings, one after the other; without its packages nothing is compiled."""
    yield _python()
    needed = [needed_package(name) for name in NEEDED]
    yield from needed
    yield from map(optional_package, OPTIONAL)
    for name, folder in (("this folder", Path.cwd()), ("temporary files", Path(tempfile.gettempdir()))):
        yield disk(name, folder)
    if all(finding.state != "fault" for finding in needed):
        yield cache_state()
        yield attempt("compiler", compiles, "reinstall numba: pip install --force-reinstall numba llvmlite")
        yield attempt("self-test", self_test, "clear the cache folder; if that does not help, report it")


def _python() -> Finding:
    text = f"{__version__}, Python {platform.python_version()}, {platform.platform()}, {os.cpu_count()} CPUs"
    return Finding("ptbatch", "ok", text)


def needed_package(name: str) -> Finding:
    """Whether a package is there and can be imported."""
    cure = f"pip install --upgrade --force-reinstall {name}"
    try:
        import_module(name)
        return Finding(name, "ok", version(name))
    except (ModuleNotFoundError, PackageNotFoundError):
        return Finding(name, "fault", "not installed", cure)
    except Exception as error:  # packages that do not fit each other raise what they like
        return Finding(name, "fault", f"cannot be imported: {error}", cure)


def optional_package(name: str) -> Finding:
    """A package that only some commands need."""
    what, cure = OPTIONAL[name]
    try:
        return Finding(name, "ok", f"{version(name)}, for {what}")
    except PackageNotFoundError:
        return Finding(name, "note", f"not installed; needed for {what} only", cure)


def cache_state() -> Finding:
    """Where the compiled code is kept, and whether it is there already."""
    wanted, used = cache.user_cache() / cache.source_key(), cache.cache_folder()
    if used != wanted:
        cure = "name a writable folder in the environment variable PTBATCH_CACHE"
        return Finding("cache", "note", f"{wanted} is not writable; {used} is used instead", cure)
    if cache.is_warm():
        return Finding("cache", "ok", f"{used}, warm")
    return Finding("cache", "ok", f"{used}, cold: the first run compiles for a minute or so")


def disk(name: str, folder: Path) -> Finding:
    """Room for results, or for what is put down on the way to them."""
    free = shutil.disk_usage(folder).free
    text = f"{free / 2**30:.1f} GB free in {folder}"
    if free < LEAST_DISK:
        return Finding(name, "fault", text, "make room: results are put together here")
    if free < ENOUGH_DISK:
        return Finding(name, "note", text, "enough for small runs; a thousand members take 100 MB")
    return Finding(name, "ok", text)


def attempt(name: str, check: Callable[[], str], cure: str) -> Finding:
    """What a check says, or how it failed."""
    try:
        return Finding(name, "ok", check())
    except Exception as error:
        return Finding(name, "fault", f"{type(error).__name__}: {error}", cure)


def compiles() -> str:
    """Compile a tiny function, by-passing the cache."""
    import numba

    if numba.njit(lambda x: 2.0 * x + 1.0)(20.5) != 42.0:
        raise ArithmeticError("a compiled function gives a wrong answer")
    return "compiles"


def self_test() -> str:
    """Analyse a straight tendon with wobble alone, whose loss is 1 - exp(-K L), and load it to the limit."""
    from ptbatch import Member, analyse
    from ptbatch.tables import summary_row

    loss, peak = 100.0 * (1.0 - exp(-0.0033 * 10.0)), 456.9  # %; kN, frozen
    tendon = {"Aps": 592, "profile": "straight", "dp": (500,), "fpj": 1395, "mu": 0, "K": 3.3e-6, "set": 0}
    beam = {"span": 10_000, "b": 300, "h": 600, "fc": 40, "As": 603, "ds": 550, "w_live": 10}
    member = Member(member="self-test", elements=4, layers=10, **beam, **tendon)
    found = summary_row(member, analyse(member))
    for header, known, margin in (("loss_fixed_end_fe [%]", loss, 1e-3), ("load_peak [kN]", peak, 0.5)):
        value = found[header]
        if not isinstance(value, float) or abs(value - known) > margin:
            raise ArithmeticError(f"{header} is {value}, not {known:.4g}")
    return f"friction loss {loss:.3f} % and peak load {peak} kN as known"
