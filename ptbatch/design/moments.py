"""Bending moments of the uncracked elastic member, sagging positive: of loads, and of the reactions that the
prestress causes (secondary moments)."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ptbatch.member import Load, Member
from ptbatch.model.beam_theory import displacements, nodal_loads

Array = NDArray[np.float64]

FINE = 120  # elements a span
XI = np.array([0.5 - 0.5 / np.sqrt(3.0), 0.5 + 0.5 / np.sqrt(3.0)])  # Gauss points


def stations(member: Member, loads: Iterable[Load], others: Iterable[float]) -> Array:
    """Places along the member [mm]: evenly between the supports, where a load begins or ends, and others."""
    spans = zip(member.support_x, member.support_x[1:], strict=False)
    even = np.concatenate([np.linspace(a, b, FINE + 1) for a, b in spans])
    places = np.unique([*even, *others, *(place for load in loads for place in (load.x, load.x_end))])
    apart = np.append(True, np.diff(places) > 1e-6 * member.total_length)
    return places[apart & (places <= member.total_length)]


def of_loads(member: Member, x: Array, loads: Iterable[Load]) -> Array:
    """Moments (stations,) in N mm of loads, whose ends are stations."""
    loads = list(loads)
    w, h = _uniform(x, loads), np.diff(x)
    left, right = _curvatures(x, displacements(member, x, nodal_loads(x, loads)))
    at_left, at_right = left - w * h**2 / 12.0, right - w * h**2 / 12.0  # as of a beam held at both ends
    return np.append(at_left, at_right[-1])


def shears(x: Array, moments: Array, loads: Iterable[Load]) -> Array:
    """Shear forces (stations, 2) in N just left and just right of the stations, from moments that run on over
    them, and the loads that make them; dM/dx positive."""
    w, h = _uniform(x, loads), np.diff(x)
    chord = np.diff(moments) / h
    found = np.zeros((len(x), 2))
    found[:-1, 1], found[1:, 0] = chord + 0.5 * w * h, chord - 0.5 * w * h
    return found


def _uniform(x: Array, loads: Iterable[Load]) -> Array:
    """Line load on each element [N/mm]."""
    middle = 0.5 * (x[1:] + x[:-1])
    on = [
        ((middle > load.x) & (middle < load.x_end)) * load.value for load in loads if load.type == "uniform"
    ]
    return np.sum([np.zeros_like(middle), *on], axis=0)


def reactions(member: Member, x: Array, moments: Array, loads: Iterable[Load]) -> Array:
    """Reactions (supports,) in N, upward positive."""
    loads = list(loads)
    step = np.diff(shears(x, moments, loads))[:, 0]
    at = [int(np.abs(x - place).argmin()) for place in member.support_x]
    on = [sum(load.value for load in loads if load.type == "point" and abs(load.x - x[i]) < 1e-6) for i in at]
    return np.asarray([step[i] + own for i, own in zip(at, on, strict=True)])


def secondary(member: Member, x: Array, primary: Array) -> Array:
    """Moments (stations,) in N mm of the reactions to the prestress, from the primary ones, - P e: those that
    let the member fit its supports again. They run straight from support to support."""
    left, right = _curvatures(x, displacements(member, x, _forces(x, primary)))
    mean = 0.5 * (left + right) - 0.5 * (primary[1:] + primary[:-1])
    middle = 0.5 * (x[1:] + x[:-1])
    return np.concatenate([_straight(x, middle, mean, *ends) for ends in _spans(member, x)])


def of_beam(member: Member, x: Array, loads: Iterable[Load]) -> Array:
    """Deflections (stations,) of loads, down positive, times the bending stiffness [N mm3]."""
    return -displacements(member, x, nodal_loads(x, loads))[:, 0]


def by_prestress(member: Member, x: Array, primary: Array) -> Array:
    """The same of the prestress, from its primary moments."""
    return -displacements(member, x, _forces(x, primary))[:, 0]


def _forces(x: Array, primary: Array) -> Array:
    """Nodal forces and moments (stations, 2) that bend the member as the primary moments would if it were
    free."""
    h = np.diff(x)[:, None]
    m = primary[:-1, None] * (1.0 - XI) + primary[1:, None] * XI
    shapes = [-6.0 + 12.0 * XI, h * (-4.0 + 6.0 * XI), 6.0 - 12.0 * XI, h * (-2.0 + 6.0 * XI)]
    parts = [np.sum(0.5 * h * m * shape / h**2, axis=1) for shape in shapes]
    forces = np.zeros((len(x), 2))
    for node, column, part in ((0, 0, 0), (0, 1, 1), (1, 0, 2), (1, 1, 3)):
        forces[node : len(x) - 1 + node, column] += parts[part]
    return forces


def _spans(member: Member, x: Array) -> list[tuple[int, int]]:
    """First station of each span, and the first one beyond it; the last span has its last station as well."""
    at = [int(np.abs(x - place).argmin()) for place in member.support_x]
    return [(a, b + (b == len(x) - 1)) for a, b in zip(at, at[1:], strict=False)]


def _straight(x: Array, middle: Array, mean: Array, first: int, beyond: int) -> Array:
    """A line through the values in the middle of the elements of a span, at its stations."""
    elements = slice(first, min(beyond, len(middle)))
    slope, level = np.polyfit(middle[elements], mean[elements], 1)
    return np.asarray(level + slope * x[first:beyond])


def _curvatures(x: Array, d: Array) -> tuple[Array, Array]:
    """v'' at the two ends of each element."""
    h, (v, turn) = np.diff(x), d.T
    chord = (v[1:] - v[:-1]) / h
    return (
        (6.0 * chord - 4.0 * turn[:-1] - 2.0 * turn[1:]) / h,
        (-6.0 * chord + 2.0 * turn[:-1] + 4.0 * turn[1:]) / h,
    )
