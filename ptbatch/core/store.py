"""How compiled kernels are kept: one sealed file for each kernel and signature.

numba's own cache dies of a truncated file, runs whatever a damaged one holds, and raises where a disk is
full. Here a file carries the checksum of its content: what is damaged is thrown away and compiled again, and
what cannot be kept is compiled again by the next run. The sources are in the name of the folder.
"""

import hashlib
import logging
import os
import pickle
import uuid
from pathlib import Path
from typing import Any

from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from ptbatch.core.cache import cache_folder

SEAL = 32  # bytes of the checksum
LOG = logging.getLogger("ptbatch")
FOLDER = cache_folder()


class DamagedError(Exception):
    """A file is not what was written."""


def write_sealed(path: Path, content: bytes) -> None:
    """Write a file under its name only when it is complete."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{uuid.uuid4().hex[:8]}.part")
    try:
        part.write_bytes(hashlib.sha256(content).digest() + content)
        os.replace(part, path)
    except OSError:
        _remove(part)
        raise


def read_sealed(path: Path) -> bytes | None:
    """Content of a file, None if there is none; DamagedError where it is not what was written."""
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        return None
    except OSError as error:
        raise DamagedError(str(error)) from error
    if hashlib.sha256(data[SEAL:]).digest() != data[:SEAL]:
        raise DamagedError(f"{path.name} is damaged")
    return data[SEAL:]


class KernelCache:
    """The compiled versions of one kernel of this package, in the terms of numba's dispatcher."""

    def __init__(self, function: Any, folder: Path) -> None:
        module = function.__module__.rpartition(".")[2]
        self.folder, self.name = folder, f"{module}.{function.__qualname__}"
        self.enabled = True

    @property
    def cache_path(self) -> str:
        """The folder, as numba shows it."""
        return str(self.folder)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The kernel as compiled by an earlier run, None if it must be compiled."""
        if not self.enabled:
            return None
        target_context.refresh()
        key = sig, target_context.codegen().magic_tuple()
        path = self._path(key)
        try:
            content = read_sealed(path)
            if content is None:
                return None
            was, data = pickle.loads(content)
            return CompileResult._rebuild(target_context, *data) if was == key else None
        except Exception as error:  # whatever is wrong with it, it can be made again
            _say_once(f"compiled code in {self.folder} is not usable", error, "compiling again")
            _remove(path)
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a kernel that was compiled."""
        if not self.enabled or data.library.has_dynamic_globals:
            return
        key = sig, data.target_context.codegen().magic_tuple()
        try:
            write_sealed(self._path(key), dumps((key, data._reduce())))
        except OSError as error:
            self.enabled = False
            _say_once(f"compiled code cannot be kept in {self.folder}", error, "the next run compiles again")

    def enable(self) -> None:
        """Look for kernels and keep them."""
        self.enabled = True

    def disable(self) -> None:
        """Do neither."""
        self.enabled = False

    def flush(self) -> None:
        """Forget this kernel."""
        for path in self.folder.glob(f"{self.name}-*"):
            _remove(path)

    def _path(self, key: tuple[Any, ...]) -> Path:
        return self.folder / f"{self.name}-{hashlib.sha256(str(key).encode()).hexdigest()[:12]}.nbc"


def _remove(path: Path) -> None:
    try:
        path.unlink(missing_ok=True)
    except OSError:
        pass


_said: set[str] = set()


def _say_once(what: str, why: Exception, then: str) -> None:
    if what not in _said:
        _said.add(what)
        LOG.warning(f"{what} ({why}): {then}")


def keep(compiled: Any) -> None:
    """Let a kernel of this folder, whose sources are in the cache's name, be kept between runs."""
    if FOLDER is not None and compiled.py_func.__module__.startswith("ptbatch.core."):
        compiled._cache = KernelCache(compiled.py_func, FOLDER)
