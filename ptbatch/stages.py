"""The stages. Each says what moves, what is held and what is recorded; one's end state is the next one's
start, exactly."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import NoConvergence, anderson

from ptbatch.core.beam import concrete_stress
from ptbatch.core.case import Case, open_case
from ptbatch.core.concrete import FREE
from ptbatch.core.contact import EXPECTED_BACKWARD, EXPECTED_FORWARD
from ptbatch.core.failure import LIMIT, demands
from ptbatch.core.follow import Control, follow
from ptbatch.core.model import ANCHORED, PRESCRIBED, PULLED, Model
from ptbatch.core.ramp import DONE, NO_BUDGET, NO_EQUILIBRIUM, NO_ROOM, ramp
from ptbatch.design.longterm import TimeLoss

Array = NDArray[np.float64]
Pair = tuple[Array, Array]

JACKING, SETTING, ANCHORING, SUSTAINED, TIME, LIVE = range(6)
NAMES = ("jacking", "wedge set", "anchoring", "sustained load", "long-term losses", "live load")
LEFT, RIGHT = 0, 1
LET_GO = 1.0 - 1e-6  # of the friction force: nodes about to turn round stick first, rather than slide on
NO_MEAN, NO_PRESTRESS = 4, 5  # beside how a stage can end: no jacking stress for `fpe`; time takes it all
AGEING = 0.8  # of the creep coefficient, for stress that time itself makes; EN 1992-1-1, 5.10.6 (2)
PASSES = 20  # times that time takes its part
STRIDE, SMALLEST = 2e-4, 1e-3  # strain of a step at first, and the share below which it is given up
LOST, STRAINED = 5e-7, 1e-6  # how near it must come: of the tendon's stress, strain of the concrete
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
        return cls(case, open_case(*case), live)

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
        """Stress and modulus of the concrete in all layers (n, 2, m) in the committed state [MPa]."""
        model, state, _, work, *_ = self.case
        stress, modulus = np.empty((2, *self.own_strain.shape))
        concrete_stress(model, state, state.u, work.q6, stress, modulus)
        return stress, modulus

    @property
    def own_strain(self) -> Array:
        """What the concrete has crept and shrunk by in all layers (n, 2, m), tension positive."""
        return self.case.state.concrete[:, :, FREE]

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


def set_wedges(rig: Rig, wedge_set: float, load: Array, zone: tuple[float, float]) -> None:
    """Wedge set: the live ends move back by the set; friction turns round over the influence length.

    zone: arc lengths up to which, and from which on, that is expected to happen.
    """
    state = rig.case.state
    state.rub[:] *= LET_GO
    state.motion[state.s < zone[LEFT]] = EXPECTED_FORWARD
    state.motion[state.s > zone[RIGHT]] = EXPECTED_BACKWARD
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


def lose(rig: Rig, load: Array, loss: TimeLoss, bonded: bool) -> None:
    """Service, second part: time takes of the tendon's mean stress what `loss` says in all. The concrete
    shrinks, and creeps under its stress; that it is pressed less in the end is taken as well. What the tendon
    has not lost by that its length at rest takes, growing. One step of the record."""
    model, history = rig.case.model, rig.case.history
    first, before, rest = int(history.rows[0]), rig.mean_stress, model.rest_length.copy()
    pressed, modulus = rig.concrete_stress()
    creep, Ep = loss.phi / model.concrete.Ec, model.strand.Ep
    if loss.total >= before:
        raise NoEquilibriumError(TIME, NO_PRESTRESS, 0.0)

    def untold(strains: Array) -> Array:
        """What is missing of the strains of the layers and of the tendon's growth, after these."""
        age(rig, load, strains[:-1].reshape(pressed.shape), rest * (1.0 + strains[-1]), bonded)
        now, modulus = rig.concrete_stress()
        strain = creep * (pressed + AGEING * (now - pressed)) - loss.eps_cs
        change = let_go(model, strain - rig.own_strain, modulus, AGEING * creep)
        missing = loss.total - (before - rig.mean_stress)
        return np.append(change, missing / Ep)

    def far(change: Array) -> float:
        """How far that is from what is near enough."""
        return float(max(np.abs(change[:-1]).max() / STRAINED, abs(change[-1]) * Ep / (LOST * before)))

    held = (creep * pressed - loss.eps_cs) / (1.0 + AGEING * creep * np.maximum(modulus, 0.0))
    start = np.append(held, 0.0)  # as if nothing gave way: what holds it is not pulled more than in the end
    try:
        anderson(untold, start, alpha=1.0, M=3, f_tol=1.0, tol_norm=far, line_search=None, maxiter=PASSES)
    except NoConvergence as none:
        raise NoEquilibriumError(TIME, NO_ROOM, 0.0) from none
    finally:
        history.join(first)


def let_go(model: Model, change: Array, modulus: Array, creep: float) -> Array:
    """What to strain the layers by (n, 2, m), that are to change by so much. An element is free to stretch
    and its two sections are free to bend; of the rest its own layers hold it back, and being held back they
    creep the less.

    modulus (n, 2, m) [MPa]; creep: strain by the stress that this makes [1/MPa].
    """
    stiff = np.maximum(modulus, 0.0)
    ways = np.zeros((2, model.layer_y.size, 3))
    ways[..., 0] = 1.0
    ways[0, :, 1] = ways[1, :, 2] = model.layer_y / (model.top - model.bottom)
    weighted = (stiff * model.layer_area)[..., None] * ways
    held = np.linalg.pinv(np.einsum("egmi,gmj->eij", weighted, ways), hermitian=True)
    free = np.einsum("gmi,eij,ehkj,ehk->egm", ways, held, weighted, change, optimize=True)
    return np.asarray(free + (change - free) / (1.0 + creep * stiff))


def age(rig: Rig, load: Array, own: Array, rest: Array, bonded: bool) -> None:
    """Move the concrete's own strain (n, 2, m) and the tendon's length at rest (n+1,) from where they are, in
    steps that Newton's method can take."""
    held, length = rig.case.ends.value.copy(), rig.case.model.rest_length
    own_from, rest_from, done = rig.own_strain.copy(), length.copy(), 0.0
    step = min(1.0, STRIDE / max(float(np.abs(own - own_from).max()), 1e-12))
    while done < 1.0:
        share = min(1.0, done + step)
        rig.own_strain[:] = own_from + share * (own - own_from)
        length[:] = rest_from + share * (rest - rest_from)
        try:
            move(rig, TIME, (load, load), (held, held), bonded)
        except NoEquilibriumError:
            step *= 0.25
            if step < SMALLEST:
                raise
        else:
            done = share


def load_to_failure(rig: Rig, fixed: Array, pattern: Array, control: Control, bonded: bool) -> int:
    """Service, third part: the live pattern, driven by the control point's deflection to its limit or to the
    rupture of the tendon; how it ended, a key of `WHY` or DONE."""
    rig.case.state.rub[:] *= LET_GO
    ended = int(follow(rig.handle, LIVE, fixed, pattern, control, bonded))
    spent = rig.case.work.spent[0] >= rig.case.tolerance.budget
    return NO_BUDGET if ended == NO_EQUILIBRIUM and spent else ended
