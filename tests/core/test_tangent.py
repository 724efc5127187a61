"""The whole tangent of a small member, in its band, against central differences of the internal forces."""

import numba
import numpy as np
import pytest

from ptbatch.core.assembly import internal_forces, tangent
from tests.core.numerics import central_jacobian
from tests.members import SMALL, anchored, jacked, sustained

# How the tendon moves on from its committed state, to the left [mm]: far beyond what friction holds, or less.
SLIDE, STICK = 0.2, -1e-4


@numba.njit  # not cached: it would outlive the kernels that it calls
def evaluate(case, u, bonded, flat, with_tangent):
    if with_tangent:
        tangent(case.model, case.state, u, case.ends, bonded, flat, case.work)
    else:
        internal_forces(case.model, case.state, u, case.ends, bonded, case.work)
    return case.work.f.copy()


def unrolled(matrix):
    """Dense matrix from its band."""
    size, width = matrix.shape
    dense = np.zeros((size, size + width - 1))
    for i, row in enumerate(matrix):
        dense[i, i : i + width] = row
    half = (width - 1) // 2
    assert not dense[:, :half].any() and not dense[:, size + half :].any()
    return dense[:, half : size + half]


def nearby(run, slip):
    """Displacements a little off the committed ones: differences there cross no corner of a law."""
    u, nodes = run.rig.case.state.u.copy(), len(run.setup.mesh.x)
    rng = np.random.default_rng(0)
    for i, size in enumerate((1e-3, 0.05, 5e-6)):
        u[2 + i : 5 * nodes : 5] += size * rng.standard_normal(nodes)
    u[5:-2:5] -= slip * np.linspace(1.2, 1.0, nodes - 1)  # stretching as well
    u[0] += 1.2 * slip
    return u


STRAIGHT = {"tendon_law": "elastic"}  # no corner where first loading turns into unloading
LOADED = SMALL | {"w_dead": 45.0}
STAGES = {
    "jacking, sliding": (lambda: jacked(SMALL), SLIDE, False),
    "jacking, sticking": (lambda: jacked(SMALL | STRAIGHT), STICK, False),
    "polygon duct": (lambda: jacked(SMALL | {"sheathing": "polygon"}), SLIDE, False),
    "uncorrected": (lambda: jacked(SMALL | {"correction": False}), SLIDE, False),
    "two live ends": (lambda: jacked(SMALL | {"jack": "both"}), SLIDE, False),
    "anchored": (lambda: anchored(SMALL | STRAIGHT), -SLIDE, False),
    "cracked": (lambda: sustained(LOADED), SLIDE, False),
    "grouted": (lambda: sustained(LOADED | {"bond": "bonded"}), SLIDE, True),
}


@pytest.mark.parametrize("stage", STAGES)
def test_tangent_is_the_central_difference(stage):
    bring, slip, bonded = STAGES[stage]
    run = bring()
    u, handle = nearby(run, slip), run.rig.handle
    f = evaluate(handle, u, bonded, False, True)
    exact = unrolled(run.rig.case.work.matrix)
    # the search has put every node on its segment; as in a line search it is not repeated here
    np.testing.assert_allclose(evaluate(handle, u, bonded, False, False), f, rtol=1e-9, atol=1e-3)
    step = np.where(np.arange(u.size) % 5 == 4, 1e-8, 1e-5)
    difference = central_jacobian(lambda p: evaluate(handle, p, bonded, False, False), u, step)
    scale = np.sqrt(np.outer(np.abs(exact).max(axis=1), np.abs(exact).max(axis=0)))
    scale[scale == 0.0] = scale.max()  # nothing but round-off may stand there
    # round-off: positions of 1e3 mm keep 1e-13 mm, which over 1e-5 mm is 1e-8
    np.testing.assert_allclose(difference / scale, exact / scale, atol=1e-6)


def test_the_cracked_stages_are_cracked():
    case = sustained(LOADED).rig.case
    assert case.state.concrete[..., 0].max() > 2.0 * case.model.concrete.eps_cr
