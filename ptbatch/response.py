"""What an analysis returns: the curve, the tendon at the stages, the events, and how it ended."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.design.longterm import TimeLoss
from ptbatch.losses import Losses
from ptbatch.member import Member

Array = NDArray[np.float64]

JACKED, SET, ANCHORED, SERVICE, PEAK, END = STAGES = "jacked", "set", "anchored", "service", "peak", "end"


@dataclass(frozen=True)
class TendonState:
    """The tendon at one stage. x, stress and slip (elements,) at the middle of each tendon element, slip
    positive to the right since the tendon was slack; anchor_stress and end_slip (2,) at the left and right
    anchor; length (elements,) for means over the tendon.
    """

    x: Array
    stress: Array
    slip: Array
    anchor_stress: tuple[float, float]
    end_slip: tuple[float, float]
    length: Array

    @property
    def mean(self) -> float:
        """Mean stress over the length [MPa]."""
        return float(np.average(self.stress, weights=self.length))

    @property
    def least(self) -> float:
        """Smallest stress, anchors included [MPa]."""
        return float(min(self.stress.min(), *self.anchor_stress))

    @property
    def most(self) -> float:
        """Largest stress, anchors included [MPa]."""
        return float(max(self.stress.max(), *self.anchor_stress))


@dataclass(frozen=True)
class Event:
    """Something that happened under live load; step is a row of the curve, with a fraction where it fell
    between two."""

    name: str
    step: float
    load: float
    deflection: float
    place: float


class Crack(NamedTuple):
    """A cracked stretch of the section at x: its upper and lower depth below the top fibre [mm]."""

    x: float
    top: float
    bottom: float


@dataclass(frozen=True)
class Curve:
    """Service stage, one row a recorded step from the anchored state on (steps,).

    load in N is the total live load on the member, deflection in mm at the control point in the sense of the
    live load, from the anchored state.
    """

    factor: Array
    load: Array
    deflection: Array
    moment_max: Array
    stress_min: Array
    stress_mean: Array
    stress_max: Array

    def at(self, step: float, column: Array) -> float:
        """Value of a column at a row, with a fraction where that falls between two."""
        return float(np.interp(step, np.arange(len(column)), column))


@dataclass(frozen=True)
class Response:
    """Result of one member. Stages that were not reached are missing from `tendon` and `cracks` (which has
    the anchored state, the peak and the end), and so is an end that is the peak itself; `curve` is None
    before the service stage.

    status: ok, warning or not converged. elongations in mm, before the set at each live end, from the left;
    elongation_before and elongation_after the sums over these ends;
    camber after anchoring and camber_service under the sustained load, when time has taken its part, in mm,
    up positive. time_loss: what creep, shrinkage and relaxation take before the live load, None where nothing
    is known of them (tendon then has no service state).
    """

    member: Member
    status: str
    message: str
    fpj: float
    losses: Losses
    tendon: dict[str, TendonState] = field(default_factory=dict)
    elongations: tuple[float, ...] = ()
    elongation_before: float | None = None
    elongation_after: float | None = None
    set_length: float | None = None
    camber: float | None = None
    camber_service: float | None = None
    cracks: dict[str, tuple[Crack, ...]] = field(default_factory=dict)
    curve: Curve | None = None
    events: tuple[Event, ...] = ()
    failure: str = ""
    residual_max: float = 0.0
    newton_iterations: int = 0
    has_service_value: bool = True
    time_loss: TimeLoss | None = None

    def event(self, name: str) -> Event | None:
        """The first event of that name."""
        return next((event for event in self.events if event.name == name), None)
