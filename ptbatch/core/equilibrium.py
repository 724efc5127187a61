"""Equilibrium of an accepted step, checked by statics instead of by the residual that the iteration brought
down.

Three checks, each relative to the jacking force (moments to that force times the depth of the section):
support reactions against loads on the deflected member; the forces of the fibres at the left end of every
element against all that acts on the beam left of it; each tendon node under its two tensions and the force of
the duct, which must lie within Coulomb's cone.
"""

import numpy as np

from ptbatch.core.anchorage import anchor, end_forces
from ptbatch.core.assembly import internal_forces
from ptbatch.core.jit import kernel
from ptbatch.core.model import beam_dof, tendon_dof
from ptbatch.core.placement import gather_end, stay_on_segments


@kernel
def imbalance(case, target, factor):
    """Largest relative imbalance of the trial."""
    stay_on_segments(case.model, case.work.trial, case.work)
    internal_forces(case.model, case.state, case.work.trial, case.ends, target.bonded, case.work)
    return imbalance_as_evaluated(case, target, factor)


@kernel
def imbalance_as_evaluated(case, target, factor):
    """The same where `internal_forces` has just been evaluated at the trial."""
    on_beam(case, target, factor)
    worst = max(along_beam(case), along_tendon(case, target.bonded))
    return worst if np.isfinite(worst) else np.inf


@kernel
def on_beam(case, target, factor):
    """work.on_beam (n+1, 3): loads, support reactions and what the tendon does to the beam, node by node."""
    model, work = case.model, case.work
    n = model.x.size - 1
    for k in range(n + 1):
        for i in range(3):
            at = beam_dof(k) + i
            load = target.fixed[at] + factor * target.pattern[at]
            work.on_beam[k, i] = work.f[at] if model.held[at] else load  # load + reaction where held
    for j in range(1, n + 1):
        m = work.segment[j]
        for i in range(3):
            work.on_beam[m, i] -= work.duct[j, 2 + i]
            work.on_beam[m + 1, i] -= work.duct[j, 5 + i]
    for side in range(2):
        end_force(side, case)
        for i in range(3):
            work.on_beam[side * n, i] -= work.f6[1 + i]


@kernel
def end_force(side, case):
    """work.f6 of an end of the tendon at the trial."""
    model, state, ends, work = case.model, case.state, case.ends, case.work
    n = model.x.size - 1
    gather_end(side, model, work.trial, work)
    j = side * (n + 1)
    end_forces(
        work.q6,
        ends.mode[side],
        ends.value[side],
        ends.born[side],
        work.T[side * n],
        0.0,
        work.length[side * n],
        state.s[j],
        state.rub[j],
        work.rough[j],
        False,
        anchor(side, model),
        model.contact,
        work.f6,
    )


@kernel
def along_beam(case):
    """Sums of `on_beam` from the left against the fibres of each element, and over all of it against zero."""
    model, work = case.model, case.work
    n = model.x.size - 1
    depth = model.top - model.bottom
    across = up = turn = worst = 0.0
    for k in range(n + 1):
        at = beam_dof(k)
        if k > 0:  # carry the moment on from node to node
            dx = model.x[k] - model.x[k - 1] + work.trial[at] - work.trial[at - 5]
            dy = work.trial[at + 1] - work.trial[at - 4]
            turn += dy * across - dx * up
        across += work.on_beam[k, 0]
        up += work.on_beam[k, 1]
        turn += work.on_beam[k, 2]
        end = work.left_end[k]  # zero beyond the last element
        out = max(abs(across - end[0]), abs(up - end[1]), abs(turn - end[2]) / depth)
        worst = max(worst, out)
    return worst / case.tolerance.force


@kernel
def along_tendon(case, bonded):
    """Each inner tendon node under T3, T4 and the duct's N and friction, rebuilt from the chords alone."""
    model, work = case.model, case.work
    worst = 0.0
    for j in range(1, model.x.size):
        ex = work.T[j] * work.chord[j, 0] - work.T[j - 1] * work.chord[j - 1, 0]
        ey = work.T[j] * work.chord[j, 1] - work.T[j - 1] * work.chord[j - 1, 1]
        if model.contact.corrected:
            ux = work.chord[j, 0] + work.chord[j - 1, 0]
            uy = work.chord[j, 1] + work.chord[j - 1, 1]
            norm = np.sqrt(ux * ux + uy * uy)
            ux /= norm
            uy /= norm
            fx = work.shear[j] * ux - work.normal[j] * uy
            fy = work.shear[j] * uy + work.normal[j] * ux
        else:
            fx = work.f[tendon_dof(j)] + ex
            fy = work.f[tendon_dof(j) + 1] + ey
        worst = max(worst, abs(fx - ex), abs(fy - ey))
        tension = 0.5 * (work.T[j - 1] + work.T[j])
        capacity = model.contact.mu * abs(work.normal[j]) + work.rough[j] * tension
        if not bonded:
            worst = max(worst, abs(work.shear[j]) - capacity)
    return worst / case.tolerance.force
