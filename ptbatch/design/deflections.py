"""Deflections in service: by live load as the analysis has them, elastic ones for creep to enlarge."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.design.moments import by_prestress, of_beam
from ptbatch.design.subject import Subject

Array = NDArray[np.float64]


class Deflections(NamedTuple):
    """Elastic deflections (stations,) in mm, down positive, of the uncracked member: dead load, live load at
    its service value, prestress after all losses."""

    x: Array
    dead: Array
    live: Array
    prestress: Array


def elastic(subject: Subject, modulus: float) -> Deflections:
    """Beam theory on the gross section; modulus of the concrete in MPa."""
    member, moments = subject.member, subject.moments
    stiffness = modulus * subject.section.inertia
    dead, live = (of_beam(member, moments.x, subject.loads[name]) / stiffness for name in ("dead", "live"))
    return Deflections(moments.x, dead, live, by_prestress(member, moments.x, moments.primary) / stiffness)


def live_by_analysis(subject: Subject) -> float | None:
    """Deflection [mm] that the live load at its service value adds at the control point, cracks included;
    None where the analysis did not come so far, or no service value was given."""
    curve, peak = subject.response.curve, subject.response.event("peak")
    if curve is None or peak is None or not subject.has_live:
        return None
    loaded = np.flatnonzero(curve.factor[: int(peak.step) + 1] >= 1.0)
    if not loaded.size or not np.any(curve.factor == 0.0):
        return None
    i = int(loaded[0])
    start = int(np.flatnonzero(curve.factor == 0.0)[-1])
    before = curve.deflection[start]
    if i == start:
        return None
    return float(np.interp(1.0, curve.factor[i - 1 : i + 1], curve.deflection[i - 1 : i + 1]) - before)


def worst(subject: Subject, x: Array, deflection: Array) -> tuple[float, float, float]:
    """Where a deflection is largest for its span: its size [mm], the place, and the span [mm]."""
    spans = np.array([subject.span_at(place) for place in x])
    i = int((np.abs(deflection) / spans).argmax())
    return float(abs(deflection[i])), float(x[i]), float(spans[i])
