"""An append-only file of records that survives being killed at any moment.

A record is its key, the length and the checksum of its content, and the content. One is written by a single
call and never changed. What a killed run left half-written fails its checksum and is cut off; nothing else is
lost. No database: a file that only grows needs no transactions, no shared memory (which network file systems
lack) and no sync to disk for every row, and nothing in it is ever executed.
"""

import os
import zlib
from collections.abc import Iterator
from pathlib import Path
from struct import Struct
from time import monotonic
from typing import BinaryIO

from ptbatch.errors import WriteError
from ptbatch.journal.lock import lock

MAGIC = b"ptbatch journal 1\n"
KEY = 16  # bytes
LONGEST = 256 * 2**20  # content of a record
SYNCED = 5.0  # s between syncs, which count when the machine itself goes down

_HEAD = Struct(f"<{KEY}sII")


class Records:
    """Records of a file, by key; the last one of a key counts. Raises WriteError where the file is not what
    it should be, or in use by another run."""

    def __init__(self, path: Path) -> None:
        self._file: BinaryIO = path.open("a+b", buffering=0)
        try:
            self._start(path)
        except BaseException:
            self._file.close()
            raise

    def _start(self, path: Path) -> None:
        if not lock(self._file):
            raise WriteError(f"{path} is in use: another run is writing the same results")
        self._file.seek(0)
        if not MAGIC.startswith(self._file.read(len(MAGIC))):
            raise WriteError(f"{path} is no journal of this program; delete it")
        self._places = dict(_sound(self._file))
        self._end = max((place + size for place, size in self._places.values()), default=len(MAGIC))
        self._file.truncate(self._end if self._places else 0)
        if not self._places:
            self._file.write(MAGIC)
        self._synced = monotonic()

    def __len__(self) -> int:
        return len(self._places)

    def __contains__(self, key: bytes) -> bool:
        return key in self._places

    def __getitem__(self, key: bytes) -> bytes:
        place, size = self._places[key]
        self._file.seek(place)
        return self._file.read(size)

    def add(self, key: bytes, content: bytes) -> None:
        """Append a record."""
        self._file.write(_HEAD.pack(key, len(content), _checksum(key, content)) + content)
        self._places[key] = self._end + _HEAD.size, len(content)
        self._end += _HEAD.size + len(content)
        if monotonic() - self._synced > SYNCED:
            os.fsync(self._file.fileno())
            self._synced = monotonic()

    def close(self) -> None:
        """Close the file; it stays."""
        self._file.close()


def _checksum(key: bytes, content: bytes) -> int:
    return zlib.crc32(content, zlib.crc32(key))


def _sound(file: BinaryIO) -> Iterator[tuple[bytes, tuple[int, int]]]:
    """Key, place and size of the records up to the first that is torn."""
    place = len(MAGIC)
    while True:
        file.seek(place)
        head = file.read(_HEAD.size)
        if len(head) < _HEAD.size:
            return
        key, size, checksum = _HEAD.unpack(head)
        content = file.read(size) if size <= LONGEST else b""
        if len(content) < size or _checksum(key, content) != checksum:
            return
        place += _HEAD.size
        yield key, (place, size)
        place += size
