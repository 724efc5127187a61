"""The record of accepted steps, and how a step is accepted: the trial becomes the committed state."""

from typing import NamedTuple

import numpy as np

from ptbatch.core.assembly import end_slip
from ptbatch.core.beam import beam_strains
from ptbatch.core.concrete import fibres
from ptbatch.core.contact import UNKNOWN
from ptbatch.core.jit import kernel
from ptbatch.core.section import commit_sections


class History(NamedTuple):
    """One row an accepted step, `rows[0]` of them."""

    rows: np.ndarray  # (1,) int, how many of the rows below are used
    stage: np.ndarray  # (rows,) int
    factor: np.ndarray  # (rows,) of the live pattern
    iterations: np.ndarray  # (rows,) int
    residual: np.ndarray  # (rows,) largest imbalance, relative
    u: np.ndarray  # (rows, ndof)
    f: np.ndarray  # (rows, ndof) internal forces; at a support its reaction less the load there
    T: np.ndarray  # (rows, n+1)
    s: np.ndarray  # (rows, n+2) arc length of the tendon nodes
    anchor: np.ndarray  # (rows, 2) force at the two anchors
    strain: np.ndarray  # (rows,) largest of the tendon

    def join(self, first: int) -> None:
        """Make one row, the last of them, of all from `first` on."""
        last = int(self.rows[0]) - 1
        if last <= first:
            return
        joined = slice(first, last + 1)
        iterations, residual = self.iterations[joined].sum(), self.residual[joined].max()
        for column in self[1:]:
            column[first] = column[last]
        self.iterations[first], self.residual[first] = iterations, residual
        self.rows[0] = first + 1


def new_history(rows: int, n: int) -> History:
    """Room for that many steps of n beam elements."""
    ndof = 5 * n + 7
    return History(
        np.zeros(1, np.int64),
        np.empty(rows, np.int64),
        np.empty(rows),
        np.empty(rows, np.int64),
        np.empty(rows),
        np.empty((rows, ndof)),
        np.empty((rows, ndof)),
        np.empty((rows, n + 1)),
        np.empty((rows, n + 2)),
        np.empty((rows, 2)),
        np.empty(rows),
    )


@kernel
def record(stage, factor, iterations, residual, work, history):
    row = history.rows[0]
    last = work.T.size - 1
    history.stage[row] = stage
    history.factor[row] = factor
    history.iterations[row] = iterations
    history.residual[row] = residual
    history.u[row] = work.trial
    history.f[row] = work.f
    history.T[row] = work.T
    history.s[row] = work.s
    history.anchor[row, 0] = work.T[0] + work.shear[0]
    history.anchor[row, 1] = work.T[last] + work.shear[last + 1]
    history.strain[row] = np.max(work.stretch)
    history.rows[0] = row + 1


@kernel
def commit(model, state, ends, work):
    """Make the trial, that was evaluated last, the committed state: fibres, bars, tendon, contact segments
    and friction springs."""
    n = model.x.size - 1
    state.u[:] = work.trial
    commit_sections(model, state, work)
    for e in range(n + 1):
        state.tendon[e] = max(state.tendon[e], work.stretch[e])
    state.segment[:] = work.segment
    state.s[:] = work.s
    state.rub[:] = work.shear
    state.motion[:] = UNKNOWN
    for side in range(2):
        state.s[side * (n + 1)] = end_slip(side, ends.mode[side], model, state.u, work)


@kernel
def rewind(state, work):
    """Start a trial from the committed state."""
    work.trial[:] = state.u
    work.segment[:] = state.segment
    work.motion[:] = state.motion
    work.xi[:] = 0.5  # a failed trial may have left anything there


@kernel
def concrete_stress(case, stress, modulus):
    """Stress and modulus (m, 2n) of the concrete in all layers and sections in the committed state."""
    model, state, work = case.model, case.state, case.work
    beam_strains(model, state.u, work)
    for i in range(model.layer_y.size):
        y, past = model.layer_y[i], state.concrete[i]
        fibres(y, work.strain[0], work.strain[1], past, model.concrete, stress[i], modulus[i])
