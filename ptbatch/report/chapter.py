"""All that a report says of one member."""

from dataclasses import dataclass

from markupsafe import Markup

from ptbatch.plots.missing import lack, missing
from ptbatch.report.capacity import Event, at_peak, events, quality
from ptbatch.report.causes import Cause, causes
from ptbatch.report.checks import Line, checks
from ptbatch.report.derivation import Step, derivation
from ptbatch.report.figures import Picture, drawing, pictures, undrawn
from ptbatch.report.given import Given, given
from ptbatch.report.overview import PASSED
from ptbatch.report.source import Source
from ptbatch.report.stressing import Stage, camber, stages
from ptbatch.workbook.stored import Stored


@dataclass(frozen=True)
class Chapter:
    """One member; what it does not have is empty, and `lack` names it."""

    name: str
    link: str
    status: str
    message: str
    note: str
    lack: str
    faults: list[tuple[str, ...]]
    drawing: Markup | None
    given: dict[str, list[Given]]
    stages: list[Stage]
    camber: str
    causes: list[Cause]
    derivation: list[Step]
    events: list[Event]
    at_peak: list[tuple[str, str, str]]
    quality: str
    checks: list[Line]
    pictures: list[Picture]
    undrawn: list[str]


def chapter(stored: Stored, link: str, source: Source) -> Chapter:
    """What there is of a member. An invalid one has its faults alone."""
    member, message = stored.member, str(stored.summary.get("message") or "")
    loaded = len(stored.curves) > 0
    return Chapter(
        stored.name,
        link,
        str(stored.summary.get("status")),
        message,
        str(stored.summary.get("note") or ""),
        missing(stored, "all"),
        source.faults(message),
        drawing(member, link, stored.system) if member else None,
        given(member, stored.system) if member else {},
        stages(stored),
        camber(stored) if member else "",
        causes(stored),
        derivation(stored) if member else [],
        events(stored) if loaded else [],
        at_peak(stored),
        quality(stored),
        checks(stored),
        list(pictures(stored, link)),
        undrawn(stored) if member else [],
    )


def lacking(stored: Stored) -> str:
    """What there is not of a member, and why; '' if it has everything."""
    if what := missing(stored, "all"):
        return lack(stored, what)
    status = str(stored.summary.get("status"))
    return "" if status in PASSED else f"{stored.name} is {status}"
