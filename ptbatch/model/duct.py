"""The duct and the tendon at rest: heights, directions and arc length at the beam nodes, where the tendon
nodes start."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.contact import shape
from ptbatch.geometry.curve import FEW_POINTS, FEW_WEIGHTS, Profile
from ptbatch.losses import Losses

Array = NDArray[np.float64]

FINE = 8  # stretches an element, along which the movement is integrated: it decides on nothing but places
NEAR = 1e-9  # of the member: stations nearer to each other are one


@dataclass(frozen=True)
class Duct:
    """Duct above the reference axis: y, s (n+1,), slope (n, 2) at the ends of each segment, x (n+1,).

    Between two nodes it is the cubic with these heights and slopes: the profile itself, or a straight line.
    """

    x: Array
    y: Array
    slope: Array
    s: Array

    def point(self, s: Array) -> tuple[Array, NDArray[np.int64]]:
        """(x, y) of the duct as the kernels see it, at arc lengths s, and the segments they lie in."""
        m = self._segment(self.s, s)
        xi = (s - self.s[m]) / np.diff(self.s)[m]
        return np.column_stack([self.x[m] + xi * np.diff(self.x)[m], self._weighted(0, m, xi)]), m

    def direction(self, x: Array) -> Array:
        """Direction [rad] of the duct as the kernels see it, at x."""
        m = self._segment(self.x, x)
        h = np.diff(self.x)[m]
        return np.arctan(self._weighted(1, m, (x - self.x[m]) / h) / h)

    def _segment(self, nodes: Array, at: Array) -> NDArray[np.int64]:
        return np.clip(np.searchsorted(nodes, at, side="right") - 1, 0, len(self.x) - 2)

    def _weighted(self, derivative: int, m: NDArray[np.int64], xi: Array) -> Array:
        """Height in segments m at xi, or its derivative by xi."""
        h = np.diff(self.x)[m]
        w = shape.py_func(xi, True)[derivative]  # type: ignore[attr-defined]
        y, slope = (self.y[m], self.y[m + 1]), (h * self.slope[m, 0], h * self.slope[m, 1])
        return np.asarray(w[0] * y[0] + w[1] * slope[0] + w[2] * y[1] + w[3] * slope[1])


def duct(profile: Profile, x: Array, centroid: float, sheathing: str) -> Duct:
    """Duct through the profile at the beam nodes x; depths are measured from the top, heights from the
    centroid.

    sheathing: `smooth`, or `polygon` for the paper's straight segments between the nodes.
    """
    y = centroid - profile.depth(x)
    near = NEAR * x[-1]  # a node at a kink is there but for round-off
    slope = -np.column_stack([profile.slope(x[:-1] + near), profile.slope(x[1:] - near)])
    if sheathing == "polygon":
        slope[:] = (np.diff(y) / np.diff(x))[:, None]
    return Duct(x, y, slope, profile.arc_length(x))


def turning_tables(profile: Profile, line: Duct) -> tuple[Array, Array, Array]:
    """Arc-length stations (t,) at nodes and breaks, and there the first integrals over arc length of the
    absolute angle of the profile and of the signed direction of the duct, each as (t, 3): value, slope to the
    right, slope to the left.

    What the duct leaves out of the profile's angle, a polygon or one with coarse nodes, is hidden angle too.
    """
    near = NEAR * line.x[-1]
    at = np.unique(np.concatenate([line.x, profile.breaks]))
    at = at[np.append(True, np.diff(at) > near)]
    right, left = np.minimum(at + near, at[-1]), np.maximum(at - near, at[0])
    width = np.diff(at)[:, None]
    inside = at[:-1, None] + width * FEW_POINTS
    ds = width * np.hypot(1.0, profile.slope(inside)) * FEW_WEIGHTS

    everywhere = np.concatenate([inside.ravel(), right, left])

    def table(integrand: Callable[[Array], Array]) -> Array:
        within, beside = np.split(integrand(everywhere), [inside.size])
        integral = np.cumsum((within.reshape(ds.shape) * ds).sum(axis=1))
        return np.column_stack([np.append(0.0, integral), beside.reshape(2, -1).T])

    return profile.arc_length(at), table(profile.angle), table(line.direction)


@dataclass(frozen=True)
class TendonStart:
    """Tendon nodes before jacking: positions (n+2, 2), rest lengths (n+1,), segments (n+2,), arc lengths
    (n+2,), how far they will move to the right (n+2,), the two gaps."""

    position: Array
    rest: Array
    segment: NDArray[np.int64]
    s: Array
    moves: Array
    gap: tuple[float, float]


def tendon_start(
    line: Duct, profile: Profile, losses: Losses, live: tuple[bool, bool], Ep: float
) -> TendonStart:
    """Place the tendon so that jacking, by the analytic stresses, brings its ends to the anchors and its
    nodes to mid-segment."""
    target = np.concatenate([[line.s[0]], 0.5 * (line.s[1:] + line.s[:-1]), [line.s[-1]]])
    moves = _movement(line, profile, losses, live, Ep, target)
    s = target - moves
    gap = (float(line.s[0] - s[0]), float(s[-1] - line.s[-1]))
    position, segment = line.point(s)
    position[0], position[-1] = (line.x[0], line.y[0]), (line.x[-1], line.y[-1])
    ends = position.copy()
    for node, sign, slope, g in ((0, -1.0, line.slope[0, 0], gap[0]), (-1, 1.0, line.slope[-1, 1], gap[1])):
        ends[node] += sign * g * np.array([1.0, slope]) / np.hypot(1.0, slope)
    rest = np.hypot(*np.diff(ends, axis=0).T)
    segment[0], segment[-1] = 0, len(line.x) - 2
    return TendonStart(position, rest, segment, s, moves, gap)


def _movement(
    line: Duct, profile: Profile, losses: Losses, live: tuple[bool, bool], Ep: float, target: Array
) -> Array:
    """How far the tendon moves to the right between slack and anchored, at the arc lengths `target`."""
    x = np.linspace(line.x[0], line.x[-1], FINE * len(line.x) + 1)
    s, stress = profile.arc_length(x), losses.stress_anchored(x)
    stretched = np.append(0.0, np.cumsum(0.5 * (stress[1:] + stress[:-1]) * np.diff(s))) / Ep
    moved = np.interp(target, s, stretched)
    if not live[1]:
        return moved - stretched[-1]
    if not live[0]:
        return moved
    jacked = losses.stress_jacked(x)
    least = np.flatnonzero(jacked <= jacked.min() * (1.0 + 1e-9))  # without friction everywhere
    return moved - stretched[least[len(least) // 2]]
