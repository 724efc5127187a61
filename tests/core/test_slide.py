"""The tendon alone, sliding along its duct while the beam stands still.

In a chain whose tensions grow with its nodes' distances, and whose friction grows with how far they slide,
one place of the nodes alone is in balance: what meets Coulomb's law at every node is the answer, however it
was found.
"""

import numba
import numpy as np
import pytest

from ptbatch.core.contact import UNKNOWN
from ptbatch.core.placement import find_paces, place_tendon, slide_tendon
from ptbatch.core.slide import slide, turns_round
from tests.members import KINDS, anchored

LOOSE = ["imaginary", "cracked", "fixed"]  # not grouted
NODES = dict(elements=24)


@numba.njit  # not cached: it would outlive the kernels that it calls
def place(case, u):
    place_tendon(case.model, case.state, u, case.work)


@numba.njit
def find_slide(case, u):
    """Of nodes that all count as changed."""
    case.work.motion[:] = UNKNOWN
    if not turns_round(case.model, case.state, case.work):
        return False
    find_paces(case.model, u, case.work)
    return slide(case.model, case.state, case.work)


@numba.njit
def slide_on(case, u):
    case.work.motion[:] = UNKNOWN
    slide_tendon(case.model, case.state, u, case.work)


def disturbed(run, size, seed):
    """Committed displacements with the beam's and the tendon's moved at random, the anchors' kept."""
    u, n = run.rig.case.state.u.copy(), len(run.setup.mesh.x) - 1
    rng = np.random.default_rng(seed)
    x = np.linspace(0.0, np.pi, n + 1)
    for harmonic in (1, 2, 3):
        u[3::5][: n + 1] += size * rng.standard_normal() * np.sin(harmonic * x)
        u[5:-2:5] += 0.1 * size * rng.standard_normal() * np.sin(harmonic * x[1:])
    u[5:-2:5] += 0.01 * size * rng.standard_normal(n)
    return u


def chain(case):
    """At the inner nodes, moved on by work.ahead: what their friction lacks to balance the tensions, the
    friction, the most that it can be, and the tensions of all elements [N]; friction of a kink by its half
    angle, see docs/theory.md, which the chords' bisector turns into cosine and sine."""
    work, c, state = case.work, case.model.contact, case.state
    T, lacking, friction, most = work.T.copy(), [], [], []
    n = len(T) - 1
    bisectors = work.chord[:-1] + work.chord[1:]
    bisectors /= np.linalg.norm(bisectors, axis=1)[:, None]
    for j in range(1, n + 1):
        T[j - 1] += work.slope[j - 1] * work.ahead[j] * (work.chord[j - 1] @ bisectors[j - 1])
        T[j] -= work.slope[j] * work.ahead[j] * (work.chord[j] @ bisectors[j - 1])
    for j in range(1, n + 1):
        cosine = work.chord[j] @ bisectors[j - 1]
        sine = np.sqrt(max(0.0, 1.0 - cosine**2))
        capacity = (c.mu * sine + 0.5 * work.rough[j]) * (T[j - 1] + T[j])
        trial = state.rub[j] + c.tangential * (work.s[j] + work.pace[j] * work.ahead[j] - state.s[j])
        friction.append(np.clip(trial, -capacity, capacity))
        lacking.append((T[j] - T[j - 1]) * cosine - friction[-1])
        most.append(capacity)
    return np.abs(lacking), np.array(friction), np.array(most), T


def out_of_balance(run, u):
    """The same as the tendon lies at u: what is lacking most."""
    place(run.rig.handle, u)
    run.rig.case.work.ahead[:] = 0.0
    return chain(run.rig.case)[0].max()


@pytest.mark.parametrize("size", [0.1, 1.0, 10.0])
@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("kind", LOOSE)
def test_every_node_comes_to_balance_by_coulombs_law(kind, seed, size):
    run = anchored(KINDS[kind] | NODES)
    u, force = disturbed(run, size, seed), run.rig.case.tolerance.force
    assert out_of_balance(run, u) > 1e-4 * force
    assert find_slide(run.rig.handle, u)
    lacking, _, _, T = chain(run.rig.case)
    assert (T > 0.0).all()
    # sticking nodes hold by a spring so stiff that round-off of a place is a force
    assert lacking.max() < 1e-8 * force


