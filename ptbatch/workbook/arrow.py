"""pyarrow, which reads and writes Parquet: an extra, imported only where a Parquet file is touched."""

from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ptbatch.errors import PtbatchError, ReadError

INSTALL = "pip install 'ptbatch[parquet]'"


class MissingArrowError(PtbatchError):
    """Parquet is asked for, but pyarrow is not installed."""

    def __init__(self) -> None:
        super().__init__(f"Parquet needs pyarrow, which is not installed: {INSTALL}")


def has_arrow() -> bool:
    """Whether Parquet can be read and written."""
    return find_spec("pyarrow") is not None


def load_arrow() -> Any:
    """The module pyarrow, its part `parquet` with it. Raises MissingArrowError."""
    if not has_arrow():
        raise MissingArrowError()
    import pyarrow.parquet

    return pyarrow


@contextmanager
def opened(path: Path) -> Iterator[Any]:
    """A Parquet file to be read; what is wrong with it becomes a ReadError."""
    arrow = load_arrow()
    try:
        with arrow.parquet.ParquetFile(path) as file:
            yield file
    except arrow.ArrowException as error:
        raise ReadError(f"the file is not a Parquet file or damaged ({type(error).__name__})") from error
