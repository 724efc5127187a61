"""A real browser without a window, where there is one."""

import shutil
import subprocess
from pathlib import Path

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FLAGS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update", "--window-size=1000,1400"),
    *("--enable-logging=stderr", "--no-pdf-header-footer"),
)
FOUND = next(filter(None, map(shutil.which, NAMES)), None)
needed = pytest.mark.skipif(FOUND is None, reason="no browser: none of " + ", ".join(NAMES) + " is installed")


def browse(page: Path, profile: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Open a page with a profile of its own."""
    command = [str(FOUND), *FLAGS, f"--user-data-dir={profile}", *words, page.as_uri()]
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
