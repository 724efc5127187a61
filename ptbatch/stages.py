"""The stages. Each says what moves, what is held and what is recorded; one's end state is the next one's
start, exactly."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.case import Case
from ptbatch.core.concrete import FREE
from ptbatch.core.failure import LIMIT, demands
from ptbatch.core.follow import Control, follow
from ptbatch.core.history import concrete_stress
from ptbatch.core.model import ANCHORED, PRESCRIBED, PULLED
from ptbatch.core.ramp import DONE, NO_BUDGET, NO_EQUILIBRIUM, NO_ROOM, ramp
from ptbatch.core.reference import Reference
from ptbatch.turns import turns

Array = NDArray[np.float64]
Pair = tuple[Array, Array]

JACKING, SETTING, ANCHORING, SUSTAINED, TIME, LIVE = range(6)
NAMES = ("jacking", "wedge set", "anchoring", "sustained load", "long-term losses", "live load")
LEFT, RIGHT = 0, 1
LET_GO = 1.0 - 1e-6  # of the friction force: nodes about to turn round stick first, rather than slide on
NO_MEAN, NO_PRESTRESS = 4, 5  # beside how a stage can end: no jacking stress for `fpe`; time takes it all
WHY = {
    NO_EQUILIBRIUM: "no equilibrium was found",
    NO_BUDGET: "the iterations allowed did not lead",
    NO_ROOM: "the steps allowed did not lead",
    NO_MEAN: "no stress was found that leaves fpe,",
    NO_PRESTRESS: "they exceed the stress of the tendon",
}


class NoEquilibriumError(Exception):
    """A stage found no equilibrium beyond the fraction that it reached."""

    def __init__(self, stage: int, ended: int, reached: float) -> None:
        beyond = "" if stage == TIME else f" beyond {reached:.1%} of the stage"
        super().__init__(f"{NAMES[stage]}: {WHY[ended]}{beyond}")
        self.stage = stage


@dataclass(frozen=True)
class Rig:
    """A member under test: its arrays, the kernels' handle on the same, its live ends and whether it is
    grouted."""

    case: Case
    handle: Any
    live: tuple[bool, bool]

    @classmethod
    def of(cls, case: Case, live: tuple[bool, bool]) -> "Rig":
        """Set a case up for its stages."""
        return cls(case, Reference(case), live)

    @property
    def ends(self) -> tuple[int, ...]:
        """The live ends."""
        return tuple(side for side in (LEFT, RIGHT) if self.live[side])

    @property
    def failed(self) -> bool:
        """Whether a material has reached its limit strain in the committed state."""
        return bool(demands(self.handle, self.case.state.u)[0][LIMIT] >= 1.0)

    @property
    def mean_stress(self) -> float:
        """Mean tendon stress over its length in the committed state [MPa]."""
        model = self.case.model
        return float(np.average(self.case.work.T, weights=model.rest_length) / model.strand.Aps)

    def concrete_stress(self) -> Pair:
        """Stress and modulus of the concrete in all layers and sections (m, 2n) in the committed state
        [MPa]."""
        stress, modulus = np.empty((2, *self.own_strain.shape))
        concrete_stress(self.handle, stress, modulus)
        return stress, modulus

    @property
    def own_strain(self) -> Array:
        """What the concrete has crept and shrunk by in all layers and sections (m, 2n), tension positive."""
        return self.case.state.concrete[:, FREE]

    def gap(self, side: int) -> float:
        """How far the tendon's end stands out of its anchor [mm]."""
        return float(self.case.state.u[0 if side == LEFT else -2])

    def drive(self, side: int, mode: int) -> None:
        """Drive an end in another way from now on; friction at its anchor keeps its force, slip is measured
        anew."""
        _, state, ends, work, *_ = self.case
        last = len(work.T) - 1
        slip = self.gap(side)
        if mode == ANCHORED:
            slip = -0.5 * work.s[1] if side == LEFT else 0.5 * work.s[-2]
            ends.born[side], ends.value[side] = self.gap(side), work.T[0 if side == LEFT else last]
        ends.mode[side] = mode
        state.s[0 if side == LEFT else -1] = slip


def move(rig: Rig, stage: int, loads: Pair, values: Pair, bonded: bool = False, first: float = 1.0) -> None:
    """Move loads and end values together from their first to their second, in steps if it must be."""
    ended, done = ramp(rig.handle, stage, *loads, *values, bonded, first)
    if ended != DONE:
        raise NoEquilibriumError(stage, ended, done)


def jack(rig: Rig, force: float, self_weight: Array) -> None:
    """Jacking: the live ends are pulled to `force` from slack, two of them together; the beam lifts its own
    weight as it is stressed."""
    for side in (LEFT, RIGHT):
        rig.case.ends.mode[side] = PULLED if rig.live[side] else ANCHORED
    loads = np.zeros_like(self_weight), self_weight
    move(rig, JACKING, loads, (np.zeros(2), np.where(rig.live, force, 0.0)))


def set_wedges(rig: Rig, wedge_set: float, load: Array) -> None:
    """Wedge set: the live ends move back by the set; friction turns round over the influence length."""
    rig.case.state.rub[:] *= LET_GO
    for side in rig.ends:
        rig.drive(side, PRESCRIBED)
        rig.case.ends.value[side] = rig.gap(side)
    start = rig.case.ends.value.copy()
    move(rig, SETTING, (load, load), (start, start - np.where(rig.live, wedge_set, 0.0)))


def anchor(rig: Rig, load: Array) -> None:
    """Anchoring: prescribed motion and its reaction are swapped for the anchorage, born where the end is with
    the force it has."""
    for side in rig.ends:
        rig.drive(side, ANCHORED)
    held = rig.case.ends.value.copy()
    move(rig, ANCHORING, (load, load), (held, held))


def sustain(rig: Rig, loads: Pair, bonded: bool) -> None:
    """Service, first part: the sustained load comes on."""
    held = rig.case.ends.value.copy()
    move(rig, SUSTAINED, loads, (held, held), bonded)


def load_to_failure(rig: Rig, fixed: Array, pattern: Array, control: Control, bonded: bool) -> int:
    """Service, last part: the live pattern, driven by the control point's deflection to its limit or to the
    rupture of the tendon; how it ended, a key of `WHY` or DONE."""
    rig.case.state.rub[:] *= LET_GO
    with turns.left():
        ended = int(follow(rig.handle, LIVE, fixed, pattern, control, bonded))
    spent = rig.case.work.spent[0] >= rig.case.tolerance.budget
    return NO_BUDGET if ended == NO_EQUILIBRIUM and spent else ended
