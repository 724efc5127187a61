"""Wobble as waves on the profile: friction per length K turned into the angle K / mu that has the same
friction.

The paper superposes a sine of the right total angle and prints neither its period nor its phase. Here:

- Waves stand on the stretches between breaks and supports. The tendon keeps its depth and its direction at
  both ends of a stretch, so that anchors, harping points and supports stay what they are.
- On a stretch they are a sine about the ideal profile, with a mean of zero. The first half wave leads to the
  first crest and the last one back from the last; rising less far, they are shorter, so that all half waves
  have the same curvature.
- Every half wave then turns by K / mu times its length more than the profile does: friction follows K x all
  along, not in total alone. The curvature is the root of this, one for each stretch.
- A half wave is about two beam elements long, the least that tendon nodes feel: the height of the waves goes
  with the square of their length. The crests are odd in number, so that a mirrored member has mirrored waves.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from ptbatch.geometry.curve import Array, Profile
from ptbatch.roots import root

HALF_WAVE = 2.0  # beam elements
FEWEST = 2.0  # elements on a stretch, for its two half waves
STEEPEST = 0.5  # slope of a wave: steeper is no wobble
COINCIDE = 1e-9  # of a stretch: nearer stations are one


@dataclass(frozen=True, eq=False)
class WavyProfile(Profile):
    """A profile with a cosine on each piece.

    waves: shape (n, 3); to the depth comes w0 cos(w1 t + w2) on each piece, t from its left end.
    """

    waves: Array

    def _depth(self, piece: NDArray[np.intp], t: Array) -> Array:
        size, number, phase = np.moveaxis(self.waves[piece], -1, 0)
        return super()._depth(piece, t) + size * np.cos(number * t + phase)

    def _slope(self, piece: NDArray[np.intp], t: Array) -> Array:
        size, number, phase = np.moveaxis(self.waves[piece], -1, 0)
        return super()._slope(piece, t) - size * number * np.sin(number * t + phase)


@dataclass(frozen=True, eq=False)
class Stretch:
    """Part of an ideal profile, one parabola, from x = start to stop [mm]; element: length of a beam element
    there."""

    ideal: Profile
    start: float
    stop: float
    element: float

    @property
    def length(self) -> float:
        """Length along x [mm]."""
        return self.stop - self.start

    @cached_property
    def half_waves(self) -> Array:
        """Lengths of its half waves [mm], one more than its crests.

        Those between crests are r times as long as the first and the last, and rise r^2 times as far. A mean
        of zero asks for (crests - 1) r (r^2 - 2) = 2: the golden ratio for three crests, towards the root of
        2 for many. A single crest has a mean.
        """
        wanted = self.length / (HALF_WAVE * self.element)
        crests = 1 + 2 * max(0, round(0.5 * (wanted - np.sqrt(2.0))))
        widths = np.ones(crests + 1)
        if crests > 1:
            widths[1:-1] = np.sqrt(8.0 / 3.0) * np.cos(np.arccos(np.sqrt(27.0 / 8.0) / (crests - 1)) / 3.0)
        return self.length * widths / widths.sum()

    @cached_property
    def bend(self) -> float:
        """Second derivative of the ideal depth [1/mm]."""
        return 2.0 * float(self.ideal.parabolas(self.start)[2])

    def with_waves(self, curvature: float) -> WavyProfile:
        """The stretch with waves of this largest curvature [1/mm]; pieces end at crests and inflections."""
        number = np.pi / self.half_waves
        size = curvature * np.resize([-1.0, 1.0], len(number)) / number**2
        middle = np.cumsum(-2.0 * size) + size
        turning = np.arccos(np.clip(self.bend / (size * number**2), -1.0, 1.0))
        phase = np.column_stack([0.0 * turning, turning]).ravel()
        size, number, middle = (np.repeat(values, 2) for values in (size, number, middle))
        feet = self.start + np.append(0.0, np.cumsum(self.half_waves[:-1]))
        x = np.append(np.repeat(feet, 2) + phase / number, self.stop)
        kept = np.diff(x) > COINCIDE * self.length
        parabolas = self.ideal.parabolas(x[:-1]) + middle[:, None] * [1.0, 0.0, 0.0]
        waves = np.column_stack([size, number, phase])
        return WavyProfile(np.append(x[:-1][kept], self.stop), parabolas[kept], waves[kept])

    def turning(self, wobble: float) -> WavyProfile:
        """The stretch with waves that turn it by `wobble` [rad/mm] times its arc length more than it does."""
        inside = np.nextafter([self.start, self.stop], [self.stop, self.start])  # no kink at an end
        turned, length = np.ptp(self.ideal.angle(inside)), np.ptp(self.ideal.arc_length(inside))

        def missing(curvature: float) -> float:
            return self.with_waves(curvature).total_angle - float(turned + wobble * length)

        # Waves weaker than the bend turn nothing; by themselves they turn 2 / pi of their largest curvature.
        least = max(abs(self.bend), wobble)
        steepest = abs(self.bend) + STEEPEST * np.pi / self.half_waves.max()
        if least >= steepest or missing(steepest) < 0.0:
            raise ValueError(f"wobble: it takes waves steeper than {STEEPEST:g} at x = {self.start:g} mm")
        return self.with_waves(root(missing, least, steepest, xtol=1e-18, rtol=1e-13))


def stretches(ideal: Profile, span: Sequence[float], elements: int) -> list[Stretch]:
    """Stretches of an ideal profile between its breaks and the supports; elements: those of a span."""
    supports = np.array([0.0, *accumulate(span)])
    ends = np.union1d(ideal.breaks, supports)
    ends = ends[np.append(True, np.diff(ends) > COINCIDE * ends[-1])]
    element = np.array(span)[np.searchsorted(supports, 0.5 * (ends[1:] + ends[:-1])) - 1] / elements
    return [Stretch(ideal, *values) for values in zip(ends[:-1], ends[1:], element, strict=True)]


def wavy_profile(ideal: Profile, span: Sequence[float], elements: int, wobble: float) -> WavyProfile:
    """An ideal profile with waves that turn it by `wobble` [rad/mm] times its arc length more, all along.

    span [mm] and elements, those of a span, give the waves their length. Raises ValueError if no waves can
    turn so much.
    """
    parts = [stretch.turning(wobble) for stretch in stretches(ideal, span, elements)]
    return WavyProfile(
        np.append(np.concatenate([part.breaks[:-1] for part in parts]), ideal.breaks[-1]),
        np.concatenate([part.coefficients for part in parts]),
        np.concatenate([part.waves for part in parts]),
    )
