"""Equilibrium of one step: Newton-Raphson under load or displacement control."""

from typing import NamedTuple

import numpy as np

from ptbatch.core.assembly import bend_beam, internal_forces, tangent
from ptbatch.core.banded import factorise, half_width, substitute
from ptbatch.core.case import driven
from ptbatch.core.contact import UNKNOWN
from ptbatch.core.jit import kernel
from ptbatch.core.model import PRESCRIBED, PULLED, tendon_dof
from ptbatch.core.placement import find_segments, place_tendon, slide_tendon, stay_on_segments

CONVERGED, TOO_MANY_ITERATIONS, SINGULAR = range(3)
HOPELESS = 1e8  # relative residual
NEAR, NEARER = 1e-3, 1e-6  # relative residuals: the next step may arrive; the last tangent will do
NOISE = 100.0  # times the tolerance: where a residual stays for good because fibres at rest change sides
# Residuals that friction which turns to and fro comes back to: how far they differ, and how much they go up
# and down at least
SAME, SWING = 0.1, 2.0
SETTLED = 4  # iterations without a lower residual after which one at round-off has come to rest


class Way(NamedTuple):
    """A way of iterating. damping: this share of the uncracked stiffness is added to the tangent in the first
    iteration, and `decay` of it is left from one to the next; search: along each step for the share of it
    that leaves no work to do."""

    most: int  # iterations, in all and without a lower residual
    patience: int
    damping: float
    decay: float
    search: bool


@kernel
def unbalance(case, target, factor):
    """work.residual = external - internal, zero where held."""
    model, work = case.model, case.work
    n = model.x.size - 1
    for i in range(work.f.size):
        work.residual[i] = 0.0 if model.held[i] else target.fixed[i] + factor * target.pattern[i] - work.f[i]
    for side in range(2):  # a gap's row is complete in itself
        i = tendon_dof(side * (n + 1))
        work.residual[i] = -work.f[i]


@kernel
def residual_norm(case):
    """Largest component relative to the reference force."""
    residual, tolerance = case.work.residual, case.tolerance
    worst = 0.0
    for i in range(residual.size):
        if not np.isfinite(residual[i]):
            return np.inf
        worst = max(worst, abs(residual[i]) / (tolerance.arm if i % 5 == 4 else 1.0))
    return worst / tolerance.force


@kernel
def increment_norm(case):
    du, tolerance = case.work.du, case.tolerance
    worst = 0.0
    for i in range(du.size):
        worst = max(worst, abs(du[i]) * (tolerance.arm if i % 5 == 4 else 1.0))
    return worst / tolerance.length


@kernel
def power_of_step(case):
    """du . R, the work that is left to do along the step."""
    du, residual = case.work.du, case.work.residual
    total = 0.0
    for i in range(du.size):
        total += du[i] * residual[i]
    return total


@kernel
def hold(model, work):
    """Replace the rows of held degrees of freedom by identities."""
    half = half_width(work.matrix)
    for i in range(model.held.size):
        if model.held[i]:
            work.matrix[i, :] = 0.0
            work.matrix[i, half] = 1.0


@kernel
def move(eta, case, target, factor):
    """Go to eta along the step; what is left of its work there."""
    work = case.work
    for i in range(work.trial.size):
        work.trial[i] = work.before[i] + eta * work.du[i]
    stay_on_segments(case.model, work.trial, work)
    internal_forces(case.model, case.state, work.trial, case.ends, target.bonded, work)
    unbalance(case, target, factor)
    return power_of_step(case)


@kernel
def line_search(case, target, factor, dfactor):
    """The share eta of the step to take: the whole where that lowers the work or the residual, else a zero of
    the work (Illinois)."""
    start = power_of_step(case)
    norm = residual_norm(case)
    case.work.before[:] = case.work.trial
    eta = 1.0
    g = move(eta, case, target, factor + eta * dfactor)
    for _ in range(8):
        if np.isfinite(g):
            break
        eta *= 0.25
        g = move(eta, case, target, factor + eta * dfactor)
    if abs(g) <= 0.8 * abs(start) or g * start > 0.0 or residual_norm(case) <= 0.9 * norm:
        return eta
    low, g_low, high, g_high = 0.0, start, eta, g
    for _ in range(12):
        eta = (low * g_high - high * g_low) / (g_high - g_low)
        g = move(eta, case, target, factor + eta * dfactor)
        if abs(g) <= 0.5 * abs(start):
            break
        if g * g_high < 0.0:
            low, g_low = high, g_high
        else:
            g_low *= 0.5
        high, g_high = eta, g
    return eta


@kernel
def factorise_tangent(case):
    """Factorise work.matrix; false where it is singular."""
    model, work = case.model, case.work
    hold(model, work)
    return factorise(work.matrix, work.weights, work.multipliers, work.pivots, work.reach)


