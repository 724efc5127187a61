"""Wobble the way the paper words it: one sine of one amplitude along a whole tendon, as points of a profile.

The paper adjusts its period and its magnitude so that the profile turns by (mu alpha + k x) / mu in all, and
prints neither. Here a half wave is two beam elements long, as with `wobble` = `sine`, and the sine starts
from zero at the left end. Unlike `wobble` = `sine`, which turns evenly, one amplitude turns a tendon most
where it is flat: where it bends anyway, a wave that bends it less turns nothing back.
"""

from collections.abc import Iterator
from itertools import pairwise
from math import atan, pi, sin
from types import SimpleNamespace

from examples.paper.members import Row, specimens
from ptbatch.geometry.curve import Profile
from ptbatch.geometry.profile import ideal_profile

ELEMENTS = 30  # of a span; the paper has 59 along both
PER_WAVE = 4
FOOT, INCH = 304.8, 25.4  # mm
WAY = "one sine"

Point = tuple[float, float]


def specimens_with_one_sine() -> list[Row]:
    """Both specimens with both sets; all friction is in the profile."""
    note = "Wobble in the profile, as in the paper: one sine of {:.2f} mm, {:.0f} mm long; see sheet profile."
    rows = []
    for row in ideal_specimens():
        size = amplitude(row)
        same = {name: value for name, value in row.items() if name not in ("dp [in]", "inflection")}
        told = f"{row['note']} {note.format(size, PER_WAVE * _spacing(row))}"
        others = {"K [1/ft]": 0, "elements": ELEMENTS, "note": told}
        rows.append(same | others | {"member": f"{row['member']}, {WAY}"})
    return rows


def profile_rows() -> Iterator[Row]:
    """Their tendons at the beam nodes, as rows of the sheet `profile`."""
    for row in ideal_specimens():
        for x, depth in points(row, amplitude(row)):
            place = {"x [mm]": round(x, 3), "dp [mm]": round(depth, 4)}
            yield {"member": f"{row['member']}, {WAY}"} | place


def amplitude(row: Row, *wave: float) -> float:
    """Amplitude [mm] that makes the tendon of a specimen turn by K / mu times its length more than the ideal
    one.

    wave: beam elements to a wave and its phase at the left end [rad], where they are not those above.
    """
    profile = _profile(row)
    length = float(profile.arc_length(profile.breaks[-1]))
    wanted = profile.total_angle + row["K [1/ft]"] / row["mu [1/rad]"] * length / FOOT
    low, high = 0.0, 100.0
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _turned(points(row, middle, *wave)) < wanted else (low, middle)
    return low


def ideal_specimens() -> list[Row]:
    """Specimens with a set, their profiles without waves."""
    return [row for row in specimens() if row["set [in]"] and "wobble" not in row]


def _spacing(row: Row) -> float:
    """Length of a beam element [mm]."""
    return _numbers(row["span [ft]"])[0] * FOOT / ELEMENTS


def _profile(row: Row) -> Profile:
    shape = SimpleNamespace(
        span=[length * FOOT for length in _numbers(row["span [ft]"])],
        dp=[depth * INCH for depth in _numbers(row["dp [in]"])],
        profile="parabola",
        inflection=row["inflection"],
        profile_points=(),
    )
    return ideal_profile(shape)


def points(row: Row, size: float, per_wave: float = PER_WAVE, phase: float = 0.0) -> list[Point]:
    """x and depth [mm] at the beam nodes."""
    profile, step = _profile(row), _spacing(row)
    nodes = [(i, i * step) for i in range(round(profile.breaks[-1] / step) + 1)]
    return [(x, float(profile.depth(x)) + size * sin(2.0 * pi * i / per_wave + phase)) for i, x in nodes]


def _turned(line: list[Point]) -> float:
    """Angle [rad] that a polyline turns by."""
    slopes = [atan((d2 - d1) / (x2 - x1)) for (x1, d1), (x2, d2) in pairwise(line)]
    return sum(abs(after - before) for before, after in pairwise(slopes))


def _numbers(text: str) -> list[float]:
    return [float(item) for item in text.split(";")]
