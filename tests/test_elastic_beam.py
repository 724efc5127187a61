"""The elastic member against beam theory, and tendon and beam in one configuration."""

import numpy as np
import pytest

from ptbatch import stages
from ptbatch.analysis import analyse
from ptbatch.member import Member
from tests.members import ELASTIC, IMAGINARY, anchored, last_row

B, H, L, E, LAYERS = 300.0, 400.0, 10000.0, 30000.0, 100
I = B * H**3 / 12.0 * (1.0 - 1.0 / LAYERS**2)  # closed form, of the layers' centres  # noqa: E741
EULER = np.pi**2 * E * I / L**2
PLAIN = ELASTIC | dict(
    member="plain", span=L, b=B, h=H, fc=30, Ec=E, layers=LAYERS, Aps=1000, Ep=195000, profile="straight",
    dp=H / 2, mu=0, K=0, set=0, deflection_limit=1.0,
)  # fmt: skip


def stiffness(**values) -> float:
    """Load over deflection at the end of the curve [N/mm]."""
    curve = analyse(Member(**PLAIN | values)).curve
    return float(curve.load[-1] / curve.deflection[-1])


@pytest.mark.parametrize(("share", "tolerance"), [(0.1, 1e-3), (3.0, 0.02)])
def test_a_concentric_tendon_leaves_the_lateral_stiffness_alone(share, tolerance):
    """Closed form; the tolerances are the issue's: the member shortens under P, which is part of it."""
    k = stiffness(fpj=share * EULER / 1e4, Aps=1e4, live="midspan")
    assert k == pytest.approx(48.0 * E * I / L**3, rel=tolerance)


def test_an_eccentric_tendon_cambers_the_member():
    """Closed form P e L^2 / (8 EI), small force."""
    P, e = 1e4, 100.0
    camber = analyse(Member(**PLAIN | dict(fpj=P / 1000.0, dp=H / 2 + e))).camber
    assert camber == pytest.approx(P * e * L**2 / (8.0 * E * I), rel=1e-3)


@pytest.mark.parametrize(
    ("supports", "live", "factor"),
    [  # closed form: deflection at the control point = total load * L^3 / (factor * EI)
        (("pin", "roller"), "uniform", 384.0 / 5.0),
        (("pin", "roller"), "midspan", 48.0),
        (("pin", "roller"), "third-points", 1296.0 / 23.0),
        (("fixed", "fixed"), "midspan", 192.0),
        (("fixed", "fixed"), "uniform", 384.0),
        (("fixed", "free"), "uniform", 8.0),
        (("free", "fixed"), "uniform", 8.0),
    ],
)
def test_elastic_deflection(supports, live, factor):
    """Closed form; a slack tendon (1 MPa) and a small deflection keep it linear to 1e-3."""
    k = stiffness(support_left=supports[0], support_right=supports[1], live=live, fpj=1.0, Aps=10.0)
    assert k == pytest.approx(factor * E * I / L**3, rel=1e-3)


def test_two_spans_deflect_where_beam_theory_says():
    """Closed form, both spans loaded: v_max = w L^4 / (184.6 EI) at 0.4215 L from an end."""
    run = anchored(PLAIN | dict(span=(L, L), dp=H / 2, fpj=1.0, Aps=10.0))
    control = run.setup.mesh.x[run.setup.mesh.control]
    assert min(control, 2 * L - control) == pytest.approx(0.4215 * L, abs=0.01 * L)
    k = stiffness(span=(L, L), fpj=1.0, Aps=10.0)
    assert k == pytest.approx(2.0 * 184.6 * E * I / L**3, rel=2e-3)  # the 184.6 is rounded


def test_gauge_force_stands_whatever_the_concrete_shortens():
    """code_aster SSNP108 (published), jacked until the gauge reads 200 kN: 200.000 kN, -0.166667 MPa."""
    prism = ELASTIC | dict(
        member="SSNP108", span=2000, b=1000, h=1200, fc=30, Ec=30000, Aps=150, Ep=210000, fpu=1860,
        profile="straight", dp=600, fpj=200e3 / 150, mu=0, K=0, set=0,
    )  # fmt: skip
    run = anchored(prism)
    history = run.rig.case.history
    last = history.rows[0] - 1
    assert history.T[last] == pytest.approx(200e3, rel=1e-7)
    shortening = -history.u[last, 5 * 20 + 2]
    assert -30000.0 * shortening / 2000.0 == pytest.approx(-0.166667, abs=1e-6)


def test_one_stage_ends_where_the_next_begins():
    """Anchoring moves nothing."""

    run = anchored(IMAGINARY)
    history = run.rig.case.history
    before, after = (last_row(run, stage) for stage in (stages.SETTING, stages.ANCHORING))
    assert np.abs(history.u[after] - history.u[before]).max() < 1e-6
    assert history.T[after] == pytest.approx(history.T[before], rel=1e-8)
