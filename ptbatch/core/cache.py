"""Where compiled kernels are kept between runs.

numba does not notice that a function called by a cached one has changed, so the folder is named after a hash
of all kernel sources and of the versions that made the code: a stale cache is never looked at. Results never
depend on it.
"""

import hashlib
import os
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

CORE = Path(__file__).parent


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


def cache_folder() -> Path:
    """A writable folder for this version of the kernels; a temporary one where the user's cannot be
    written."""
    folder = user_cache() / source_key()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError:
        folder = Path(tempfile.gettempdir()) / f"ptbatch-{source_key()}"
        folder.mkdir(parents=True, exist_ok=True)
    return folder


def is_warm() -> bool:
    """Whether a compiled analysis of this version is already on disk."""
    return any((user_cache() / source_key()).rglob("*.nbi"))