@kernel
def step(case, target):
    """work.du from the factorised tangent and the residual; returns (solved, the change of the factor)."""
    model, work = case.model, case.work
    work.du[:] = work.residual
    for i in range(work.du.size):
        work.du_load[i] = 0.0 if model.held[i] else target.pattern[i]
    substitute(work.matrix, work.multipliers, work.pivots, work.reach, work.du, work.du_load)
    if target.dof < 0:
        return True, 0.0
    reach = driven(work.du_load, target.dof, target.other)
    if reach == 0.0:
        return False, 0.0
    left = target.value - driven(work.trial, target.dof, target.other)
    dfactor = (left - driven(work.du, target.dof, target.other)) / reach
    for i in range(work.du.size):
        work.du[i] += dfactor * work.du_load[i]
    return True, dfactor


@kernel
def residual_alone(case, target, factor):
    """Relative residual of the trial, by the laws as they stand and without a tangent."""
    find_segments(case.model, case.work.trial, case.work)
    internal_forces(case.model, case.state, case.work.trial, case.ends, target.bonded, case.work)
    unbalance(case, target, factor)
    return residual_norm(case)


@kernel
def repeats(norm, iteration, norms):
    """Whether the residuals so far end in one series twice, up and down, up to half as long as there is room
    for in norms."""
    size = norms.size
    norms[iteration % size] = norm
    for period in range(2, min(size, iteration) // 2 + 1):
        same, low, high = True, norm, norm
        for k in range(iteration - period + 1, iteration + 1):
            now, then = norms[k % size], norms[(k - period) % size]
            same = same and abs(now - then) < SAME * then
            low, high = min(low, now), max(high, now)
        if same and high > SWING * low:
            return True
    return False


@kernel
def pulled(ends):
    """Whether a jack pulls at the tendon."""
    return ends.mode[0] == PULLED or ends.mode[1] == PULLED


@kernel
def slides_along(case, target):
    """Whether the tendon is to slide into balance before each tangent: between ends that stand still, by
    friction across the bisector."""
    return case.model.contact.corrected and not target.bonded and not pulled(case.ends)


@kernel
def place_ends(case):
    """Put prescribed ends of the tendon where they are to be, so that their rows, which balance no forces,
    have no residual."""
    for side in range(2):
        if case.ends.mode[side] == PRESCRIBED:
            case.work.trial[tendon_dof(side * case.model.x.size)] = case.ends.value[side]


@kernel
def equilibrate(case, target, factor, way):
    """Iterate work.trial to equilibrium; returns (status, factor, iterations, relative residual).

    Where it converged, the last evaluation was `residual_alone`, at the trial.
    """
    work, tolerance = case.work, case.tolerance
    increment = np.inf if target.dof >= 0 else 0.0  # what nothing drives may be in equilibrium where it is
    norm = np.inf
    least = np.inf
    improved = 0
    damping = way.damping
    place_ends(case)
    slides = slides_along(case, target)
    reused = np.inf  # residual at the last use of a tangent that is not of its place
    for iteration in range(way.most):
        looked = norm <= NEAR
        if looked:  # the last step may have arrived: a tangent would be too much for a look
            norm = residual_alone(case, target, factor)
            if norm <= tolerance.residual and increment <= tolerance.increment:
                return CONVERGED, factor, iteration, norm
            if norm <= min(NEARER, 0.1 * reused) and damping <= NEARER:  # nearly: its tangent is good enough
                reused = norm
                _, dfactor = step(case, target)
                work.trial[:] += work.du
                factor += dfactor
                increment = increment_norm(case)
                norm = NEAR
                continue
        if way.search:
            work.motion[:] = UNKNOWN
        if not looked:  # which has left all that the tangent needs
            place_tendon(case.model, case.state, work.trial, work)
        if not looked or damping > 0.0:
            bend_beam(case.model, case.state, work.trial, damping, work)
        if slides:
            slide_tendon(case.model, case.state, work.trial, work)
        tangent(case.model, case.state, work.trial, case.ends, target.bonded, work)
        unbalance(case, target, factor)
        norm = residual_norm(case)
        if not norm < HOPELESS:
            return SINGULAR, factor, iteration, norm
        if repeats(norm, iteration, work.norms):
            return TOO_MANY_ITERATIONS, factor, iteration, norm
        if norm < least:
            least = norm
            improved = iteration
        stays = iteration > improved + SETTLED and norm <= NOISE * tolerance.residual
        if (norm <= tolerance.residual and increment <= tolerance.increment) or stays:
            norm = residual_alone(case, target, factor)
            if norm <= (NOISE if stays else 1.0) * tolerance.residual:
                return CONVERGED, factor, iteration, norm
        if iteration > max(improved, way.patience) + way.patience:
            return TOO_MANY_ITERATIONS, factor, iteration, norm
        if not factorise_tangent(case):
            return SINGULAR, factor, iteration, norm
        solved, dfactor = step(case, target)
        if not solved:
            return SINGULAR, factor, iteration, norm
        damping *= way.decay
        reused = np.inf
        if way.search and iteration > 0:  # from equilibrium there is no work to search along
            factor += dfactor * line_search(case, target, factor, dfactor)
        else:
            work.trial[:] += work.du
            factor += dfactor
        increment = increment_norm(case)
    return TOO_MANY_ITERATIONS, factor, way.most, norm
