"""The duct and the tendon at rest: heights, directions and arc length at the beam nodes, where the tendon
nodes start."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.contact import shape
from ptbatch.geometry.profile import GAUSS_POINTS, GAUSS_WEIGHTS, Profile
from ptbatch.losses import Losses

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Duct:
    """Duct above the reference axis: y, s (n+1,), slope (n, 2) at the ends of each segment, x (n+1,)."""

    x: Array
    y: Array
    slope: Array
    s: Array
    smooth: bool

    def point(self, s: Array) -> tuple[Array, NDArray[np.int64]]:
        """(x, y) of the duct as the kernels see it, at arc lengths s, and the segments they lie in."""
        m = np.clip(np.searchsorted(self.s, s, side="right") - 1, 0, len(self.x) - 2)
        h = np.diff(self.x)[m]
        weights = shape.py_func(  # type: ignore[attr-defined]
            (s - self.s[m]) / np.diff(self.s)[m], self.smooth
        )[0]
        along = self.x[m], h, self.x[m + 1], h
        up = self.y[m], h * self.slope[m, 0], self.y[m + 1], h * self.slope[m, 1]
        x, y = (sum(w * p for w, p in zip(weights, points, strict=True)) for points in (along, up))
        return np.column_stack([x, y]), m


def duct(profile: Profile, x: Array, centroid: float, smooth: bool) -> Duct:
    """Duct through the profile at the beam nodes x; depths are measured from the top, heights from the
    centroid."""
    slope = -np.column_stack([profile.slope(x[:-1], "right"), profile.slope(x[1:], "left")])
    return Duct(x, centroid - profile.depth(x), slope, profile.arc_length(x), smooth)


def turning_tables(profile: Profile, x: Array) -> tuple[Array, Array, Array]:
    """Arc-length stations (t,) at nodes and breaks, and there the first integrals over arc length of the
    absolute angle and of the signed direction, each as (t, 3): value, slope to the right, slope to the left.
    """
    at = np.unique(np.concatenate([x, profile.breaks]))
    at = at[np.append(True, np.diff(at) > 1e-9 * at[-1])]
    width = np.diff(at)[:, None]
    inside = at[:-1, None] + width * GAUSS_POINTS
    ds = width * np.hypot(1.0, profile.slope(inside)) * GAUSS_WEIGHTS
    right, left = np.arctan(profile.slope(at, "right")), np.arctan(profile.slope(at, "left"))
    kink = np.abs(right - left)
    angle = profile.angle(at)

    def table(integrand: Array, after: Array, before: Array) -> Array:
        return np.column_stack([np.append(0.0, np.cumsum((integrand * ds).sum(axis=1))), after, before])

    turned = table(profile.angle(inside), angle + 0.5 * kink, angle - 0.5 * kink)
    direction = table(np.arctan(profile.slope(inside)), right, left)
    return profile.arc_length(at), turned, direction


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
    x = np.linspace(line.x[0], line.x[-1], 40 * len(line.x) + 1)
    s, stress = profile.arc_length(x), losses.stress_anchored(x)
    stretched = np.append(0.0, np.cumsum(0.5 * (stress[1:] + stress[:-1]) * np.diff(s))) / Ep
    moved = np.interp(target, s, stretched)
    if not live[1]:
        return moved - stretched[-1]
    if not live[0]:
        return moved
    still = int(np.argmin(losses.stress_jacked(x)))
    return moved - stretched[still]
