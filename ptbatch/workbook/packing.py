"""Long sheets are compressed while rows are added to them, by a thread of its own: at the end of a run, when
there is nothing else to do, only their last rows are left.
"""

import os
import zlib
from contextlib import suppress
from shutil import copyfileobj
from tempfile import TemporaryFile
from threading import Event, Thread
from typing import Any
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile, ZipInfo

FAST = 2  # of zlib: half the time that its usual level takes, for a file that is a seventh larger
LONG = 2**20  # bytes; a shorter sheet takes no time
LARGE = 2**30  # bytes; a longer one may take another kind of header
PAUSE = 0.2  # s between two looks at the sheets
_CHUNK = 2**20


class Packed:
    """What there is of a growing file, compressed as an archive holds it."""

    def __init__(self, path: str) -> None:
        self._source, self.content = open(path, "rb", buffering=0), TemporaryFile()
        self._pack = zlib.compressobj(FAST, zlib.DEFLATED, -zlib.MAX_WBITS)
        self.size = self.checksum = 0
        self.sound = True  # or else it is of no use: a disk or a memory had no room for it

    def go_on(self) -> None:
        """Compress what has been added."""
        try:
            while self.sound and (chunk := self._source.read(_CHUNK)):
                self.content.write(self._pack.compress(chunk))
                self.checksum = zlib.crc32(chunk, self.checksum)
                self.size += len(chunk)
        except Exception:  # a piece may be missing, and the usual way is open
            self.sound = False

    def end(self) -> bool:
        """Compress the rest of a file that grows no more; whether `content` can take its place."""
        self.go_on()
        whole = self.sound and self.size == os.fstat(self._source.fileno()).st_size < LARGE
        self._source.close()
        with suppress(OSError):
            if whole:
                self.content.write(self._pack.flush())
                self.content.seek(0)
                return True
        return False

    def close(self) -> None:
        """Delete it."""
        self._source.close()
        with suppress(OSError):  # a full disk refuses what is left in a buffer
            self.content.close()


class Packer:
    """Compresses the files that it is to follow, once they are LONG."""

    def __init__(self) -> None:
        self._paths: list[str] = []
        self._packed: dict[str, Packed] = {}
        self._stop = Event()
        self._thread: Thread | None = None

    def follow(self, path: str) -> None:
        """Look after a file that is being written."""
        self._paths.append(path)
        if self._thread is None:
            self._thread = Thread(target=self._run, name="packer", daemon=True)
            self._thread.start()

    def _run(self) -> None:
        while not self._stop.wait(PAUSE):
            for path in tuple(self._paths):
                with suppress(OSError):
                    if path not in self._packed and os.path.getsize(path) > LONG:
                        self._packed[path] = Packed(path)
                if path in self._packed:
                    self._packed[path].go_on()

    def stop(self) -> None:
        """Follow nothing any more."""
        self._stop.set()
        if self._thread:
            self._thread.join()

    def packed(self, path: str) -> Packed | None:
        """A file that is complete; None where it has still to be compressed. Only after `stop`."""
        packed = self._packed.pop(path, None)
        if packed is not None and not packed.end():
            packed.close()
            return None
        return packed

    def discard(self) -> None:
        """Delete what nobody asked for."""
        self.stop()
        for packed in self._packed.values():
            packed.close()
        self._packed.clear()


class Archive(ZipFile):
    """A new archive that takes files as a packer has compressed them. file: seekable, open for writing."""

    def __init__(self, file: Any, packer: Packer) -> None:
        super().__init__(file, "w", ZIP_DEFLATED, compresslevel=FAST)
        self._to, self._packer = file, packer

    def write(self, filename: Any, arcname: Any = None, *args: Any, **options: Any) -> None:
        """Add a file."""
        packed = self._packer.packed(filename)
        if packed is None:
            super().write(filename, arcname, *args, **options)
            return
        # zipfile cannot be told that content is compressed already: it goes in as it stands, and then the
        # header says what it is
        about = ZipInfo.from_file(filename, arcname)
        about.compress_type = ZIP_STORED
        with self.open(about, "w") as part:
            copyfileobj(packed.content, part, _CHUNK)
        packed.close()
        about.compress_type, about.CRC, about.file_size = ZIP_DEFLATED, packed.checksum, packed.size
        self._to.seek(about.header_offset)
        self._to.write(about.FileHeader())
