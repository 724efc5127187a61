"""The check of an accepted step by statics: silent on what is in equilibrium, and loud by the right amount on
what is not."""

import numpy as np
import pytest

from ptbatch.core.case import still
from ptbatch.core.contact import HELD
from ptbatch.core.equilibrium import along_tendon, imbalance
from ptbatch.core.history import rewind
from ptbatch.core.reference import Reference
from ptbatch.statics import node_values
from tests.members import KINDS, SMALL, sustained

any_member = pytest.mark.parametrize("values", KINDS.values(), ids=KINDS.keys())


class Loaded:
    """A member under its sustained load, and what statics says of displacements near those it has."""

    def __init__(self, values):
        self.run = sustained(values)
        self.case, self.handle = self.run.rig.case, self.run.rig.handle
        self.loads = self.run.setup.self_weight + self.run.setup.sustained
        self.bonded = self.run.setup.member.bond == "bonded"
        self.force = self.case.tolerance.force
        self.depth = self.run.setup.member.h

    def error(self, extra=0.0, dof=None, by=0.0, handle=None) -> float:
        """Imbalance with more load than there is, or with a displacement that is off [N]."""
        loads = self.loads + extra
        rewind(self.case.state, self.case.work)
        if dof is not None:
            self.case.work.trial[dof] += by
        target = still(loads, self.bonded)
        return self.force * imbalance(handle or self.handle, target, 0.0)

    def pull(self, node, component):
        """One newton, or newton millimetre, on a beam node."""
        extra = np.zeros_like(self.loads)
        extra[5 * node + 2 + component] = 1.0
        return extra


@any_member
def test_converged_states_balance(values):
    member = Loaded(values)
    history = member.case.history
    # 1e-9 of the force is what the iteration leaves at a node; statics adds the nodes up
    assert history.residual[: history.rows[0]].max() <= 1e-7
    assert member.error() <= 1e-9 * member.force


@any_member
@pytest.mark.parametrize("component", [0, 1])
def test_a_load_that_nothing_carries_is_found_to_the_newton(values, component):
    member = Loaded(values)
    x = member.run.setup.mesh.x
    error = member.error(1e3 * member.pull(len(x) - 2, component))
    lever = x[-1] - x[-2] if component == 1 else 0.0
    assert error == pytest.approx(1e3 * max(1.0, lever / member.depth), rel=1e-3)  # closed form


@any_member
def test_a_moment_that_nothing_carries_counts_by_the_depth(values):
    member = Loaded(values)
    error = member.error(1e6 * member.pull(3, 2))
    assert error == pytest.approx(1e6 / member.depth, rel=1e-4)  # closed form


def totals(member, loads) -> np.ndarray:
    """Slow and obvious: forces across and up, and moment about the right end, of all loads and reactions on
    the deflected member."""
    work, model = member.case.work, member.case.model
    nodes = len(model.x)
    u, f = member.case.state.u, work.f
    end = model.x[-1] + node_values(u, nodes, 0)[-1], node_values(u, nodes, 1)[-1]
    total = np.zeros(3)
    for k in range(nodes):
        at = range(5 * k + 2, 5 * k + 5)
        across, up, turn = (f[i] if model.held[i] else loads[i] for i in at)  # load and reaction where held
        x, y = model.x[k] + u[at[0]], u[at[1]]
        total += across, up, turn + (x - end[0]) * up - (y - end[1]) * across
    return total


@any_member
def test_loads_and_reactions_balance_by_hand(values):
    member = Loaded(values)
    member.error()
    across, up, turn = totals(member, member.loads)
    assert max(abs(across), abs(up), abs(turn) / member.depth) <= 1e-8 * member.force
    assert np.abs(member.case.work.f[member.case.model.held]).max() > 1e-3 * member.force


@any_member
def test_a_missing_load_is_what_the_reactions_miss_by_hand(values):
    member = Loaded(values)
    extra = -1e4 * member.pull(2, 1)  # far from the right end: what misses is a moment
    found = member.error(extra)
    across, up, turn = totals(member, member.loads + extra)
    assert found == pytest.approx(max(abs(across), abs(up), abs(turn) / member.depth), rel=1e-6)
    assert found > 1e4


@any_member
@pytest.mark.parametrize("dof", ["u", "v", "theta", "tendon along", "tendon across"])
def test_a_displacement_that_is_off_is_found_by_its_forces(values, dof):
    member = Loaded(values)
    node = len(member.run.setup.mesh.x) // 2 - 1
    i = 5 * node + ["tendon along", "tendon across", "u", "v", "theta"].index(dof)
    by = 1e-8 if dof == "theta" else 1e-5
    error = member.error(dof=i, by=by)
    missing = np.where(member.case.model.held, 0.0, member.loads - member.case.work.f)[2:-2]
    moments = np.abs(missing[2::5])
    forces = np.abs(np.delete(missing, np.s_[2::5]))
    # closed form: a node's force is the difference of two sections', a section's is the sum over the nodes
    lever = member.run.setup.member.total_length / member.depth
    assert error >= 0.499 * max(forces.max(), moments.max() / member.depth)
    assert error <= forces.sum() * (1.0 + lever) + moments.sum() / member.depth
    assert error >= 1e-6 * member.force  # what makes a step fail
    assert member.error(dof=i, by=2.0 * by) == pytest.approx(2.0 * error, rel=0.1)


def with_less_friction(member, share):
    """The same arrays under a friction coefficient that is smaller."""
    model = member.case.model
    contact = model.contact._replace(mu=share * model.contact.mu, K=0.0)
    return Reference(member.case._replace(model=model._replace(contact=contact)))


def sliding(member) -> tuple[np.ndarray, np.ndarray]:
    """Normal force and friction of the tendon nodes that slide."""
    work = member.case.work
    capacity = member.case.model.contact.mu * np.abs(work.normal[1:-1])
    slides = np.abs(work.shear[1:-1]) > 0.999 * capacity
    assert slides.sum() >= 2
    return np.abs(work.normal[1:-1][slides]), np.abs(work.shear[1:-1][slides])


SMOOTH = SMALL | dict(K=0.0, w_dead=20.0)


def test_friction_beyond_the_cone_is_found():
    """Closed form: by how much it is beyond, all else being in equilibrium."""
    member = Loaded(SMOOTH)
    member.error()
    normal, _ = sliding(member)
    lax, strict = member.handle, with_less_friction(member, 0.5)
    assert along_tendon(lax, False) <= 1e-9
    beyond = along_tendon(strict, False) * member.force
    assert beyond == pytest.approx(0.5 * SMOOTH["mu"] * normal.max(), rel=1e-3)
    assert along_tendon(strict, True) <= 1e-8  # in grout there is no cone


def test_friction_that_cannot_be_is_an_imbalance_of_its_node():
    """Closed form: with half the friction every sliding node lacks half of it."""
    member = Loaded(SMOOTH)
    member.error()
    lacking = 0.5 * sliding(member)[1].max()
    found = member.error(handle=with_less_friction(member, 0.5))
    assert lacking * 0.99 <= found <= 30.0 * lacking  # the beam feels the sum over the nodes


@any_member
def test_no_node_is_held_in_a_converged_step(values):
    """One that slid and was pushed back has come to rest, or slides the other way."""
    member = Loaded(values)
    work = member.case.work
    assert work.held_back[0] == 0 and not (work.motion == HELD).any()
