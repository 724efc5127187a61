"""The four stages. Each says what moves, what is held and what is recorded; one's end state is the next one's start, exactly."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.failure import utilisation
from ptbatch.core.model import ANCHORED, PRESCRIBED, PULLED
from ptbatch.core.newton import CONVERGED
from ptbatch.core.step import Case, accept, find_equilibrium, open_case

Array = NDArray[np.float64]

JACKING, SETTING, ANCHORING, SUSTAINED, LIVE = range(5)
NAMES = ("jacking", "wedge set", "anchoring", "sustained load", "live load")
LEFT, RIGHT = 0, 1
SMALLEST = 1e-4  # of a stage: below this a step is given up
SHORT = 0.98  # of the expected movement of a second jack: where its force is looked at for the first time


class NoEquilibrium(Exception):
    """A stage found no equilibrium beyond the fraction that it reached."""

    def __init__(self, stage: int, reached: float) -> None:
        super().__init__(f"{NAMES[stage]}: no equilibrium beyond {reached:.1%} of the stage")
        self.stage = stage


@dataclass(frozen=True)
class Rig:
    """A member under test: its arrays, the kernels' handle on the same, its live ends and whether it is grouted."""

    case: Case
    handle: Any
    live: tuple[bool, bool]

    @classmethod
    def of(cls, case: Case, live: tuple[bool, bool]) -> "Rig":
        """Set a case up for its stages."""
        return cls(case, open_case(*case), live)

    @property
    def ends(self) -> tuple[int, ...]:
        """The live ends."""
        return tuple(side for side in (LEFT, RIGHT) if self.live[side])

    @property
    def full(self) -> bool:
        """Whether there is room to record another step."""
        return bool(self.case.history.count[0] >= self.case.history.stage.size)

    def gap(self, side: int) -> float:
        """How far the tendon's end stands out of its anchor [mm]."""
        return float(self.case.state.u[0 if side == LEFT else -2])

    def anchor_force(self, side: int) -> float:
        """Force at an anchor in the last recorded step [N]."""
        return float(self.case.history.anchor[self.case.history.count[0] - 1, side])

    def drive(self, side: int, mode: int) -> None:
        """Drive an end in another way from now on; friction at its anchor keeps its force, slip is measured anew."""
        _, state, ends, work, *_ = self.case
        last = len(work.T) - 1
        slip = self.gap(side)
        if mode == ANCHORED:
            slip = -0.5 * work.s[1] if side == LEFT else 0.5 * work.s[-2]
            ends.born[side], ends.value[side] = self.gap(side), work.T[0 if side == LEFT else last]
        ends.mode[side] = mode
        state.s[0 if side == LEFT else -1] = slip


def ramp(rig: Rig, stage: int, loads: tuple[Array, Array], values: tuple[Array, Array], bonded: bool, first: float) -> None:
    """Move loads and end values together from their first to their second in steps that adapt to the iterations they need."""
    none = np.zeros_like(loads[0])
    done, step = 0.0, first
    while done < 1.0:
        share = 1.0 if done + 1.1 * step > 1.0 else done + step
        rig.case.ends.value[:] = values[0] + share * (values[1] - values[0])
        load = loads[0] + share * (loads[1] - loads[0])
        status, _, iterations, residual = find_equilibrium(rig.handle, load, none, -1, 0.0, 0.0, bonded)
        if status == CONVERGED:
            accept(rig.handle, stage, 0.0, iterations, residual)
            done = share
            step *= 2.0 if iterations <= 10 else 1.0
        else:
            step = 0.25 * (share - done)
            if step < SMALLEST or rig.full:
                raise NoEquilibrium(stage, done)


