"""Equilibrium of one step: Newton-Raphson with a line search on the work of the step, under load or
displacement control."""

from typing import NamedTuple

import numpy as np

from ptbatch.core.assembly import internal_forces, tangent
from ptbatch.core.banded import factorise, substitute
from ptbatch.core.jit import kernel
from ptbatch.core.model import PRESCRIBED, tendon_dof

CONVERGED, TOO_MANY_ITERATIONS, SINGULAR = range(3)
PLAIN, SEARCH, FLAT = range(3)  # whole steps; steps searched along; also without the stiffness of softening


class Target(NamedTuple):
    """External forces `fixed + factor * pattern`; with `dof` >= 0 the factor is free and that displacement is
    to reach `value`."""

    fixed: np.ndarray  # (ndof,)
    pattern: np.ndarray  # (ndof,)
    dof: int
    value: float


class Tolerance(NamedTuple):
    """Convergence on both: largest residual over `force` (moments over force * arm), largest increment over
    `length`."""

    residual: float
    increment: float
    force: float
    arm: float
    length: float
    plain: int  # most iterations, by the way of iterating
    search: int
    flat: int


@kernel
def unbalance(model, target, factor, ends, work):
    """work.residual = external - internal, zero where held."""
    n = model.x.size - 1
    for i in range(work.f.size):
        work.residual[i] = 0.0 if model.held[i] else target.fixed[i] + factor * target.pattern[i] - work.f[i]
    for side in range(2):  # a gap's row is complete in itself
        i = tendon_dof(side * (n + 1))
        work.residual[i] = -work.f[i]


@kernel
def residual_norm(ends, work, tolerance):
    """Largest component relative to the reference force; rows of a prescribed gap do not count."""
    worst = 0.0
    size = work.residual.size
    for i in range(size):
        if (i == 0 and ends.mode[0] == PRESCRIBED) or (i == size - 2 and ends.mode[1] == PRESCRIBED):
            continue
        arm = tolerance.arm if i % 5 == 4 else 1.0
        worst = max(worst, abs(work.residual[i]) / arm)
        if not np.isfinite(work.residual[i]):
            return np.inf
    return worst / tolerance.force


@kernel
def increment_norm(work, tolerance):
    worst = 0.0
    for i in range(work.du.size):
        arm = tolerance.arm if i % 5 == 4 else 1.0
        worst = max(worst, abs(work.du[i]) * arm)
    return worst / tolerance.length


@kernel
def power_of_step(ends, work):
    """du . R, the work that is left to do along the step."""
    total = 0.0
    size = work.du.size
    for i in range(size):
        if (i == 0 and ends.mode[0] == PRESCRIBED) or (i == size - 2 and ends.mode[1] == PRESCRIBED):
            continue
        total += work.du[i] * work.residual[i]
    return total


@kernel
def hold(model, work):
    """Replace the rows of held degrees of freedom by identities."""
    half = (work.matrix.shape[1] - 1) // 2
    for i in range(model.held.size):
        if model.held[i]:
            work.matrix[i, :] = 0.0
            work.matrix[i, half] = 1.0


@kernel
def move(eta, model, state, target, factor, dfactor, ends, bonded, work):
    """Go to eta along the step; what is left of its work there."""
    for i in range(work.trial.size):
        work.trial[i] = work.before[i] + eta * work.du[i]
    internal_forces(model, state, work.trial, ends, bonded, work)
    unbalance(model, target, factor + eta * dfactor, ends, work)
    return power_of_step(ends, work)


@kernel
def line_search(model, state, target, factor, dfactor, ends, bonded, work, tolerance):
    """The share eta of the step to take: the whole where that lowers the work or the residual, else a zero of
    the work (Illinois)."""
    start = power_of_step(ends, work)
    norm = residual_norm(ends, work, tolerance)
    work.before[:] = work.trial
    eta = 1.0
    g = move(eta, model, state, target, factor, dfactor, ends, bonded, work)
    for _ in range(8):
        if np.isfinite(g):
            break
        eta *= 0.25
        g = move(eta, model, state, target, factor, dfactor, ends, bonded, work)
    if abs(g) <= 0.8 * abs(start) or g * start > 0.0 or residual_norm(ends, work, tolerance) <= 0.9 * norm:
        return eta
    low, g_low, high, g_high = 0.0, start, eta, g
    for _ in range(12):
        eta = (low * g_high - high * g_low) / (g_high - g_low)
        g = move(eta, model, state, target, factor, dfactor, ends, bonded, work)
        if abs(g) <= 0.5 * abs(start):
            break
        if g * g_high < 0.0:
            low, g_low = high, g_high
        else:
            g_low *= 0.5
        high, g_high = eta, g
    return eta


@kernel
def equilibrate(model, state, target, factor, ends, bonded, way, work, tolerance):
    """Iterate work.trial to equilibrium in one of the ways above; returns (status, factor, iterations,
    relative residual)."""
    half = (work.matrix.shape[1] - 1) // 2
    increment = np.inf
    most = tolerance.plain if way == PLAIN else tolerance.search if way == SEARCH else tolerance.flat
    for iteration in range(most):
        tangent(model, state, work.trial, ends, bonded, way == FLAT, work)
        unbalance(model, target, factor, ends, work)
        norm = residual_norm(ends, work, tolerance)
        if norm <= tolerance.residual and increment <= tolerance.increment:
            return CONVERGED, factor, iteration, norm
        if not np.isfinite(norm):
            return SINGULAR, factor, iteration, norm
        hold(model, work)
        if not factorise(work.matrix, half, work.multipliers, work.pivots):
            return SINGULAR, factor, iteration, norm
        work.du[:] = work.residual
        substitute(work.matrix, half, work.multipliers, work.pivots, work.du)
        dfactor = 0.0
        if target.dof >= 0:
            for i in range(work.du.size):
                work.du_load[i] = 0.0 if model.held[i] else target.pattern[i]
            substitute(work.matrix, half, work.multipliers, work.pivots, work.du_load)
            reach = work.du_load[target.dof]
            if reach == 0.0:
                return SINGULAR, factor, iteration, norm
            dfactor = (target.value - work.trial[target.dof] - work.du[target.dof]) / reach
            for i in range(work.du.size):
                work.du[i] += dfactor * work.du_load[i]
        if way == PLAIN or iteration == 0:  # from equilibrium the first step has no work to search along
            work.trial[:] += work.du
            factor += dfactor
        else:
            factor += dfactor * line_search(
                model, state, target, factor, dfactor, ends, bonded, work, tolerance
            )
        increment = increment_norm(work, tolerance)
    return TOO_MANY_ITERATIONS, factor, most, norm
