"""The curve of a tendon: depth, slope, arc length and turned angle along a member.

It is a chain of straight and parabolic pieces. x runs to the right from the left end and depth is measured
downwards from the top fibre, both in mm; angles are in radians.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Side = Literal["left", "right"]

PLACES = 801  # of the table from arc length to place
KINK = 1e-9  # rad; a smaller change of direction is round-off
GAUSS_POINTS, GAUSS_WEIGHTS = (leggauss(20) + np.array([[1.0], [0.0]])) / 2.0  # on (0, 1)
FEW_POINTS, FEW_WEIGHTS = (leggauss(8) + np.array([[1.0], [0.0]])) / 2.0
LITTLE = 0.5  # change of slope along a piece up to which few points are exact


@dataclass(frozen=True, eq=False)
class Profile:
    """Piecewise quadratic tendon profile, continuous in depth.

    breaks: shape (n + 1,), ends of the pieces [mm], strictly increasing (ValueError otherwise).
    coefficients: shape (n, 3); depth = c0 + c1 t + c2 t^2 on each piece, t from the left end of the piece.

    Every method takes x of any shape between the two ends and returns that shape. A piece turns one way only.
    """

    breaks: Array
    coefficients: Array

    def __post_init__(self) -> None:
        if not np.all(np.diff(self.breaks) > 0.0):
            raise ValueError(f"profile: x must increase from point to point, got {self.breaks.tolist()}")

    def depth(self, x: ArrayLike) -> Array:
        """Depth of the tendon below the top fibre [mm]."""
        return self._depth(*self._locate(x))

    def slope(self, x: ArrayLike, side: Side = "right") -> Array:
        """d depth / dx; at a kink that of the piece on the given side."""
        return self._slope(*self._locate(x, side))

    def arc_length(self, x: ArrayLike) -> Array:
        """Length of the tendon from its left end to x [mm]."""
        piece, t = self._locate(x)
        return self._lengths[piece] + self._piece_length(piece, t)

    def place(self, s: Array) -> Array:
        """x at the arc length s [mm], to a hundred-thousandth of the length."""
        x, length = self._places
        return np.asarray(np.interp(s, length, x))

    @cached_property
    def _places(self) -> tuple[Array, Array]:
        """Places and the arc length up to them, by the trapezoidal rule: so short stretches are all but
        straight."""
        x = np.union1d(np.linspace(self.breaks[0], self.breaks[-1], PLACES), self.breaks)
        slopes = self.slope(x[:-1], "right"), self.slope(x[1:], "left")
        stretch = 0.5 * np.diff(x) * (np.hypot(1.0, slopes[0]) + np.hypot(1.0, slopes[1]))
        return x, np.append(0.0, np.cumsum(stretch))

    def angle(self, x: ArrayLike) -> Array:
        """Sum of absolute changes of direction from the left end to x [rad].

        The whole of a kink counts to the right of it, half of it at the kink itself.
        """
        piece, t = self._locate(x)
        turned = np.abs(np.arctan(self._slope(piece, t)) - self._directions[0][piece])
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

    def parabolas(self, x: ArrayLike) -> Array:
        """Coefficients (..., 3) of the parabolas right of x, t counted from there."""
        piece, t = self._locate(x)
        c0, c1, c2 = np.moveaxis(self.coefficients[piece], -1, 0)
        return np.stack([c0 + t * (c1 + t * c2), c1 + 2.0 * c2 * t, c2], axis=-1)

    def _locate(self, x: ArrayLike, side: Side = "right") -> tuple[NDArray[np.intp], Array]:
        """Piece that x lies in and distance from its left end; at a break the piece on the given side."""
        x = np.asarray(x, dtype=float)
        piece = np.asarray(self._inner.searchsorted(x, side=side))
        return piece, x - self.breaks[piece]

    def _depth(self, piece: NDArray[np.intp], t: Array) -> Array:
        """Depth at the distance t from the left end of each piece."""
        c = self.coefficients[piece]
        return c[..., 0] + t * (c[..., 1] + t * c[..., 2])

    def _slope(self, piece: NDArray[np.intp], t: Array) -> Array:
        """Slope at the distance t from the left end of each piece."""
        start, change = self._slopes
        return np.asarray(start[piece] + change[piece] * t)

    @cached_property
    def _inner(self) -> Array:
        """Where one piece follows on another."""
        return self.breaks[1:-1]

    @cached_property
    def _slopes(self) -> tuple[Array, Array]:
        """Slope at the start of each piece, and its change over a unit of length."""
        return self.coefficients[:, 1].copy(), 2.0 * self.coefficients[:, 2]

    def _piece_length(self, piece: NDArray[np.intp], t: Array) -> Array:
        """Arc length of the first t of each piece, exact to round-off on so smooth a curve."""
        points, weights = self._rule
        slopes = self._slope(piece[..., None], t[..., None] * points)
        return t * (np.hypot(1.0, slopes) @ weights)

    @cached_property
    def _rule(self) -> tuple[Array, Array]:
        """Points and weights of the Gauss rule for arc lengths: few will do where no piece turns far."""
        turns = 2.0 * np.abs(self.coefficients[:, 2] * np.diff(self.breaks))
        return (FEW_POINTS, FEW_WEIGHTS) if turns.max() < LITTLE else (GAUSS_POINTS, GAUSS_WEIGHTS)

    @cached_property
    def _directions(self) -> tuple[Array, Array]:
        """Direction [rad] at the start and at the end of each piece."""
        pieces, lengths = np.arange(len(self.coefficients)), np.diff(self.breaks)
        return np.arctan(self._slope(pieces, 0.0 * lengths)), np.arctan(self._slope(pieces, lengths))

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
