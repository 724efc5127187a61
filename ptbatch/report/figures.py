"""The figures of a member in a report."""

from collections.abc import Iterator
from typing import NamedTuple

from markupsafe import Markup

from ptbatch.member import Member
from ptbatch.plots.missing import missing
from ptbatch.plots.pages import TITLES, drawing_of, figure_of
from ptbatch.report.svg import inline
from ptbatch.workbook.column import System
from ptbatch.workbook.stored import Stored

HEIGHTS = {"stress": 2.15, "redistribution": 2.15, "load-deflection": 2.8, "cracks": 1.6}  # inches: one page


class Picture(NamedTuple):
    """A figure with its title."""

    title: str
    svg: Markup


def drawing(member: Member, prefix: str, system: System) -> Markup:
    """The member before any analysis: elevation and section."""
    return inline(drawing_of(member, system), f"{prefix}-geometry", "Elevation and section")


def pictures(stored: Stored, prefix: str) -> Iterator[Picture]:
    """What came of it, as far as it goes."""
    for kind, height in HEIGHTS.items():
        if not missing(stored, kind):
            figure = figure_of([stored], kind, height)
            figure.axes[0].set_title("", loc="left")  # it stands in the page
            yield Picture(TITLES[kind], inline(figure, f"{prefix}-{kind}", TITLES[kind]))


def undrawn(stored: Stored) -> list[str]:
    """Titles of the figures that there are not."""
    return [TITLES[kind] for kind in HEIGHTS if missing(stored, kind)]
