"""Tendon steel at marked points, its tangent, and unloading at Ep."""

import numpy as np
import pytest

from ptbatch.core.tendon import envelope, tendon_stress
from ptbatch.member import Member
from ptbatch.model.materials import strand
from tests.core.numerics import central_slope, complex_slope

LAWS = ("ramberg-osgood", "bilinear", "elastic")
any_law = pytest.mark.parametrize("tendon_law", LAWS)


def steel(tendon_law="ramberg-osgood", **more):
    values = dict(member="T", span=8000, b=300, h=600, fc=40, Aps=100, dp=(300, 500, 300), fpj=1000)
    return strand(Member(**values | dict(tendon_law=tendon_law) | more))


@pytest.mark.parametrize(
    ("fpu", "fpy", "Ep"),
    [(1860, 1674, 195000), (1860, 1581, 195000), (1790, 1465, 205000)],
    ids=["low relaxation", "stress-relieved", "wire"],
)
def test_ramberg_osgood_passes_the_points_of_the_standard(fpu, fpy, Ep):
    s = steel(fpu=fpu, fpy=fpy, Ep=Ep)
    assert envelope(0.01, s.law, s) == pytest.approx(fpy, rel=1e-9)  # published: ASTM A416, 1 % strain
    assert envelope(0.035, s.law, s) == pytest.approx(
        fpu, rel=1e-3
    )  # closed form up to (knee / Ep epu)^R / R
    assert complex_slope(lambda e: envelope(e, s.law, s), 1e-4) == pytest.approx(Ep, rel=1e-6)  # closed form


def test_bilinear_at_marked_points():  # closed form
    s = steel("bilinear", fpu=1860, fpy=1600, Ep=200000, epu=0.04)
    assert envelope(0.004, s.law, s) == pytest.approx(800)
    assert envelope(0.008, s.law, s) == pytest.approx(1600)
    assert envelope(0.024, s.law, s) == pytest.approx(1730)  # half way
    assert envelope(0.04, s.law, s) == pytest.approx(1860)


@any_law
@pytest.mark.parametrize("eps", [-0.001, 0.003, 0.0075, 0.011, 0.03])
@pytest.mark.parametrize("worst", [0.0, 0.02])
def test_tangent_is_the_derivative(tendon_law, eps, worst):
    s = steel(tendon_law)
    slope = complex_slope(lambda e: tendon_stress(e, worst, s.law, s), eps)
    # rounding of 2000 MPa over 2e-7 is 2e-6 MPa; the curve's own third derivative adds 1e-5
    assert slope == pytest.approx(
        central_slope(lambda e: tendon_stress(e, worst, s.law, s), eps, 1e-7), rel=1e-6
    )


@any_law
def test_continuity(tendon_law):
    s = steel(tendon_law)
    eps = np.linspace(-0.001, 0.04, 41001)
    for worst in (0.0, 0.015):
        jump = np.abs(np.diff([tendon_stress(e, worst, s.law, s) for e in eps])).max()
        assert jump <= 1.001 * s.Ep * (eps[1] - eps[0])


@any_law
def test_unloads_and_reloads_at_the_modulus(tendon_law):
    s = steel(tendon_law)
    top = envelope(0.02, s.law, s)
    assert tendon_stress(0.017, 0.02, s.law, s) == pytest.approx(top - 0.003 * s.Ep, rel=1e-12)  # closed form
    assert tendon_stress(0.02, 0.02, s.law, s) == top
    assert tendon_stress(0.021, 0.02, s.law, s) == envelope(0.021, s.law, s)
