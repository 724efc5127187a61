"""Tendon profile: depth, slope, arc length and turned angle along a member.

A profile is a chain of straight and parabolic pieces. x runs to the right from the left end and depth is
measured downwards from the top fibre, both in mm; angles are in radians.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any, Literal

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Side = Literal["left", "right"]

KINK = 1e-9  # rad; a smaller change of direction is round-off
GAUSS_POINTS, GAUSS_WEIGHTS = (leggauss(20) + np.array([[1.0], [0.0]])) / 2.0  # on (0, 1)


@dataclass(frozen=True, eq=False)
class Profile:
    """Piecewise quadratic tendon profile, continuous in depth.

    breaks: shape (n + 1,), ends of the pieces [mm], strictly increasing (ValueError otherwise).
    coefficients: shape (n, 3); depth = c0 + c1 t + c2 t^2 on each piece, t from the left end of the piece.

    Every method takes x of any shape between the two ends and returns that shape. The profiles made by
    `tendon_profile` only rise or only fall between two breaks, so `depth(breaks)` holds the extreme depths.
    """

    breaks: Array
    coefficients: Array

    def __post_init__(self) -> None:
        if not np.all(np.diff(self.breaks) > 0.0):
            raise ValueError(f"profile: x must increase from point to point, got {self.breaks.tolist()}")

    def depth(self, x: ArrayLike) -> Array:
        """Depth of the tendon below the top fibre [mm]."""
        piece, t = self._locate(x)
        c = self.coefficients[piece]
        return c[..., 0] + t * (c[..., 1] + t * c[..., 2])

    def slope(self, x: ArrayLike, side: Side = "right") -> Array:
        """d depth / dx; at a kink that of the piece on the given side."""
        piece, t = self._locate(x, side)
        return self.coefficients[piece, 1] + 2.0 * self.coefficients[piece, 2] * t

    def arc_length(self, x: ArrayLike) -> Array:
        """Length of the tendon from its left end to x [mm]."""
        piece, t = self._locate(x)
        return self._lengths[piece] + self._piece_length(piece, t)

    def angle(self, x: ArrayLike) -> Array:
        """Sum of absolute changes of direction from the left end to x [rad].

        The whole of a kink counts to the right of it, half of it at the kink itself.
        """
        piece, t = self._locate(x)
        turned = np.abs(np.arctan(self.slope(x)) - self._directions[0][piece])
        return self._angles[piece] + turned - 0.5 * self._kink_angles[piece] * (t == 0.0)

    @cached_property
    def length(self) -> float:
        """Arc length of the whole tendon [mm]."""
        return float(self.arc_length(self.breaks[-1]))

    @cached_property
    def total_angle(self) -> float:
        """Angle turned over the whole tendon [rad]."""
        return float(self.angle(self.breaks[-1]))

    @cached_property
    def kinks(self) -> Array:
        """x of the points where the slope jumps [mm]."""
        return self.breaks[:-1][self._kink_angles > KINK]

    def _locate(self, x: ArrayLike, side: Side = "right") -> tuple[NDArray[np.intp], Array]:
        """Piece that x lies in and distance from its left end; at a break the piece on the given side."""
        x = np.asarray(x, dtype=float)
        piece = np.clip(np.searchsorted(self.breaks, x, side=side) - 1, 0, len(self.coefficients) - 1)
        return piece, x - self.breaks[piece]

    def _piece_length(self, piece: NDArray[np.intp], t: Array) -> Array:
        """Arc length of the first t of each piece; 20 points are exact to round-off on so smooth a curve."""
        c = self.coefficients[piece][..., None]
        slopes = c[..., 1, :] + 2.0 * c[..., 2, :] * t[..., None] * GAUSS_POINTS
        return t * (np.hypot(1.0, slopes) @ GAUSS_WEIGHTS)

    @cached_property
    def _directions(self) -> tuple[Array, Array]:
        """Direction [rad] at the start and at the end of each piece."""
        _, c1, c2 = self.coefficients.T
        return np.arctan(c1), np.arctan(c1 + 2.0 * c2 * np.diff(self.breaks))

    @cached_property
    def _kink_angles(self) -> Array:
        """Change of direction at the start of each piece; none at the left end."""
        start, end = self._directions
        return np.append(0.0, np.abs(start[1:] - end[:-1]))

    @cached_property
    def _angles(self) -> Array:
        """Angle turned up to the start of each piece, the kink there included."""
        start, end = self._directions
        return np.cumsum(self._kink_angles) + np.append(0.0, np.cumsum(np.abs(end - start))[:-1])

    @cached_property
    def _lengths(self) -> Array:
        """Arc length up to the start of each piece."""
        pieces = self._piece_length(np.arange(len(self.coefficients)), np.diff(self.breaks))
        return np.append(0.0, np.cumsum(pieces)[:-1])


def tendon_profile(member: Any) -> Profile:
    """Profile of a member's tendon.

    member: anything with span, profile, dp, harp, inflection and profile_points as in the workbook, in mm;
    points, where there are any, take the place of the named shape. Raises ValueError if the shape is unknown,
    the number of depths does not fit the spans, or the points do not run from one end of the member to the
    other.
    """
    if member.profile_points:
        return _through_points(member)
    if member.profile not in _SHAPES:
        raise ValueError(f"profile: {member.profile!r} is none of {', '.join(_SHAPES)}")
    wanted, given = 1 if member.profile == "straight" else 2 * len(member.span) + 1, len(member.dp)
    if given != wanted:
        raise ValueError(f"dp: {member.profile}, {len(member.span)} span(s): {wanted} wanted, {given} given")
    return _SHAPES[member.profile](member)


def _supports(member: Any) -> list[float]:
    """x of the ends of the spans [mm]."""
    return [0.0, *accumulate(member.span)]


def _polyline(x: Sequence[float], depth: Sequence[float]) -> Profile:
    with np.errstate(divide="ignore", invalid="ignore"):  # of coincident points, which Profile refuses
        slopes = np.diff(depth) / np.diff(x)
    return Profile(np.array(x, dtype=float), np.column_stack([depth[:-1], slopes, np.zeros_like(slopes)]))


def _through_points(member: Any) -> Profile:
    x, depth = zip(*member.profile_points, strict=True)
    end = _supports(member)[-1]
    if len(x) < 2 or not np.allclose([x[0], x[-1]], [0.0, end], rtol=0.0, atol=1e-6 * end):
        raise ValueError(f"profile points must run from x = 0 to x = {end:g} mm, got {x[0]:g} to {x[-1]:g}")
    return _polyline((0.0, *x[1:-1], end), depth)


def _straight(member: Any) -> Profile:
    return _polyline((0.0, _supports(member)[-1]), 2 * tuple(member.dp))


def _harped(member: Any) -> Profile:
    x, depth, supports = [0.0], [member.dp[0]], _supports(member)
    for i, span in enumerate(member.span):
        x += [*(supports[i] + part * span for part in member.harp), supports[i + 1]]
        depth += [member.dp[2 * i + 1]] * len(member.harp) + [member.dp[2 * i + 2]]
    return _polyline(x, depth)


def _parabola(member: Any) -> Profile:
    """Low point at midspan; over an interior support a reversed parabola with its peak there.

    Half a span that falls by D over its length a has the slope 2 D / a at the inflection point, wherever that
    is: both parabolas have this slope there and are level at their other ends. A reversed parabola of length
    r therefore takes D r / a of the fall. r = 0 at an outer end leaves one parabola.
    """
    knots: list[tuple[float, float, float]] = []  # x, depth, slope just right of it
    supports = _supports(member)
    for i, span in enumerate(member.span):
        left, low, right = member.dp[2 * i : 2 * i + 3]
        a = span / 2.0
        reach = member.inflection * span
        left_reach = reach if i > 0 else 0.0
        right_reach = reach if i < len(member.span) - 1 else 0.0
        steep_left, steep_right = 2.0 * (low - left) / a, 2.0 * (low - right) / a
        knots += [
            (supports[i], left, 0.0),
            (supports[i] + left_reach, left + (low - left) * left_reach / a, steep_left),
            (supports[i] + a, low, 0.0),
            (supports[i + 1] - right_reach, right + (low - right) * right_reach / a, -steep_right),
        ]
    x, depth, slope = np.array([*knots, (supports[-1], member.dp[-1], 0.0)]).T
    # Where a part has no length two knots coincide, and the last of them says how the tendon goes on.
    keep = np.append(np.diff(x) > 1e-9 * x[-1], True)
    x, depth, slope = x[keep], depth[keep], slope[keep][:-1]
    length = np.diff(x)
    return Profile(x, np.column_stack([depth[:-1], slope, (np.diff(depth) - slope * length) / length**2]))


_SHAPES = {"straight": _straight, "parabola": _parabola, "harped": _harped}
