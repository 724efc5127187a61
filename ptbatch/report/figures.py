"""The figures of a member in a report, each with its caption."""

from collections.abc import Iterator
from typing import NamedTuple

from markupsafe import Markup

from ptbatch.plots.missing import lack, missing
from ptbatch.plots.pages import TITLES, drawing_of, figure_of
from ptbatch.report.svg import inline
from ptbatch.workbook.stored import Stored

HEIGHTS = {"stress": 2.15, "redistribution": 2.15, "load-deflection": 2.75, "cracks": 1.6}  # inches: one page


class Picture(NamedTuple):
    """A figure, or why there is none."""

    title: str
    svg: Markup | None
    lack: str


def drawing(stored: Stored, prefix: str) -> Picture:
    """The member before any analysis: elevation and section."""
    title = "Elevation and section"
    if stored.member is None:
        return Picture(title, None, lack(stored, missing(stored, "all")))
    return Picture(title, inline(drawing_of(stored.member), f"{prefix}-geometry", title), "")


def pictures(stored: Stored, prefix: str) -> Iterator[Picture]:
    """What came of it."""
    for kind, height in HEIGHTS.items():
        if what := missing(stored, kind):
            yield Picture(TITLES[kind], None, lack(stored, what))
            continue
        figure = figure_of([stored], kind, height)
        figure.axes[0].set_title("", loc="left")
        yield Picture(TITLES[kind], inline(figure, f"{prefix}-{kind}", TITLES[kind]), "")
