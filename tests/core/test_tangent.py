"""The whole tangent of a small member, in its band, against central differences of the internal forces."""

import numba
import numpy as np
import pytest

from ptbatch.core.assembly import bend_beam, internal_forces, tangent
from ptbatch.core.beam import chord
from ptbatch.core.contact import (
    BACKWARD,
    EXPECTED_BACKWARD,
    EXPECTED_FORWARD,
    FORWARD,
    HELD,
    UNKNOWN,
)
from ptbatch.core.placement import place_tendon, stay_on_segments
from tests.core.numerics import central_jacobian
from tests.members import SMALL, anchored, jacked, sustained

# How the tendon moves on from its committed state, to the left [mm]: far beyond what friction holds, or less.
SLIDE, STICK = 0.2, -1e-4


@numba.njit  # not cached: it would outlive the kernels that it calls
def forces(case, u, bonded):
    stay_on_segments(case.model, u, case.work)
    internal_forces(case.model, case.state, u, case.ends, bonded, case.work)
    return case.work.f.copy()


@numba.njit
def forces_and_tangent(case, u, bonded, was, damping):
    """Every inner node comes from an iteration in which its motion was `was`."""
    case.work.motion[:] = UNKNOWN
    case.work.motion[1:-1] = was
    place_tendon(case.model, case.state, u, case.work)
    bend_beam(case.model, case.state, u, damping, case.work)
    tangent(case.model, case.state, u, case.ends, bonded, case.work)
    return case.work.f.copy(), case.work.matrix.copy()


def unrolled(matrix):
    """Dense matrix from its band."""
    size, width = matrix.shape
    dense = np.zeros((size, size + width - 1))
    for i, row in enumerate(matrix):
        dense[i, i : i + width] = row
    half = width // 3
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
    u[-2] -= slip
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


def check(handle, u, bonded, was):
    f, matrix = forces_and_tangent(handle, u, bonded, was, 0.0)
    exact = unrolled(matrix)

    def evaluated(p):
        if was == UNKNOWN:  # the search has put every node on its segment; here it is not repeated
            return forces(handle, p, bonded)
        return forces_and_tangent(handle, p, bonded, was, 0.0)[0]

    np.testing.assert_allclose(evaluated(u), f, rtol=1e-9, atol=1e-3)
    step = np.where(np.arange(u.size) % 5 == 4, 1e-8, 1e-5)
    difference = central_jacobian(evaluated, u, step)
    scale = np.sqrt(np.outer(np.abs(exact).max(axis=1), np.abs(exact).max(axis=0)))
    scale[scale == 0.0] = scale.max()  # nothing but round-off may stand there
    # round-off: positions of 1e3 mm keep 1e-13 mm, which over 1e-5 mm is 1e-8
    np.testing.assert_allclose(difference / scale, exact / scale, atol=1e-6)


@pytest.mark.parametrize("stage", STAGES)
def test_tangent_is_the_central_difference(stage):
    bring, slip, bonded = STAGES[stage]
    run = bring()
    check(run.rig.handle, nearby(run, slip), bonded, UNKNOWN)


@pytest.mark.parametrize(
    ("was", "slip", "motion"),
    [
        (BACKWARD, -SLIDE, HELD),
        (EXPECTED_BACKWARD, -SLIDE, BACKWARD),
        (EXPECTED_FORWARD, SLIDE, FORWARD),
    ],
    ids=["held", "expected backward", "expected forward"],
)
def test_tangent_of_frozen_motions_is_the_central_difference(was, slip, motion):
    """Nodes that are pushed back, and nodes whose friction points the other way than their trial force."""
    run = jacked(SMALL | STRAIGHT)
    check(run.rig.handle, nearby(run, slip), False, was)
    work = run.rig.case.work
    assert (work.motion[1:-1] == motion).all()
    assert work.held_back[0] == (work.motion == HELD).sum()


@pytest.mark.parametrize("stage", ["jacking, sliding", "cracked", "grouted"])
def test_damping_adds_its_share_of_the_uncracked_beam_to_the_tangent_alone(stage):
    bring, slip, bonded = STAGES[stage]
    run = bring()
    u, model = nearby(run, slip), run.rig.case.model
    f, plain = forces_and_tangent(run.rig.handle, u, bonded, UNKNOWN, 0.0)
    same, damped = forces_and_tangent(run.rig.handle, u, bonded, UNKNOWN, 0.3)
    np.testing.assert_allclose(same, f, rtol=1e-9, atol=1e-3)
    expected, flexure = np.zeros(2 * [u.size]), model.layer_area @ model.layer_y**2
    for e, length in enumerate(np.diff(model.x)):  # closed form, of the concrete layers
        at = 5 * e + 2
        q = np.concatenate([u[at : at + 3], u[at + 5 : at + 8]])
        B = central_jacobian(lambda q, length=length: np.array(chord(length, q))[[0, 4, 5]], q, 1e-6)
        D = np.zeros((3, 3))
        D[0, 0] = model.layer_area.sum() / length
        D[1:, 1:] = flexure / length * np.array([[4.0, 2.0], [2.0, 4.0]])
        place = np.r_[at : at + 3, at + 5 : at + 8]
        expected[np.ix_(place, place)] += 0.3 * model.concrete.E0 * B.T @ D @ B
    difference = unrolled(damped) - unrolled(plain)
    np.testing.assert_allclose(difference, expected, atol=1e-7 * np.abs(expected).max())


def test_the_cracked_stages_are_cracked():
    case = sustained(LOADED).rig.case
    assert case.state.concrete[:, 0].max() > 2.0 * case.model.concrete.eps_cr