def test_all_senses_of_sliding_are_met():
    run = anchored(KINDS["imaginary"] | NODES)
    senses = set()
    for seed in range(8):
        u = disturbed(run, 1.0, seed)
        place(run.rig.handle, u)
        assert find_slide(run.rig.handle, u)
        _, friction, most, _ = chain(run.rig.case)
        senses |= set(np.where(np.abs(friction) < most, 0.0, np.sign(friction)))
    assert senses == {-1.0, 0.0, 1.0}


def test_without_friction_the_tension_becomes_the_same_all_along():
    run = anchored(KINDS["imaginary"] | NODES | dict(mu=0.0, K=0.0))
    u = disturbed(run, 5.0, 0)
    assert out_of_balance(run, u) > 1e-3 * run.rig.case.tolerance.force
    assert find_slide(run.rig.handle, u)
    T = chain(run.rig.case)[3]
    np.testing.assert_allclose(T, T.mean(), rtol=1e-9)


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize(("kind", "left"), [("cracked", 1e-4), ("fixed", 1e-4), ("imaginary", 0.15)])
def test_the_tendon_lies_nearer_to_balance_where_it_was_moved_to(kind, left, seed):
    """All but in balance: in the duct as it is, tensions are not quite linear in what the nodes move, and the
    imaginary beam's turns most. A second time leaves next to nothing. left: of what was lacking, at most."""
    run = anchored(KINDS[kind] | NODES)
    u = disturbed(run, 0.5, seed)
    before = out_of_balance(run, u)
    slide_on(run.rig.handle, u)
    assert out_of_balance(run, u) < left * before
    slide_on(run.rig.handle, u)
    assert out_of_balance(run, u) < 1e-4 * before


@pytest.mark.parametrize("kind", LOOSE)
def test_pace_is_the_way_along_the_duct_at_rest(kind):
    """By a difference quotient. It is not one, for the beam is pressed and bent."""
    run = anchored(KINDS[kind] | NODES)
    u, work = disturbed(run, 1.0, 1), run.rig.case.work
    place(run.rig.handle, u)
    find_slide(run.rig.handle, u)
    pace, axis, small = work.pace[1:-1].copy(), work.axis[1:-1].copy(), 1e-4
    s = []
    for sign in (1.0, -1.0):
        moved = u.copy()
        moved[5:-2:5] += sign * small * axis[:, 0]
        moved[6:-2:5] += sign * small * axis[:, 1]
        place(run.rig.handle, moved)
        s.append(work.s[1:-1].copy())
    np.testing.assert_allclose(pace, (s[0] - s[1]) / (2.0 * small), rtol=1e-7)
    assert np.abs(pace - 1.0).max() > 1e-5


def test_beam_and_anchors_stand_still():
    run = anchored(KINDS["imaginary"] | NODES)
    u = disturbed(run, 5.0, 0)
    place(run.rig.handle, u)
    moved = u.copy()
    slide_on(run.rig.handle, moved)
    nodes = np.zeros(u.size, bool)
    nodes[5:-2:5] = nodes[6:-2:5] = True  # of the tendon, between the anchors
    assert (moved[~nodes] == u[~nodes]).all()
    assert (moved[5:-2:5] != u[5:-2:5]).any()


@pytest.mark.parametrize("kind", LOOSE)
def test_a_tendon_in_balance_stays(kind):
    run = anchored(KINDS[kind] | NODES)
    u = run.rig.case.state.u.copy()
    place(run.rig.handle, u)
    assert not find_slide(run.rig.handle, u)


def test_a_slack_tendon_is_left_alone():
    """Friction of a tendon in compression is nothing that the chain knows."""
    run = anchored(KINDS["imaginary"] | NODES)
    u = run.rig.case.state.u.copy()
    u[2] += 400.0  # the beam's ends, and with them the anchors, far nearer to each other
    place(run.rig.handle, u)
    assert run.rig.case.work.T.sum() < 0.0
    assert not find_slide(run.rig.handle, u)
