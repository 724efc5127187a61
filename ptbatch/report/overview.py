"""All members of a report in one table."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ptbatch.report.words import Words, fixed
from ptbatch.workbook.stored import Stored

PASSED = ("ok", "warning")
LOSSES = ("loss_jacking_end_fe [%]", "loss_fixed_end_fe [%]")


class Line(NamedTuple):
    """A member: name, link to its chapter, kind, spans, status; losses [%], capacity and failure, or the
    reason why there are none."""

    name: str
    link: str
    kind: str
    spans: str
    status: str
    losses: tuple[str, ...]
    capacity: tuple[str, ...]
    reason: str


def line(stored: Stored, link: str) -> Line:
    """The line of a member."""
    member, status = stored.member, str(stored.summary.get("status"))
    words = Words(stored.system)
    losses = tuple(words.said(stored.summary.get(header), "%") for header in LOSSES)
    factor = stored.value("load_factor_peak")
    capacity = (
        words.said(stored.summary.get("load_peak [kN]"), "kN"),
        fixed(factor, "-") if np.isfinite(factor) else "none given",  # a service load
        str(stored.summary.get("failure")),
    )
    return Line(
        stored.name,
        link,
        member.kind if member else "",
        " + ".join(words.digits(span / 1e3, "m") for span in member.span) if member else "",
        status,
        losses if all(np.isfinite(stored.value(header)) for header in LOSSES) else (),
        capacity if np.isfinite(stored.value("load_peak [kN]")) else (),
        str(stored.summary.get("message") or status),
    )


def counts(lines: list[Line]) -> Iterator[tuple[str, int]]:
    """Number of members of each status, in the order in which they come up."""
    statuses = [line.status for line in lines]
    for status in dict.fromkeys(statuses):
        yield status, statuses.count(status)
