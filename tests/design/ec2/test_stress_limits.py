"""Stress limits of the tendon: published by SOFiSTiK, DCE-EN17 (28.5 cm2 of Y1770 with fp0.1k 1520 MPa), to
the printed digits."""

import pytest

from ptbatch.design.ec2 import stress_limits

AP, FPK, FP01K = 2850.0, 1770.0, 1520.0


def test_while_tensioning():
    assert stress_limits.jacking(FPK, FP01K) * AP / 1e3 == pytest.approx(3898.8, abs=0.05)


def test_after_transfer():
    assert stress_limits.after_transfer(FPK, FP01K) * AP / 1e3 == pytest.approx(3682.2, abs=0.05)
