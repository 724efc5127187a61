"""Beam nodes along a member: at supports, point loads, harping points and the control point, evenly between
them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptbatch.member import Member
from ptbatch.model.beam_theory import elastic_deflection
from ptbatch.model.loading import live, sustained

Array = NDArray[np.float64]

FINE = 120  # elements a span in the search for the control point
NEAR = 0.02  # of a span: a node that is wanted anyway serves as control point


@dataclass(frozen=True)
class Mesh:
    """x (n+1,) of the beam nodes; the control node and the sense (+1 up, -1 down) in which live load moves
    it."""

    x: Array
    control: int
    sense: float


def mesh(member: Member) -> Mesh:
    """Mesh with `elements` to each span, symmetric where the member is."""
    wanted = _wanted(member)
    place, sense = _control_point(member, wanted)
    x = _nodes(member, sorted({*wanted, place}))
    return Mesh(x, int(np.argmin(np.abs(x - place))), sense)


def _wanted(member: Member) -> list[float]:
    """Places that must have a node, ends and supports included."""
    places = list(member.support_x)
    places += [x for load in (*live(member), *sustained(member)) for x in (load.x, load.x_end)]
    if member.profile_points:
        places += [x for x, _ in member.profile_points]
    elif member.profile == "harped":
        starts = zip(member.support_x, member.span, strict=False)
        places += [x + share * span for x, span in starts for share in member.harp]
    places.sort()
    kept = [places[0]]
    for x in places:
        if x - kept[-1] > 1e-6 * member.total_length:
            kept.append(x)
    return kept


def _control_point(member: Member, wanted: list[float]) -> tuple[float, float]:
    """Where the elastic beam deflects most under the live pattern, and which way."""
    x = np.unique(np.concatenate([_even(member, FINE), wanted]))
    x = x[np.append(True, np.diff(x) > 1e-6 * member.total_length)]
    v = elastic_deflection(member, x, live(member))
    most = np.abs(v).max()
    peak = int(np.flatnonzero(np.abs(v) > most * (1.0 - 1e-9))[0])
    place = float(x[peak])
    near = min(wanted, key=lambda w: abs(w - place))
    if abs(near - place) < NEAR * min(member.span) and abs(v[np.argmin(np.abs(x - near))]) > 0.98 * most:
        place = near
    return place, float(np.sign(v[peak]))


def _even(member: Member, count: int) -> Array:
    spans = zip(member.support_x, member.support_x[1:], strict=False)
    return np.concatenate([np.linspace(a, b, count + 1) for a, b in spans])


def _nodes(member: Member, wanted: list[float]) -> Array:
    """Share each span's elements out between its wanted places, at least one to each part."""
    nodes: list[Array] = []
    for left, right in zip(member.support_x, member.support_x[1:], strict=False):
        tolerance = 1e-9 * member.total_length
        cuts = [w for w in wanted if left - tolerance <= w <= right + tolerance]
        ranks = [round((c - left) / (right - left) * member.elements) for c in cuts]
        for a, b, i, j in zip(cuts, cuts[1:], ranks, ranks[1:], strict=False):
            nodes.append(np.linspace(a, b, max(1, j - i) + 1)[:-1])
    return np.append(np.concatenate(nodes), member.total_length)
