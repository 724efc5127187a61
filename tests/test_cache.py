"""Compiled code is kept between runs, and whatever becomes of it, the results are the same."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from ptbatch.core import cache
from ptbatch.core.cache import KEPT, prune
from ptbatch.core.jit import kernel

ROOT = Path(__file__).parent.parent
STRESS = """
from ptbatch.core.steel import Steel, steel_stress
print(steel_stress(0.01, 0.0, 420.0, Steel(2e5, 2e3, 0.05)), steel_stress.stats.cache_hits != {})
"""


def run(code: str, kept: Path) -> tuple[str, bool, str]:
    """(what it answers, whether from the cache, what it says) of a fresh interpreter."""
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
        env=os.environ | {"PTBATCH_CACHE": str(kept)},
    )
    value, hit = done.stdout.split()
    return value, hit == "True", done.stderr


@pytest.fixture(scope="module")
def answer(tmp_path_factory):
    """The stress, and the folder with the code that found it."""
    folder = tmp_path_factory.mktemp("cache")
    value, hit, said = run(STRESS, folder)
    assert not hit
    assert said == ""
    return value, folder


def files(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.nbc"))


def test_it_is_found_again(answer):
    value, folder = answer
    assert run(STRESS, folder) == (value, True, "")


def scribble(data: bytes) -> bytes:
    """A few bytes in the middle, where the machine code is."""
    middle = len(data) // 2
    return data[:middle] + bytes(64) + data[middle + 64 :]


@pytest.mark.parametrize(
    "damage",
    [lambda data: data[: len(data) // 2], lambda data: b"", lambda data: b"\x80" * 500, scribble],
    ids=["cut", "empty", "junk", "scribbled"],
)
def test_damage_is_said_and_mended(answer, damage):
    value, folder = answer
    assert files(folder)
    for path in files(folder):
        path.write_bytes(damage(path.read_bytes()))
    found, hit, said = run(STRESS, folder)
    assert (found, hit) == (value, False)
    assert "compiling again" in said
    assert len(said.splitlines()) == 1
    assert run(STRESS, folder) == (value, True, "")


def test_a_folder_in_place_of_a_file(answer, tmp_path):
    value, folder = answer
    for path in files(folder):
        (tmp_path / path.relative_to(folder)).mkdir(parents=True)
    found, hit, said = run(STRESS, tmp_path)
    assert (found, hit) == (value, False)
    assert "compiling again" in said


def test_no_folder_can_be_made(answer, tmp_path):
    """The user's cannot: a temporary one serves; and if that cannot either, none."""
    value, _ = answer
    (tmp_path / "file").touch()
    temporary = f"import tempfile; tempfile.tempdir = {str(tmp_path)!r}\n"
    assert run(temporary + STRESS, tmp_path / "file") == (value, False, "")
    assert run(temporary + STRESS, tmp_path / "file") == (value, True, "")
    nowhere = f"import tempfile; tempfile.tempdir = {str(tmp_path / 'file')!r}\n"
    assert run(nowhere + STRESS, tmp_path / "file") == (value, False, "")


def test_a_folder_to_read_from(tmp_path, monkeypatch):
    """One that was filled in advance, with an image of a machine for example."""
    monkeypatch.setenv("PTBATCH_CACHE", str(tmp_path))
    monkeypatch.setattr(cache, "_temporary", lambda: tmp_path / "temporary")
    monkeypatch.setattr(cache, "_is_writable", lambda folder: "temporary" in str(folder))
    filled = tmp_path / cache.source_key()
    filled.mkdir()
    assert cache.cache_folder() == tmp_path / "temporary" / filled.name
    assert not cache.is_warm()
    (filled / f"{cache.LAST}-0.nbc").touch()
    assert cache.cache_folder() == filled
    assert cache.is_warm()


@pytest.mark.skipif(sys.platform == "win32", reason="the limit is POSIX")
def test_a_full_disk_is_said(answer, tmp_path):
    value, _ = answer
    full = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (99, 99))\n"
    found, hit, said = run(full + STRESS, tmp_path)
    assert (found, hit) == (value, False)
    assert "cannot be kept" in said
    assert len(said.splitlines()) == 1
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_old_versions_are_pruned(tmp_path):
    folders = [tmp_path / f"{number:012x}" for number in range(KEPT + 3)]
    for age, folder in enumerate(folders):
        folder.mkdir()
        (folder / "code.nbc").touch()
        os.utime(folder, (1e9 - age, 1e9 - age))
    mine = tmp_path / "notes of the user"
    mine.mkdir()
    prune(folders[-1])
    left = [folder for folder in folders if folder.exists()]
    assert left == [*folders[:KEPT], folders[-1]]
    assert mine.exists()


@kernel
def chosen(flag, number):
    return number if flag else -number


@kernel
def chooser():
    return chosen(True, 1) + chosen(False, 2) + chosen(True, 3)


def test_a_kernel_is_compiled_once_for_all_values():
    assert chooser() == 2
    assert len(chosen.signatures) == 1
