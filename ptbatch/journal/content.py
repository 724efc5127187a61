"""Outcomes as bytes and back, to the last digit: compressed JSON, which can hold nothing but values."""

import json
import zlib
from collections.abc import Mapping, Sequence
from numbers import Integral
from typing import Any

from ptbatch.workbook.results import DETAILS, SUMMARY, Outcome

FAST = 1  # of zlib: the digits of a result hardly compress any further


def encode(outcome: Outcome) -> bytes:
    """Bytes of an outcome."""
    tables = [_lines(getattr(outcome, name), headers[1:]) for name, headers in DETAILS.items()]
    values = [outcome.status, outcome.message, [outcome.summary[header] for header in SUMMARY], *tables]
    return zlib.compress(json.dumps(values, separators=(",", ":"), default=_plain).encode(), FAST)


def decode(content: bytes) -> Outcome:
    """The outcome again."""
    status, message, summary, *tables = json.loads(zlib.decompress(content))
    rows = {
        name: [dict(zip(headers[1:], line, strict=True)) for line in lines]
        for (name, headers), lines in zip(DETAILS.items(), tables, strict=True)
    }
    return Outcome(status, message, dict(zip(SUMMARY, summary, strict=True)), **rows)


def _lines(rows: Sequence[Mapping[str, Any]], headers: Sequence[str]) -> list[list[Any]]:
    return [[row[header] for header in headers] for row in rows]


def _plain(value: Any) -> int | float:
    """A number of numpy as one of Python."""
    return int(value) if isinstance(value, Integral) else float(value)
