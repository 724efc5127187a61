"""Service, between the sustained and the live load: what time does to concrete and tendon."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import NoConvergence, anderson

from ptbatch.core.model import Model
from ptbatch.core.ramp import NO_ROOM
from ptbatch.design.longterm import TimeLoss
from ptbatch.stages import NO_PRESTRESS, TIME, NoEquilibriumError, Rig, move

Array = NDArray[np.float64]

AGEING = 0.8  # of the creep coefficient, for stress that time itself makes; EN 1992-1-1, 5.10.6 (2)
PASSES = 20  # times that time takes its part
STRIDE, SMALLEST = 2e-4, 1e-3  # strain of a step at first, and the share below which it is given up
LOST, STRAINED = 5e-7, 1e-6  # how near it must come: of the tendon's stress, strain of the concrete


def lose(rig: Rig, load: Array, loss: TimeLoss, bonded: bool) -> None:
    """Time takes of the tendon's mean stress what `loss` says in all. The concrete
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
    """What to strain the layers by (m, 2n), that are to change by so much. An element is free to stretch
    and its two sections are free to bend; of the rest its own layers hold it back, and being held back they
    creep the less.

    modulus (m, 2n) [MPa]; creep: strain by the stress that this makes [1/MPa].
    """
    shape = len(model.layer_y), len(model.x) - 1, 2  # layers m, elements e, their sections g
    stiff = np.maximum(modulus, 0.0)
    ways = np.zeros((shape[0], 2, 3))
    ways[..., 0] = 1.0
    ways[:, 0, 1] = ways[:, 1, 2] = model.layer_y / (model.top - model.bottom)
    weights = stiff.reshape(shape) * model.layer_area[:, None, None]
    held = np.linalg.pinv(np.einsum("meg,mgi,mgj->eij", weights, ways, ways), hermitian=True)
    moved = np.einsum("meg,mgi,meg->ei", weights, ways, change.reshape(shape))
    free = np.einsum("mgi,eij,ej->meg", ways, held, moved).reshape(change.shape)
    return np.asarray(free + (change - free) / (1.0 + creep * stiff))


def age(rig: Rig, load: Array, own: Array, rest: Array, bonded: bool) -> None:
    """Move the concrete's own strain (m, 2n) and the tendon's length at rest (n+1,) from where they are, in
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
            rig.own_strain[:] = own_from + done * (own - own_from)
            length[:] = rest_from + done * (rest - rest_from)
            step *= 0.25
            if step < SMALLEST:
                raise
        else:
            done = share
