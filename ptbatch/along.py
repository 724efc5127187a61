"""What lies along a member: tendon points, bars over a part of it, loads. x from the left end."""

from typing import NamedTuple


class Point(NamedTuple):
    """A point of the tendon: x and depth below the top fibre [mm]."""

    x: float
    dp: float


class Bar(NamedTuple):
    """Bars: their ends and depth below the top fibre [mm], area [mm2], yield stress [MPa]."""

    x_start: float
    x_end: float
    depth: float
    area: float
    fy: float


class Load(NamedTuple):
    """A load: case dead or live, type point [N] (x_end = x) or uniform [N/mm], down positive."""

    case: str
    type: str
    x: float
    x_end: float
    value: float
