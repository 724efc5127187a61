"""Stresses of the uncracked concrete at the extreme fibres along a member."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.design.subject import Subject

Array = NDArray[np.float64]


class Fibres(NamedTuple):
    """Stresses [MPa] at stations x [mm], tension positive, and the external moments [N mm] that make them."""

    x: Array
    top: Array
    bottom: Array
    moments: Array

    @property
    def compression(self) -> tuple[float, float]:
        """The largest compression, and where."""
        least = np.minimum(self.top, self.bottom)
        return float(-least.min()), float(self.x[int(least.argmin())])

    @property
    def tension(self) -> tuple[float, float]:
        """The largest tension (below zero where there is none), and where."""
        most = np.maximum(self.top, self.bottom)
        return float(most.max()), float(self.x[int(most.argmax())])

    def within(self, inside: NDArray[np.bool_]) -> "Fibres":
        """A part of the stations."""
        return Fibres(*(values[inside] for values in self))


def fibres(subject: Subject, moments: Array, time_loss: float, share: float = 1.0) -> Fibres:
    """P/A + M/S with external moments (stations,) [N mm], secondary ones included, and the prestress after a
    loss [MPa], or a share of it."""
    x, section = subject.moments.x, subject.section
    P = share * (subject.anchored - time_loss) * subject.member.intact_area
    e = subject.eccentricity
    inner, mean = moments - P * e, -P / section.area
    up, down = section.centroid, section.h - section.centroid
    return Fibres(x, mean - inner * up / section.inertia, mean + inner * down / section.inertia, moments)


def enveloped(subject: Subject, others: Array, live: float, time_loss: float, share: float = 1.0) -> Fibres:
    """The same with a part of the live load, on the spans where it makes the largest moments and where it
    makes the least: one after the other."""
    moments = subject.moments
    cases = [
        fibres(subject, others + live * part, time_loss, share)
        for part in (moments.live_most, moments.live_least)
    ]
    return Fibres(*(np.concatenate(values) for values in zip(*cases, strict=True)))
