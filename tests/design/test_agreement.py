"""Analysis and codes agree where they must, and a whole published design: a one-way strip of CSI SAFE (PT-SL
001, ACI)."""

import numpy as np
import pytest

from ptbatch import stages
from ptbatch.analysis import jacking_stress, prepare, stress
from ptbatch.design.aci318 import PSI
from ptbatch.design.stresses import fibres
from ptbatch.design.subject import Subject
from ptbatch.events import gauss_places, section_strains
from ptbatch.geometry.profile import ideal_profile
from ptbatch.member import Member
from ptbatch.model.arrays import set_up
from ptbatch.statics import section_moments
from tests.design.test_checks import LIGHT, made

IN, LB, KSI = 25.4, 4.4482216152605, 1000 * PSI
KSF_FT = 1000 * LB / (12 * IN)  # of a strip: kip/ft in N/mm
STRIP = dict(
    kind="slab", span=32 * 12 * IN, b=36 * IN, h=10 * IN, fc=4 * KSI, Aps=2 * 0.153 * IN**2,
    dp=(5 * IN, 9 * IN, 5 * IN), fpu=270 * KSI, fpe=189 * KSI, set=0, mu=0, K=0, self_weight=False,
    w_dead=0.375 * KSF_FT, w_live=0.300 * KSF_FT, long_term_loss=13.5 * KSI, fci=3 * KSI,
    As=2.20 * IN**2, ds=9 * IN, fy=60 * KSI, elements=8, layers=12,
)  # fmt: skip


def test_the_strip_of_csi_safe():
    """Published: Mu 1428.5 k-in, fps 199.62 ksi, As 2.20 in2 for that; stresses at midspan in ksi, top and
    bottom, to the printed digits."""
    member, response, found = made(STRIP)
    bending = found["bending, sagging"]
    assert bending.demand * 1e6 / (1000 * LB * IN) == pytest.approx(1428.5, abs=0.1)
    assert bending.utilisation == pytest.approx(1.0, abs=0.005)
    numbers = {value.symbol: value.value for value in bending.values}
    assert numbers["fps"] / KSI == pytest.approx(199.62, abs=0.02)
    about = Subject(member, response)
    moments = about.moments
    half = len(moments.x) // 2
    for loss, share, top, bottom in (
        (0.0, None, -0.735, 0.414),
        (13.5, 1.0, -1.519, 1.221),
        (13.5, 0.5, -1.135, 0.837),
    ):
        outer = moments.dead + (share or 0.0) * moments.live
        stresses = fibres(about, outer, loss * KSI)
        assert stresses.top[half] / KSI == pytest.approx(top, abs=1e-3)
        assert stresses.bottom[half] / KSI == pytest.approx(bottom, abs=1e-3)


def test_stresses_of_the_analysis_are_those_of_beam_theory():
    """P/A + M/S with the analysis' own tendon force and moments, uncracked and elastic, within 1 % of the
    largest stress."""
    member = Member(member="B", **LIGHT | dict(concrete_law="elastic", As=0, ds=0, elements=20, layers=60))
    run = prepare(set_up(member), jacking_stress(set_up(member)))
    stress(run)
    history = run.rig.case.history
    row = int(np.flatnonzero(history.stage[: history.rows[0]] == stages.ANCHORING)[-1])
    mesh, model = run.setup.mesh, run.rig.case.model
    (eps0, kappa), place = section_strains(mesh.x, history.u[row][None]), gauss_places(mesh.x)
    M = section_moments(mesh.x, history.u[row], history.f[row])
    T = np.interp(place, mesh.x, history.T[row])
    e = ideal_profile(member).depth(place) - 300.0
    area, inertia = 300 * 600, 300 * 600**3 / 12
    inside = slice(3, -3)  # at the anchors the force comes in at a node
    faces = np.array([[[model.top]], [[model.bottom]]]), np.array([[[-300.0]], [[300.0]]])
    by_analysis = (member.Ec * (eps0 - faces[0] * kappa))[:, inside]
    by_hand = (-T / area + (M - T * e) * faces[1] / inertia)[:, inside]
    assert np.abs(by_analysis - by_hand).max() <= 0.01 * np.abs(by_hand).max()


@pytest.mark.parametrize(
    "change", [{}, {"h": 750, "dp": (375, 650, 375), "ds": 700}, {"Aps": 400}, {"fc": 55}]
)
def test_fps_of_the_analysis_is_above_or_near_the_code_on_simple_spans(change):
    """Near: 5 % of the stress."""
    _, response, found = made(LIGHT | {"deflection_limit": 150} | change)
    numbers = {value.symbol: value.value for value in found["strength, two views"].values}
    assert numbers["fps, analysis"] >= 0.95 * numbers["fps, code"]
