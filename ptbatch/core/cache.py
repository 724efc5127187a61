"""Where compiled kernels are kept between runs.

numba does not notice that a function called by a cached one has changed, so the folder is named after a hash
of all kernel sources and of the versions that made the code: a stale cache is never looked at. Results never
depend on it.
"""

import hashlib
import os
import re
import shutil
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

CORE = Path(__file__).parent
KEPT = 4  # folders, of this and of other versions
LAST = "follow.follow"  # the kernel that a first analysis compiles last


def source_key() -> str:
    """Twelve hex digits of the kernel sources and of the compiler's versions."""
    digest = hashlib.sha256()
    for part in (sys.version, version("numba"), version("llvmlite"), version("numpy")):
        digest.update(part.encode())
    for path in sorted(CORE.glob("*.py")):
        digest.update(path.name.encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


def user_cache() -> Path:
    """The user's cache folder by the platform's custom; PTBATCH_CACHE overrides it."""
    if chosen := os.environ.get("PTBATCH_CACHE"):
        return Path(chosen)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local")) / "ptbatch"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "ptbatch"
    return Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "ptbatch"


def cache_folder() -> Path | None:
    """A folder for this version of the kernels: the user's, be it only to read what is complete there, else
    a temporary one, else none."""
    key = source_key()
    for parent in (user_cache, _temporary):
        try:
            folder = parent() / key
            if _is_writable(folder):
                prune(folder)
                return folder
            if _is_complete(folder):
                return folder
        except (OSError, RuntimeError):  # RuntimeError: no home folder
            continue
    return None


def _is_writable(folder: Path) -> bool:
    """Whether the folder, made if need be, takes files; marks it as used."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
        os.utime(folder)
    except OSError:
        return False
    return True


def _is_complete(folder: Path) -> bool:
    return any(folder.glob(f"{LAST}-*"))


def _temporary() -> Path:
    """A folder of the user's own among the temporary ones: what others may write is not loaded."""
    if not hasattr(os, "getuid"):
        return Path(tempfile.gettempdir()) / "ptbatch"
    folder = Path(tempfile.gettempdir()) / f"ptbatch-{os.getuid()}"
    folder.mkdir(mode=0o700, exist_ok=True)
    state = folder.lstat()
    if state.st_uid != os.getuid() or state.st_mode & 0o022:
        raise PermissionError(f"{folder} is not the user's own")
    return folder


def prune(folder: Path) -> None:
    """Remove the folders of other versions, but for those used last; whoever still uses one compiles
    again."""
    try:
        others = [path for path in folder.parent.iterdir() if re.fullmatch("[0-9a-f]{12}", path.name)]
        others.sort(key=lambda path: path.stat().st_mtime, reverse=True)
    except OSError:
        return
    for path in others[KEPT:]:
        if path != folder:
            shutil.rmtree(path, ignore_errors=True)


def is_warm() -> bool:
    """Whether a compiled analysis of this version is already on disk."""
    try:
        folders = [user_cache() / source_key(), _temporary() / source_key()]
        return any(map(_is_complete, folders))
    except (OSError, RuntimeError):
        return False