def jack(rig: Rig, force: float, movement: float, self_weight: Array) -> None:
    """Jacking: the live ends are pulled to `force` from slack; the beam lifts its own weight as it is stressed.

    With two live ends the left one is pulled, and the right one is moved outward until its force is the same: a little less than its expected
    movement first, so that the force is approached from below, then by what is missing.
    """
    for side in (LEFT, RIGHT):
        rig.case.ends.mode[side] = PULLED if rig.live[side] else ANCHORED
    start = np.zeros(2)
    pulled = np.where(rig.live, force, 0.0)
    nothing = np.zeros_like(self_weight)
    if not all(rig.live):
        ramp(rig, JACKING, (nothing, self_weight), (start, pulled), False, 0.02)
        return
    rig.case.ends.mode[RIGHT] = PRESCRIBED
    start[RIGHT] = rig.gap(RIGHT)
    pulled[RIGHT] = start[RIGHT] + SHORT * movement
    ramp(rig, JACKING, (nothing, self_weight), (start, pulled), False, 0.02)
    slope = rig.anchor_force(RIGHT) / (pulled[RIGHT] - start[RIGHT])
    for _ in range(20):
        missing = force - rig.anchor_force(RIGHT)
        if abs(missing) <= 1e-7 * force:
            return
        before, start = force - missing, pulled.copy()
        pulled[RIGHT] += missing / slope
        ramp(rig, JACKING, (self_weight, self_weight), (start, pulled), False, 1.0)
        slope = (rig.anchor_force(RIGHT) - before) / (pulled[RIGHT] - start[RIGHT])
    raise NoEquilibrium(JACKING, 1.0)


def set_wedges(rig: Rig, wedge_set: float, load: Array) -> None:
    """Wedge set: the live ends move back by the set; friction turns round over the influence length."""
    for side in rig.ends:
        rig.drive(side, PRESCRIBED)
        rig.case.ends.value[side] = rig.gap(side)
    start = rig.case.ends.value.copy()
    ramp(rig, SETTING, (load, load), (start, start - np.where(rig.live, wedge_set, 0.0)), False, 0.1)


def anchor(rig: Rig, load: Array) -> None:
    """Anchoring: prescribed motion and its reaction are swapped for the anchorage, born where the end is with the force it has."""
    for side in rig.ends:
        rig.drive(side, ANCHORED)
    held = rig.case.ends.value.copy()
    ramp(rig, ANCHORING, (load, load), (held, held), False, 1.0)


def sustain(rig: Rig, loads: tuple[Array, Array], bonded: bool) -> None:
    """Service, first part: the sustained load comes on."""
    held = rig.case.ends.value.copy()
    ramp(rig, SUSTAINED, loads, (held, held), bonded, 0.25)


@dataclass(frozen=True)
class Control:
    """Displacement control: the degree of freedom, its value in the anchored state, the sense it is driven in, how far, and in what steps [mm]."""

    dof: int
    start: float
    sense: float
    limit: float
    first: float
    largest: float


def load_to_failure(rig: Rig, fixed: Array, pattern: Array, control: Control, bonded: bool) -> bool:
    """Service, second part: the live pattern, driven by the control point's deflection to its limit or to the rupture of the tendon.

    False where no equilibrium was found beyond the last recorded step. Steps land on the first limit strain of a material.
    """
    model, state, _, work, *_ = rig.case
    factor, step = 0.0, control.first
    used = max(utilisation(rig.handle, state.u))
    failed = used >= 1.0
    while not rig.full:
        left = control.limit - control.sense * (state.u[control.dof] - control.start)
        if left <= 1e-9 * control.limit:
            return True
        step = min(step, left)
        target = state.u[control.dof] + control.sense * step
        status, reached, iterations, residual = find_equilibrium(
            rig.handle, fixed, pattern, control.dof, target, factor, bonded
        )
        if status != CONVERGED:
            step *= 0.25
            if step < 1e-3 * control.first:
                return False
            continue
        demand = utilisation(rig.handle, work.trial)
        if not failed and max(demand) > 1.005 and step > 1e-3 * control.first:
            step *= min(max((1.001 - used) / (max(demand) - used), 0.1), 0.95)
            continue
        accept(rig.handle, LIVE, reached, iterations, residual)
        factor, used = reached, max(demand)
        failed = failed or used >= 1.0
        if demand[2] >= 1.0:
            return True
        step = min(control.largest, step * (1.5 if iterations <= 8 else 0.7 if iterations > 16 else 1.0))
    return False
