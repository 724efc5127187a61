"""Outcomes as bytes and back, to the last digit: compressed JSON, which can hold nothing but values, and then
the columns of the tables that hold nothing but numbers.
"""

import json
import zlib
from collections.abc import Sequence
from itertools import chain
from numbers import Integral
from struct import Struct
from typing import Any

import numpy as np

from ptbatch.workbook.results import DETAILS, SUMMARY, Outcome

FAST = 1  # of zlib
DOUBLES = np.dtype("<f8")
_LENGTH = Struct("<I")


def encode(outcome: Outcome) -> bytes:
    """Bytes of an outcome."""
    tables, numbers = [], []
    for name in DETAILS:
        table: list[Any] = []
        for values in getattr(outcome, name).values():
            if set(map(type, values)) == {float}:
                numbers.append(values)
                values = len(values)
            table.append(values)
        tables.append(table)
    summary = [outcome.summary[header] for header in SUMMARY]
    text = json.dumps([outcome.status, outcome.message, summary, *tables], default=_plain).encode()
    packed = zlib.compress(text, FAST)
    return _LENGTH.pack(len(packed)) + packed + np.fromiter(chain(*numbers), DOUBLES).tobytes()


def decode(content: bytes) -> Outcome:
    """The outcome again."""
    (length,) = _LENGTH.unpack_from(content)
    start = _LENGTH.size + length
    status, message, summary, *tables = json.loads(zlib.decompress(content[_LENGTH.size : start]))
    numbers = iter(np.frombuffer(content, DOUBLES, offset=start).tolist())
    made = {
        name: dict(zip(headers[1:], [_column(values, numbers) for values in table], strict=bool(table)))
        for (name, headers), table in zip(DETAILS.items(), tables, strict=True)
    }
    return Outcome(status, message, dict(zip(SUMMARY, summary, strict=True)), **made)


def _column(values: Any, numbers: Any) -> Sequence[Any]:
    """A column: as it stands, or so many of the numbers."""
    return [next(numbers) for _ in range(values)] if isinstance(values, int) else values


def _plain(value: Any) -> int | float:
    """A number of numpy as one of Python."""
    return int(value) if isinstance(value, Integral) else float(value)
