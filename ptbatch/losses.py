"""Analytic friction and wedge-set losses: eq. (38) of the paper on the exact angle of the tendon.

f(x) = mu * angle + K * arc length is the friction exponent from the left end; jacking from there leaves
fpj exp(-f). When the wedge sets, the tendon slips back as far as a point that stays still, friction turns
round, and the stress rises from the anchor to that point. The area between both curves over the arc length is
Ep * set.

Every reversed curve is level * growth + offset, so that for a given still point the area makes the level the
root of a linear equation. The still point is where the reversed curve so found meets what lies beyond it, the
jacked curve or the reversed curve of the other live end. If it meets nothing, all of the tendon moves.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike

from ptbatch.geometry.curve import GAUSS_POINTS, GAUSS_WEIGHTS, Array
from ptbatch.geometry.pieces import first_rise, running_integral

End = Literal["left", "right"]
Reversal = Literal["friction", "mirror"]

STILL = 1e-10  # of the length: how near the still point is found; the stress there is a maximum or a minimum

LIVE_ENDS: dict[str, tuple[End, ...]] = {"left": ("left",), "right": ("right",), "both": ("left", "right")}


class Path(Protocol):
    """What the losses ask of a tendon, smooth between its breaks; `Profile` has it."""

    @property
    def breaks(self) -> Array: ...
    def slope(self, x: ArrayLike) -> Array: ...
    def angle(self, x: ArrayLike) -> Array: ...
    def arc_length(self, x: ArrayLike) -> Array: ...


@dataclass(frozen=True, eq=False)
class Friction:
    """Curves along a tendon as ratios to fpj, and their integrals over its arc length."""

    path: Path
    mu: float
    K: float
    live: tuple[End, ...]
    reversal: Reversal = "friction"

    @cached_property
    def ends(self) -> dict[End, float]:
        """x of both ends [mm]."""
        return {"left": float(self.path.breaks[0]), "right": float(self.path.breaks[-1])}

    @cached_property
    def length(self) -> float:
        """Arc length of the tendon [mm]."""
        return float(self.path.arc_length(self.ends["right"]))

    @cached_property
    def total(self) -> float:
        """Friction exponent of the whole tendon."""
        return float(self.exponent(self.ends["right"], "left"))

    def exponent(self, x: ArrayLike, end: End) -> Array:
        """Friction exponent between x and an end."""
        f = self.mu * self.path.angle(x) + self.K * self.path.arc_length(x)
        return f if end == "left" else self.total - f

    def jacked(self, x: ArrayLike) -> Array:
        """The larger of the one-end curves of the live ends."""
        return self._jacked(self.exponent(x, "left"))

    def curves(self, from_left: Array, end: End) -> tuple[Array, Array, Array]:
        """The jacked curve; growth and offset of the curve that reversed friction allows from an end; all by
        the friction exponent from the left."""
        f, jacked = from_left if end == "left" else self.total - from_left, self._jacked(from_left)
        if self.reversal == "friction":
            return jacked, np.exp(f), np.zeros_like(f)
        # It climbs as the jacked curve falls, and with it where the other jack has stressed the tendon.
        beyond = (f > self.total / 2.0) & (len(self.live) == 2)
        return jacked, np.ones_like(f), np.where(beyond, jacked - 2.0 * np.exp(-self.total / 2.0), -jacked)

    def _jacked(self, from_left: Array) -> Array:
        least = {"left": from_left}
        if "right" in self.live:
            least["right"] = self.total - from_left
        return np.exp(-np.minimum.reduce([least[end] for end in self.live]))

    @cached_property
    def stations(self) -> Array:
        """Points between which all is smooth: the breaks and, for two live ends, where their curves cross."""
        if len(self.live) == 1:
            return self.path.breaks
        exponents, _ = self._between(self.path.breaks)
        crossing = first_rise(self.path.breaks, exponents - self.total / 2.0, STILL)
        return self.path.breaks if crossing is None else np.unique(np.append(self.path.breaks, crossing))

    def quadrature(self, end: End, x: float) -> tuple[Array, Array]:
        """Friction exponents from the left, and weights, of an integral over the arc length from an end to x,
        the last of them at x itself, without weight: Gauss between the stations, of which only the last piece
        is new each time."""
        exponents, stretch = self.pieces
        at = int(np.searchsorted(self.stations, x, side="right" if end == "left" else "left"))
        inner = self.stations[max(at - 1, 0)] if end == "left" else self.stations[min(at, len(exponents))]
        whole = slice(0, max(at - 1, 0)) if end == "left" else slice(at, None)
        width = abs(x - inner)
        points = min(inner, x) + width * GAUSS_POINTS
        last = width * GAUSS_WEIGHTS * np.hypot(1.0, self.path.slope(points))
        return (
            np.concatenate([exponents[whole].ravel(), self.exponent(np.append(points, x), "left")]),
            np.concatenate([(stretch[whole] * GAUSS_WEIGHTS).ravel(), last, [0.0]]),
        )

    @cached_property
    def pieces(self) -> tuple[Array, Array]:
        """Friction exponents from the left at the Gauss points between the stations (pieces, points), and
        there the arc length by the length of the piece [mm]."""
        return self._between(self.stations)

    def _between(self, edges: Array) -> tuple[Array, Array]:
        width = np.diff(edges)[:, None]
        x = edges[:-1, None] + width * GAUSS_POINTS
        stretch = width * np.hypot(1.0, self.path.slope(x))
        return self.mu * self.path.angle(x) + self.K * running_integral(stretch), stretch

    @cached_property
    def jacked_area(self) -> float:
        """Area under the jacked curve [mm]."""
        exponents, stretch = self.pieces
        return float((self._jacked(exponents) * stretch @ GAUSS_WEIGHTS).sum())


@dataclass(frozen=True, eq=False)
class Losses:
    """Stress along a tendon after jacking and after the wedge set.

    level: of the reversed curve of each live end, see the top of the module.
    still: x [mm] of the point up to which the set at each live end moves the tendon.
    """

    friction: Friction
    fpj: float
    Ep: float
    wedge_set: float
    level: dict[End, float]
    still: dict[End, float]

    def stress_jacked(self, x: ArrayLike) -> Array:
        """Stress at x while jacking [MPa], the shape of x."""
        return self.fpj * self.friction.jacked(x)

    def stress_anchored(self, x: ArrayLike) -> Array:
        """Stress at x after the wedge set [MPa], the shape of x."""
        least, from_left = [], self.friction.exponent(x, "left")
        for end, level in self.level.items():
            jacked, growth, offset = self.friction.curves(from_left, end)
            least += [jacked, level * growth + offset]
        return self.fpj * np.minimum.reduce(least)

    @property
    def set_length(self) -> float:
        """Arc length [mm] that the set moves, from the live end (the left one of two)."""
        end, x = next(iter(self.still.items()))
        to_left = float(self.friction.path.arc_length(x))
        return to_left if end == "left" else self.friction.length - to_left

    @property
    def loss_jacking_end(self) -> float:
        """1 - anchored / fpj at the live end (the left one of two)."""
        return 1.0 - float(self.stress_anchored(self.friction.ends[self.friction.live[0]])) / self.fpj

    @property
    def loss_fixed_end(self) -> float:
        """1 - anchored / fpj at the dead end, or where the stress is least if both ends are live."""
        ends = self.friction.ends
        x = np.array([x for end, x in ends.items() if end not in self.friction.live])
        if not x.size:
            # Just beside each station: half way through a kink is no stress of the tendon on either side.
            x = np.array([np.nextafter(self.friction.stations, side) for side in ends.values()])
        return 1.0 - float(np.min(self.stress_anchored(x))) / self.fpj

    @property
    def elongation_before(self) -> float:
        """Elongation of the tendon while jacking [mm], the sum over the live ends."""
        return self.fpj * self.friction.jacked_area / self.Ep

    @property
    def elongation_after(self) -> float:
        """Elongation after the set [mm]: each live end has given back the set, however far that is felt."""
        return self.elongation_before - self.wedge_set * len(self.level)

    @property
    def mean_anchored(self) -> float:
        """Mean stress over the arc length after the set [MPa]."""
        return self.Ep * self.elongation_after / self.friction.length


def analytic_losses(
    path: Path,
    fpj: float,
    mu: float,
    K: float,
    Ep: float,
    wedge_set: float,
    jack: str,
    reversal: Reversal = "friction",
) -> Losses:
    """Friction and wedge-set losses of a tendon.

    fpj, Ep [MPa]; mu [1/rad]; K [1/mm of arc length]; wedge_set [mm] at each live end; jack: left, right or
    both. reversal: `friction` lets the stress grow as exp(f) from the anchor, Coulomb friction of the lowered
    force; `mirror` is the textbook construction, the jacked curve upside down, friction of the jacked force.
    Source: eq. (38); area between both curves = Ep * set on each side of the still point.
    Raises ValueError if jack is none of the three or the set leaves the tendon slack.
    """
    friction = Friction(path, mu, K, _live_ends(jack), reversal)
    removed = Ep * wedge_set / fpj
    still = {end: _still_point(friction, end, removed) for end in friction.live}
    if len(still) == 2 and still["left"] > still["right"]:
        still = dict.fromkeys(still, _meeting_point(friction, removed))
    level = {end: _level(friction, end, x, removed) for end, x in still.items()}
    losses = Losses(friction, fpj, Ep, wedge_set, level, still)
    if min(losses.stress_anchored(friction.ends[end]) for end in friction.live) <= 0.0:
        raise ValueError(
            f"set: {wedge_set:g} mm at each live end leaves the tendon slack, "
            f"jacking elongates it by {losses.elongation_before:.4g} mm only"
        )
    return losses


def fpj_for_mean(
    path: Path, fpe: float, mu: float, K: float, Ep: float, wedge_set: float, jack: str
) -> float:
    """Jacking stress [MPa] that leaves the mean stress fpe [MPa] after anchoring; see `analytic_losses`.

    Each set takes Ep * set off the area under the jacked curve, wherever it does so: no iteration.
    """
    friction = Friction(path, mu, K, _live_ends(jack))
    return (fpe * friction.length + Ep * wedge_set * len(friction.live)) / friction.jacked_area


def _live_ends(jack: str) -> tuple[End, ...]:
    if jack not in LIVE_ENDS:
        raise ValueError(f"jack: {jack!r} is none of {', '.join(LIVE_ENDS)}")
    return LIVE_ENDS[jack]


@dataclass(frozen=True)
class Zone:
    """The area condition b * level = a of a reversed curve that runs from an end to x, and the curves at x,
    all of the shape of x."""

    a: Array
    b: Array
    jacked: Array
    growth: Array
    offset: Array


def _zone(friction: Friction, end: End, x: float, removed: float) -> Zone:
    exponents, weights = friction.quadrature(end, x)
    jacked, growth, offset = friction.curves(exponents, end)
    a, b = (jacked - offset) @ weights - removed, growth @ weights
    return Zone(a, b, jacked[-1], growth[-1], offset[-1])


def _zones(friction: Friction, end: End, removed: float) -> Zone:
    """Of every x that is a Gauss point between the stations."""
    exponents, stretch = friction.pieces
    jacked, growth, offset = friction.curves(exponents, end)
    a = running_integral(stretch * (jacked - offset), end) - removed
    return Zone(a, running_integral(stretch * growth, end), jacked, growth, offset)


def _level(friction: Friction, end: End, x: float, removed: float) -> float:
    zone = _zone(friction, end, x, removed)
    if zone.b > 0.0:
        return float(zone.a / zone.b)
    return float((1.0 - zone.offset) / zone.growth)  # no set, no zone: fpj stays at the anchor


def _still_point(friction: Friction, end: End, removed: float) -> float:
    """x where the reversed curve of one end meets the jacked curve; the far end if it stays below it."""
    near, far = friction.ends[end], friction.ends["right" if end == "left" else "left"]
    if removed == 0.0:
        return near
    zone = _zones(friction, end, removed)
    excess = zone.a * zone.growth + zone.b * (zone.offset - zone.jacked)  # times b: negative at the near end
    met = first_rise(friction.stations, excess, STILL, end)
    return far if met is None else met


def _meeting_point(friction: Friction, removed: float) -> float:
    """x where the reversed curves of two live ends meet, each having lost its own area on its own side."""
    left, right = (_zones(friction, end, removed) for end in LIVE_ENDS["both"])
    reach = [zone.a * zone.growth + zone.b * zone.offset for zone in (left, right)]  # times b
    met = first_rise(friction.stations, reach[0] * right.b - reach[1] * left.b, STILL)
    return friction.ends["right"] if met is None else met
