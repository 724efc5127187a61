"""Sheets that are compressed while they are written."""

import os
from struct import unpack
from time import monotonic, sleep
from zipfile import ZIP_DEFLATED, ZipFile

import pytest
from openpyxl import load_workbook

from ptbatch.workbook import packing, write
from ptbatch.workbook.packing import Archive, Packer


@pytest.fixture
def packer(monkeypatch):
    """One that follows short files as well, and looks at them all the time."""
    monkeypatch.setattr(packing, "LONG", 100)
    monkeypatch.setattr(packing, "PAUSE", 0.01)
    packer = Packer()
    yield packer
    packer.discard()


def grown(packer, path):
    """A file that has grown while it was followed, and its content."""
    content = b""
    with path.open("wb", buffering=0) as file:
        packer.follow(str(path))
        for i in range(5):
            part = (b"%d " % i) * 5_000 + os.urandom(1_000)
            file.write(part)
            content += part
            deadline = monotonic() + 30
            while not (at := packer._packed.get(str(path))) or at.size < len(content):
                assert monotonic() < deadline
                sleep(0.005)
        file.write(b"the rest")
    packer.stop()
    return content + b"the rest"


def archived(packer, *paths):
    """The archive that these files make."""
    archive = paths[0].with_name("a.zip")
    with archive.open("xb") as file, Archive(file, packer) as whole:
        for path in paths:
            whole.write(str(path), path.name)
    return ZipFile(archive)


def test_a_file_that_grows(packer, tmp_path):
    """Among others that nobody followed, before and behind it."""
    first, path, last = (tmp_path / name for name in ("first", "long", "last"))
    first.write_bytes(b"before" * 100)
    last.write_bytes(b"behind" * 100)
    content = grown(packer, path)
    with archived(packer, first, path, last) as archive:
        assert archive.testzip() is None
        assert [archive.read(name) for name in ("first", "long", "last")] == [
            b"before" * 100,
            content,
            b"behind" * 100,
        ]
        about = archive.getinfo("long")
        assert (about.compress_type, about.file_size) == (ZIP_DEFLATED, len(content))
        assert about.compress_size < 0.5 * len(content)
        # and the header before the content says what the directory behind all of it does
        assert archive.fp is not None
        archive.fp.seek(about.header_offset)
        _, _, flags, method, _, _, checksum, packed, size, *_ = unpack("<4s5H3L2H", archive.fp.read(30))
        assert (flags, method, checksum) == (about.flag_bits, ZIP_DEFLATED, about.CRC)
        assert (packed, size) == (about.compress_size, about.file_size)


class Full:
    """A disk without room, a memory without room."""

    def __init__(self, error):
        self.error = error

    def write(self, content):
        raise self.error

    compress = write

    def close(self):
        pass


@pytest.mark.parametrize("part, error", [("content", OSError("full")), ("_pack", MemoryError())])
def test_no_room_for_it(packer, tmp_path, part, error):
    """The file is compressed when the archive is written."""
    path = tmp_path / "long"
    content = grown(packer, path)
    setattr(packer._packed[str(path)], part, Full(error))
    with path.open("ab") as file:
        file.write(b"more")
    with archived(packer, path) as archive:
        assert archive.read("long") == content + b"more"


def test_a_piece_that_is_missing(packer, tmp_path):
    path = tmp_path / "long"
    content = grown(packer, path)
    packer._packed[str(path)].size -= 1
    with archived(packer, path) as archive:
        assert archive.read("long") == content


def test_a_long_sheet_is_that_of_a_short_one(monkeypatch, tmp_path):
    """Cell by cell, wherever the thread has come to; and nothing is left behind."""
    values = [float(i) / 3.0 for i in range(500)]
    found = []
    for name, pause, long in (("quick", 0.001, 1_000), ("never", 60.0, 2**40)):
        monkeypatch.setattr(packing, "PAUSE", pause)
        monkeypatch.setattr(packing, "LONG", long)
        book = write.Book()
        page = book.page("s", ["member", "load [kN]"])
        for _ in range(20):
            page.extend([["A"] * len(values), values])
            sleep(0.005)
        deadline = monotonic() + 30
        while name == "quick" and not book._packer._packed:
            assert monotonic() < deadline
            sleep(0.005)
        path = book.save(tmp_path / f"{name}.xlsx")
        book.discard()
        assert not book._packer._packed
        assert not book._packer._thread.is_alive()
        found.append([row for row in load_workbook(path, read_only=True)["s"].iter_rows(values_only=True)])
    assert found[0] == found[1]
    assert len(found[0]) == 1 + 20 * len(values)
