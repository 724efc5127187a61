"""Whatever happens while a file is written: what stands in its place is the old one or the new one, whole."""

import os
import resource
import signal
import subprocess
import sys
from pathlib import Path
from time import sleep

import pytest
from openpyxl import load_workbook

ROOT = Path(__file__).parents[3]
KILLS = 12
ROWS = 3000
WRITER = f"""
import sys
from pathlib import Path
from ptbatch.workbook.write import Sheet, write_workbook
print("ready", flush=True)
for version in range(1000):
    rows = [[version, f"row {{i}}"] for i in range({ROWS})]
    write_workbook(Path(sys.argv[1]), [Sheet("s", ["version", "text"], rows)])
    print(version, flush=True)
"""

posix = pytest.mark.skipif(os.name != "posix", reason="signals and limits of POSIX")


def python(*words, **more) -> subprocess.Popen:
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    return subprocess.Popen([sys.executable, *words], env=environment, text=True, **more)


@posix
def test_killed_at_any_moment(tmp_path):
    """Twelve kills, each a little later in the writing of a file than the one before."""
    path = tmp_path / "a.xlsx"
    seen = set()
    for kill in range(KILLS):
        writer = python("-c", WRITER, str(path), stdout=subprocess.PIPE)
        assert writer.stdout.readline() == "ready\n"
        written = int(writer.stdout.readline())  # so that there is a file to be spoilt
        sleep(0.02 * kill)
        writer.send_signal(signal.SIGKILL)
        writer.wait()
        rows = list(load_workbook(path, read_only=True)["s"].iter_rows(min_row=2, values_only=True))
        (version,) = {row[0] for row in rows}
        assert len(rows) == ROWS
        assert version >= written
        seen.add(version)
    assert len(seen) > 1 or KILLS < 2


@posix
def test_no_room_on_the_disk(tmp_path, book, beam):
    """The system itself refuses to let the file grow: the old results stay, nothing half-written is left."""
    source = book(*(beam | {"member": f"B{i}", "fc": "?"} for i in range(400)))
    results = tmp_path / "beams.results.xlsx"
    results.write_text("old")
    before = sorted(os.listdir(tmp_path))
    run = python(
        *("-m", "ptbatch", "run", str(source)),
        stderr=subprocess.PIPE,
        preexec_fn=lambda: (
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN),
            resource.setrlimit(resource.RLIMIT_FSIZE, (12_000, 12_000)),
        ),
    )
    said = run.stderr.read()
    assert run.wait() == 4, said
    assert "cannot be written" in said and "File too large" in said
    assert results.read_text() == "old"
    assert [name for name in sorted(os.listdir(tmp_path)) if "journal" not in name] == before
