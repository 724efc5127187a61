"""Bars: bilinear, kinematic hardening, rupture."""

import numpy as np
import pytest

from ptbatch.core.steel import Steel, commit_steel, steel_stress
from tests.core.numerics import central_slope, complex_slope

ES, FY, HARDENING, ESU = 200000.0, 420.0, 0.01, 0.05
STEEL = Steel(ES, HARDENING, ESU)
EPS_Y = FY / ES


def stress(eps, eps_p=0.0):
    return steel_stress(eps, eps_p, FY, STEEL)


def test_first_loading():  # closed form
    assert stress(0.5 * EPS_Y) == pytest.approx(0.5 * FY)
    assert stress(EPS_Y) == pytest.approx(FY)
    assert stress(0.01) == pytest.approx(FY + HARDENING * ES * (0.01 - EPS_Y), rel=1e-12)
    assert stress(-0.01) == -stress(0.01)


@pytest.mark.parametrize("eps_p", [0.0, 0.004, -0.002])
@pytest.mark.parametrize("eps", [-0.012, -0.0011, 0.0007, 0.0015, 0.009])
def test_tangent_is_the_derivative(eps, eps_p):
    slope = complex_slope(lambda e: stress(e, eps_p), eps)
    # rounding of 500 MPa over 2e-8 is 5e-6 MPa
    assert slope == pytest.approx(central_slope(lambda e: stress(e, eps_p), eps, 1e-8), rel=1e-6)
    assert slope == pytest.approx(ES) or slope == pytest.approx(HARDENING * ES)  # closed form


def test_continuity():
    eps = np.linspace(-0.02, 0.02, 40001)
    jump = np.abs(np.diff([stress(e, 0.003) for e in eps])).max()
    assert jump <= 1.001 * ES * (eps[1] - eps[0])


def test_unloading_runs_at_the_modulus_and_yields_after_twice_fy():
    eps_p = commit_steel(0.01, 0.0, FY, STEEL)
    top = stress(0.01)
    assert stress(0.01, eps_p) == pytest.approx(top, rel=1e-12)
    assert stress(0.01 - 1.9 * EPS_Y, eps_p) == pytest.approx(top - 1.9 * FY, rel=1e-12)  # closed form
    # closed form: kinematic, the elastic range stays 2 fy wide, then the slope is that of hardening
    assert stress(0.01 - 3 * EPS_Y, eps_p) == pytest.approx(top - 2 * FY - HARDENING * FY, rel=1e-12)


def test_a_ratchet_of_steps_ends_where_one_step_does():
    eps_p = 0.0
    for eps in np.linspace(0.0, 0.02, 37):
        eps_p = commit_steel(eps, eps_p, FY, STEEL)
    assert eps_p == pytest.approx(commit_steel(0.02, 0.0, FY, STEEL), rel=1e-12)


@pytest.mark.parametrize("eps", [1.001 * ESU, -1.001 * ESU])
def test_rupture_is_for_good(eps):
    # what a ruptured bar carries is asked of the section, see test_beam
    gone = commit_steel(eps, 0.0, FY, STEEL)
    assert np.isnan(gone) and np.isnan(commit_steel(0.0, gone, FY, STEEL))
    assert not np.isnan(commit_steel(0.999 * eps / 1.001, 0.0, FY, STEEL))
