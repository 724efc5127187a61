"""Elongations for the site: what is to be measured at each live end, and how far it may be off."""

from dataclasses import dataclass
from fractions import Fraction

from ptbatch.member import Member
from ptbatch.response import Response

BAND = 0.07  # ACI 318-19, 26.10.2 (e)
EIGHTH = 25.4 / 8.0  # mm
MM = 1.0


@dataclass(frozen=True)
class Elongation:
    """Theoretical elongation at one live end [mm], before and after the wedges have drawn in, and the jacking
    force [N]."""

    end: str
    jack_force: float
    before: float
    after: float

    @property
    def least(self) -> float:
        """The smallest that may be measured after the set [mm]."""
        return (1.0 - BAND) * self.after

    @property
    def most(self) -> float:
        """The largest that may be measured after the set [mm]."""
        return (1.0 + BAND) * self.after

    @property
    def rounded(self) -> str:
        """What can be read off a tape: to 1 mm, and to 1/8 in."""
        return f"{round(self.after / MM)} mm; {inches(self.after)} in"

    @property
    def warning(self) -> str:
        """Where reading a tape may be as far off as the band; else empty."""
        coarse = [text for step, text in ((MM, "1 mm"), (EIGHTH, "1/8 in")) if 0.5 * step > BAND * self.after]
        return f"rounding to {' or '.join(coarse)} alone exceeds 7 %" if coarse else ""


def inches(length: float) -> str:
    """A length [mm] in inches, to the nearest eighth: `3 3/8`."""
    eighths = round(length / EIGHTH)
    whole, rest = divmod(eighths, 8)
    part = str(Fraction(rest, 8)) if rest else ""
    return " ".join(filter(None, (str(whole) if whole or not part else "", part)))


def elongations(member: Member, response: Response) -> list[Elongation]:
    """At each live end, from the left; none where the member was not anchored."""
    if response.elongation_after is None:
        return []
    ends = ("left", "right") if member.jack == "both" else (member.jack,)
    force = response.fpj * member.intact_area
    pairs = zip(ends, response.elongations, strict=True)
    return [Elongation(end, force, before, before - member.set) for end, before in pairs]
