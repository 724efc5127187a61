"""One writer of a file at a time. The lock goes with the process that holds it, however that ends."""

import os
import sys
from typing import BinaryIO

_FAR = 2**62  # Windows locks bytes; this one is never read


def lock(file: BinaryIO) -> bool:
    """Take the lock of an open file; False if another process holds it."""
    try:
        _take(file.fileno())
    except OSError:
        return False
    return True


if sys.platform == "win32":
    import msvcrt

    def _take(number: int) -> None:
        os.lseek(number, _FAR, os.SEEK_SET)
        msvcrt.locking(number, msvcrt.LK_NBLCK, 1)

else:
    import errno
    import fcntl

    def _take(number: int) -> None:
        try:
            fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in (errno.EWOULDBLOCK, errno.EACCES):
                raise
            # a file system that knows no locks: go on without one
