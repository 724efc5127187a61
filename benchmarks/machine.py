"""What the figures were measured on."""

import os
import platform
from importlib.metadata import version
from pathlib import Path

from ptbatch import __version__


def processor() -> str:
    """Model of the CPU."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def machine() -> str:
    """One sentence."""
    packages = ", ".join(f"{name} {version(name)}" for name in ("numba", "numpy"))
    return (
        f"ptbatch {__version__}: {processor()}, {os.cpu_count()} cores, "
        f"{platform.system()}, Python {platform.python_version()}, {packages}."
    )
