"""Cracks from the recorded displacements."""

import numpy as np
import pytest

from ptbatch.analysis import analyse, prepare, serve, stress
from ptbatch.cracks import CHUNK, cracks_at
from ptbatch.events import Recorded, section_strains
from ptbatch.geometry.section import gross_section
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from ptbatch.postprocess import recorded
from tests.members import SMALL

THIRDS = SMALL | dict(live="third-points", self_weight=False, dp=(250, 300, 250))


def bent(values, *curvatures):
    """Steps of constant curvatures as recorded, and the thickness of the layers."""
    setup = set_up(Member(**values))
    model, x = prepare(setup, 1200.0).rig.case.model, setup.mesh.x
    u = np.zeros((len(curvatures), 5 * len(x) + 2))
    for row, kappa in zip(u, curvatures, strict=True):
        row[3::5] = 0.5 * kappa * x * (x - x[-1])
        row[4::5] = kappa * (x - 0.5 * x[-1])
    rows, free = len(u), np.zeros((len(x) - 1, 2, len(model.layer_y)))
    strains = section_strains(x, u)
    steps = Recorded(model, *strains, np.zeros((rows, len(x))), np.zeros(rows), np.zeros(rows, bool), free)
    return steps, gross_section(setup.member).thickness


def test_depth_of_cracks_in_pure_bending():
    """Closed form: cracked where (depth - centroid) kappa > ft / Ec, at mid-layer."""
    kappa = 1e-6
    steps, thickness = bent(SMALL, kappa, 0.0, -kappa)
    sagging, after, both = cracks_at(steps, [0, 1, 2], thickness)
    layers = np.arange(12) * 500 / 12 + 500 / 24
    top = 500 / 12 * np.flatnonzero((layers - 250) * kappa > steps.model.concrete.eps_cr)[0]
    assert len(sagging) == 2 * (len(steps.model.x) - 1)
    assert {(round(c.top, 6), round(c.bottom, 6)) for c in sagging} == {(round(top, 6), 500.0)}
    assert after == sagging  # a crack stays
    assert len(both) == 2 * len(sagging)
    assert min(c.top for c in both) == 0.0
    assert max(c.bottom for c in both if c.top == 0.0) == pytest.approx(500 - top)


def test_laws_without_cracks_and_without_tension():
    kappa = 1e-9  # a strain of 2.5e-7 at the most
    steps, thickness = bent(SMALL, kappa)
    assert cracks_at(steps, [0], thickness) == [()]
    steps, thickness = bent(SMALL | dict(concrete_law="elastic"), 1.0e-5)
    assert cracks_at(steps, [0], thickness) == [()]
    steps, thickness = bent(SMALL | dict(tension_law="none"), kappa)
    assert all(c.top == pytest.approx(250.0) for c in cracks_at(steps, [0], thickness)[0])


@pytest.mark.parametrize("aged", [0, CHUNK - 7, 3 * CHUNK + 5])
def test_steps_are_taken_in_any_number_of_chunks(aged):
    """aged: how many of the last steps come after the concrete has crept, by nothing here."""
    curvatures = 1e-6 * np.sin(np.arange(3 * CHUNK + 5))
    steps, thickness = bent(SMALL, *curvatures)
    alone = cracks_at(steps, [CHUNK, 3 * CHUNK], thickness)
    steps.aged[len(curvatures) - aged :] = True
    whole = cracks_at(steps, [CHUNK, 3 * CHUNK], thickness)
    each = cracks_at(steps, list(range(3 * CHUNK + 1)), thickness)
    assert whole == [each[CHUNK], each[3 * CHUNK]] == alone


@pytest.mark.parametrize("stretch", [0.0, 2e-4, -1e-4])
def test_heights_of_cracks_are_those_of_the_layers(stretch):
    """Bent and stretched either way, little and much: by height as layer by layer."""
    rng = np.random.default_rng(7)
    steps, thickness = bent(SMALL, *np.append(rng.normal(0.0, 3e-7, 40), 0.0))
    steps.eps0[:] += stretch * rng.uniform(size=steps.eps0.shape)
    by_height = cracks_at(steps, [10, 40], thickness)
    steps.aged[:] = True  # by nothing
    assert by_height == cracks_at(steps, [10, 40], thickness)


def test_simple_beam_cracks_from_the_bottom_and_in_the_middle_third_first():
    setup = set_up(Member(**THIRDS))
    run = prepare(setup, setup.member.fpj)
    stress(run)
    serve(run, 4)  # small steps: the first crack is seen alone
    rows = int(run.rig.case.history.rows[0])
    found = cracks_at(recorded(run, slice(rows)), list(range(rows)), gross_section(setup.member).thickness)
    first = next(cracks for cracks in found if cracks)
    assert all(2000.0 < crack.x < 4000.0 for crack in first)
    assert all(crack.bottom == pytest.approx(500.0) for crack in found[-1])
    assert len(found[-1]) > len(first)


def test_states_of_a_response():
    response = analyse(Member(**THIRDS))
    assert list(response.cracks) == [
        stage for stage in ("anchored", "peak", "end") if stage in response.tendon
    ]
    assert response.cracks["anchored"] == ()
    failure = response.event(response.failure)
    assert 2000.0 < failure.place < 4000.0  # concrete crushes where the moment is largest
