"""pyarrow, which reads and writes Parquet: an extra, since it is five times as large as ptbatch with numpy."""

from importlib.util import find_spec
from typing import Any

from ptbatch.errors import PtbatchError

INSTALL = "pip install 'ptbatch[parquet]'"


class MissingArrowError(PtbatchError):
    """Parquet is asked for, but pyarrow is not installed."""

    def __init__(self) -> None:
        super().__init__(f"Parquet needs pyarrow, which is not installed: {INSTALL}")


def has_arrow() -> bool:
    """Whether Parquet can be read and written."""
    return find_spec("pyarrow") is not None


def parquet_module() -> Any:
    """`pyarrow.parquet`. Raises MissingArrowError."""
    if not has_arrow():
        raise MissingArrowError()
    import pyarrow.parquet

    return pyarrow.parquet


def arrow_module() -> Any:
    """`pyarrow`. Raises MissingArrowError."""
    if not has_arrow():
        raise MissingArrowError()
    import pyarrow

    return pyarrow
