"""The four stages. Each says what moves, what is held and what is recorded; one's end state is the next one's
start, exactly."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.failure import utilisation
from ptbatch.core.model import ANCHORED, PRESCRIBED, PULLED
from ptbatch.core.newton import CONVERGED
from ptbatch.core.step import Case, accept, find_equilibrium, open_case

Array = NDArray[np.float64]
Pair = tuple[Array, Array]  # what something is moved from and to

JACKING, SETTING, ANCHORING, SUSTAINED, LIVE = range(5)
NAMES = ("jacking", "wedge set", "anchoring", "sustained load", "live load")
LEFT, RIGHT = 0, 1
OVERSHOOT = 1.005  # of a limit strain: how near a step must land on it
LET_GO = 1.0 - 1e-6  # of the friction force: nodes about to turn round stick first, rather than slide on
SMALLEST = 1e-4  # of a stage: below this a step is given up
EASY = 10  # iterations of a step after which the next one may be much longer
SHORT = 0.98  # of the expected movement of a second jack: where its force is looked at for the first time


class NoEquilibriumError(Exception):
    """A stage found no equilibrium beyond the fraction that it reached."""

    def __init__(self, stage: int, reached: float) -> None:
        super().__init__(f"{NAMES[stage]}: no equilibrium beyond {reached:.1%} of the stage")
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
        return cls(case, open_case(*case), live)

    @property
    def ends(self) -> tuple[int, ...]:
        """The live ends."""
        return tuple(side for side in (LEFT, RIGHT) if self.live[side])

    @property
    def full(self) -> bool:
        """Whether there is room to record another step."""
        return bool(self.case.history.rows[0] >= self.case.history.stage.size)

    def gap(self, side: int) -> float:
        """How far the tendon's end stands out of its anchor [mm]."""
        return float(self.case.state.u[0 if side == LEFT else -2])

    def anchor_force(self, side: int) -> float:
        """Force at an anchor in the last recorded step [N]."""
        return float(self.case.history.anchor[self.case.history.rows[0] - 1, side])

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


def ramp(rig: Rig, stage: int, loads: Pair, values: Pair, bonded: bool, first: float) -> None:
    """Move loads and end values together from their first to their second in steps that adapt to the
    iterations they need."""
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
            step *= 2.0 if iterations <= EASY else 1.0
        else:
            step = 0.25 * (share - done)
            if step < SMALLEST or rig.full:
                raise NoEquilibriumError(stage, done)


def jack(rig: Rig, force: float, movement: float, self_weight: Array) -> None:
    """Jacking: the live ends are pulled to `force` from slack; the beam lifts its own weight as it is
    stressed.

    With two live ends the left one is pulled, and the right one is moved outward until its force is the same:
    a little less than its expected movement first, so that the force is approached from below, then by what
    is missing.
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
    raise NoEquilibriumError(JACKING, 1.0)


def set_wedges(rig: Rig, wedge_set: float, load: Array) -> None:
    """Wedge set: the live ends move back by the set; friction turns round over the influence length."""
    rig.case.state.rub[:] *= LET_GO
    for side in rig.ends:
        rig.drive(side, PRESCRIBED)
        rig.case.ends.value[side] = rig.gap(side)
    start = rig.case.ends.value.copy()
    ramp(rig, SETTING, (load, load), (start, start - np.where(rig.live, wedge_set, 0.0)), False, 0.1)


def anchor(rig: Rig, load: Array) -> None:
    """Anchoring: prescribed motion and its reaction are swapped for the anchorage, born where the end is with
    the force it has."""
    for side in rig.ends:
        rig.drive(side, ANCHORED)
    held = rig.case.ends.value.copy()
    ramp(rig, ANCHORING, (load, load), (held, held), False, 1.0)


def sustain(rig: Rig, loads: Pair, bonded: bool) -> None:
    """Service, first part: the sustained load comes on."""
    held = rig.case.ends.value.copy()
    ramp(rig, SUSTAINED, loads, (held, held), bonded, 0.25)


@dataclass(frozen=True)
class Control:
    """Displacement control: the degree of freedom, its value in the anchored state, the sense it is driven
    in, how far, and in what steps [mm]."""

    dof: int
    start: float
    sense: float
    limit: float
    first: float
    largest: float


def load_to_failure(rig: Rig, fixed: Array, pattern: Array, control: Control, bonded: bool) -> bool:
    """Service, second part: the live pattern, driven by the control point's deflection to its limit or to the
    rupture of the tendon.

    False where no equilibrium was found beyond the last recorded step. Steps land on the first limit strain
    of a material.
    """
    state = rig.case.state
    factor, step = 0.0, control.first
    used = max(utilisation(rig.handle, state.u))
    failed = used >= 1.0
    while not rig.full:
        left = control.limit - control.sense * (state.u[control.dof] - control.start)
        if left <= 1e-9 * control.limit:
            return True

        def reach(step: float) -> Trial:
            return reach_deflection(rig, fixed, pattern, control, min(step, left), factor, bonded)  # noqa: B023

        trial = approach(reach, step, control)
        if trial is None:
            return False
        if not failed and trial.demand > OVERSHOOT:
            trial = land(reach, trial, used)
        accept(rig.handle, LIVE, trial.factor, trial.iterations, trial.residual)
        factor, used = trial.factor, trial.demand
        failed = failed or used >= 1.0
        if trial.tendon_broke:
            return True
        step = min(control.largest, trial.step * (1.5 if trial.iterations <= EASY else 1.1))
    return False


@dataclass(frozen=True)
class Trial:
    """A step that was tried: whether it found equilibrium, at which load factor, and the largest limit
    strain's utilisation there."""

    step: float
    converged: bool
    factor: float
    iterations: int
    residual: float
    demand: float
    tendon_broke: bool


def reach_deflection(
    rig: Rig, fixed: Array, pattern: Array, control: Control, step: float, factor: float, bonded: bool
) -> Trial:
    """Try a further `step` of deflection from the committed state."""
    target = rig.case.state.u[control.dof] + control.sense * step
    status, reached, iterations, residual = find_equilibrium(
        rig.handle, fixed, pattern, control.dof, target, factor, bonded
    )
    demand = utilisation(rig.handle, rig.case.work.trial)
    return Trial(step, status == CONVERGED, reached, iterations, residual, max(demand), demand[2] >= 1.0)


def approach(reach: Callable[[float], Trial], step: float, control: Control) -> Trial | None:
    """The first step that finds equilibrium: ever shorter ones, then, as a crack that opens at once passes
    its snap-back, longer ones."""
    shorter = [step * 0.25**i for i in range(5)]
    longer = [control.largest * share for share in (0.5, 1.0, 2.0)]
    for size in [*shorter, *(size for size in longer if size > step)]:
        trial = reach(size)
        if trial.converged:
            return trial
    return None


def land(reach: Callable[[float], Trial], over: Trial, used: float) -> Trial:
    """A shorter step that ends on the limit strain that `over` passed; `over` itself where the response jumps
    across it."""
    last = over
    for _ in range(4):
        trial = reach(last.step * min(max((1.001 - used) / (last.demand - used), 0.1), 0.95))
        if not trial.converged or trial.demand < 1.0:
            break
        last = trial
        if last.demand <= OVERSHOOT:
            return last
    return reach(last.step)
