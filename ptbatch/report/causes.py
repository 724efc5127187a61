"""What takes the tendon's stress, cause by cause, as a report tells it."""

from typing import NamedTuple

from ptbatch.report.words import Words, fixed
from ptbatch.workbook.stored import Stored


class Cause(NamedTuple):
    """A cause, where its loss comes from, the loss, its share of the stress at the jack, and what is left."""

    name: str
    source: str
    loss: str
    share: str
    left: str


def causes(stored: Stored) -> list[Cause]:
    """All causes, in the order in which they act; none in results that do not tell them."""
    words = Words(stored.system)
    return [
        Cause(
            str(row["cause"]),
            str(row["source"]),
            words.number(row["loss [MPa]"], "MPa"),
            f"{fixed(row['share [%]'], '%')} %",
            words.number(row["stress_after [MPa]"], "MPa"),
        )
        for row in stored.losses.rows
    ]
