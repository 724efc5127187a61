"""Tendon profiles of members: the shape that is asked for, and the one with its wobble on it.

x runs to the right from the left end and depth is measured downwards from the top fibre, both in mm.
"""

from collections.abc import Sequence
from functools import lru_cache
from itertools import accumulate
from types import SimpleNamespace
from typing import Any

import numpy as np

from ptbatch.geometry.curve import Profile
from ptbatch.geometry.wobble import wavy_profile

DRAWN = ("span", "profile", "dp", "profile_points", "inflection", "harp")  # what an ideal profile depends on
KEPT = 256  # members that eight workers have read ahead of their analysis


def tendon_profile(member: Any) -> Profile:
    """Profile that a member's tendon has in the analysis: the ideal one or, with wobble = sine, that with
    waves on it which turn by K / mu per length.

    member: as for `ideal_profile`, and wobble, mu [1/rad], K [1/mm] and elements. Raises ValueError where
    `ideal_profile` does, and if no waves can turn so much.
    """
    ideal = ideal_profile(member)
    if member.wobble != "sine" or member.K == 0.0:
        return ideal
    if member.mu == 0.0:
        raise ValueError("wobble: without curvature friction mu no waves make the friction of K")
    return wavy_profile(ideal, member.span, member.elements, member.K / member.mu)


def ideal_profile(member: Any) -> Profile:
    """Profile as it is drawn, without wobble: the one that eq. (38) is applied to.

    member: anything with what its shape asks for of span, profile, dp, harp, inflection and profile_points as
    in the workbook, in mm; points, where there are any, take the place of the named shape. Between two breaks
    the tendon only rises or only falls, so that `depth(breaks)` holds its extreme depths. The last ones are
    kept: a row is examined with its profile, and soon afterwards analysed.
    Raises ValueError if the shape is unknown, the number of depths does not fit the spans, or the points do
    not run from one end of the member to the other.
    """
    return _ideal(tuple(_frozen(getattr(member, name, None)) for name in DRAWN))


def _frozen(value: Any) -> Any:
    """Lists as tuples, which can be looked up."""
    return tuple(map(_frozen, value)) if isinstance(value, list | tuple) else value


@lru_cache(KEPT)
def _ideal(drawn: tuple[Any, ...]) -> Profile:
    member = SimpleNamespace(**dict(zip(DRAWN, drawn, strict=True)))
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
