"""An expected number, and the line of the report that comes of it."""

from dataclasses import dataclass
from typing import Literal, NamedTuple

from ptbatch.workbook.units import parse_header

Value = float | str
Verdict = Literal["pass", "fail", "not reproducible"]

PASS: Verdict = "pass"
FAIL: Verdict = "fail"
NOT_REPRODUCIBLE: Verdict = "not reproducible"


class Query(NamedTuple):
    """A number among the results: quantity as typed; stage and x [mm] for the sheet `tendon`, deflection [mm]
    for `curves`."""

    member: str
    quantity: str
    stage: str | None = None
    x: float | None = None
    deflection: float | None = None

    @property
    def name(self) -> str:
        """Name of the quantity, without its unit."""
        return parse_header(self.quantity).name

    @property
    def unit(self) -> str:
        """Unit of the quantity as typed, empty for that of the results."""
        return parse_header(self.quantity).unit

    def __str__(self) -> str:
        at = [self.stage] if self.stage else []
        at += [f"x = {self.x:.6g} mm"] if self.x is not None else []
        at += [f"at {self.deflection:.6g} mm"] if self.deflection is not None else []
        return ", ".join([self.name, *at])


@dataclass(frozen=True)
class Entry:
    """One row of a published table. rtol and atol are None where it gives none; base is what a difference is
    told as a share of."""

    case: str
    of: Query
    value: Value | None
    source: str
    kind: str = "frozen"
    how: str = "value"
    against: Query | None = None
    base: Query | None = None
    bound: str = "equal"
    rtol: float | None = None
    atol: float | None = None
    not_reproducible: str = ""
    note: str = ""

    @property
    def what(self) -> str:
        """What is compared, in words."""
        if self.against is None:
            return str(self.of)
        words = {"ratio": "/", "difference": "less"}
        share = f", as a share of {self.base.name}" if self.base else ""
        return f"{self.of} {words[self.how]} {_different(self.against, self.of)}{share}"


def _different(other: Query, of: Query) -> str:
    """What of another query is not that of the first."""
    same = other._replace(member=of.member)
    if same == of:
        return f"that of {other.member}"
    parts = [str(other) if other.name != of.name else f"x = {other.x:.6g} mm"]
    return " of ".join(parts + ([other.member] if other.member != of.member else []))


@dataclass(frozen=True)
class Line:
    """One line of the report: an entry with what the results say. ours is None where they say nothing."""

    case: str
    member: str
    what: str
    ours: Value | None
    theirs: Value | None
    unit: str
    tolerance: str
    verdict: Verdict
    because: str = ""
    kind: str = ""
    source: str = ""
    note: str = ""

    @property
    def ratio(self) -> float | None:
        """Ours over theirs, where both are numbers and theirs is not zero."""
        if isinstance(self.ours, str) or isinstance(self.theirs, str) or not self.theirs:
            return None
        return None if self.ours is None else self.ours / self.theirs
