"""ACI 318-19: published examples and the tables' own marks."""

import pytest

from ptbatch.design.aci318 import PSI
from ptbatch.design.aci318 import tendon_stress as fps
from ptbatch.design.aci318.flexure import beta1, block, least_bonded_steel, modulus_of_rupture, phi
from ptbatch.design.aci318.stress_limits import at_anchorages, jacking
from ptbatch.design.flexure import Steel, constant, elastic_plastic, strength

IN, KSI, KIP_FT = 25.4, 1000.0 * PSI, 1000.0 * PSI * 25.4**2 * 304.8


def test_one_way_slab_with_unbonded_tendons():
    """Verification case: b 96, h 6 in, fc 6 ksi, As 1.20 in2 at 4.5 in, Aps 0.612 at 5.0, fse 170, 25 ft."""
    b, h, fc, Aps, dp = 96 * IN, 6 * IN, 6 * KSI, 0.612 * IN**2, 5 * IN
    fse, fpy = 170 * KSI, 0.9 * 270 * KSI
    stress = fps.unbonded(fse, fc, Aps / (b * dp), fpy, 25 * 12 / 6)
    assert stress / KSI == pytest.approx(195.686, abs=5e-4)  # published, as all of this case
    bars = Steel(4.5 * IN, 1.20 * IN**2, elastic_plastic(29_000 * KSI, 60 * KSI))
    found = strength([(h, b)], block(fc), [bars, Steel(dp, Aps, constant(stress))])
    assert found.c / IN == pytest.approx(0.5222, abs=5e-5)
    assert found.moment / KIP_FT == pytest.approx(73.771, abs=5e-4)
    assert phi(found.deepest_strain) == 0.90
    assert least_bonded_steel(0.5 * h * b) / IN**2 == pytest.approx(1.152, abs=5e-4)


def test_one_way_strip_of_csi():
    """CSI SAFE PT-SL 001, ACI: b 36, h 10, d 9 in, L 32 ft, fc 4 ksi, 2 x 0.153 in2, fse 175.5 ksi: fps
    199.62 ksi, As 2.20 in2 for Mu 1428.5 k-in."""
    b, fc, Aps, d = 36 * IN, 4 * KSI, 0.306 * IN**2, 9 * IN
    stress = fps.unbonded(175.5 * KSI, fc, Aps / (b * d), 0.9 * 270 * KSI, 32 * 12 / 10)
    assert stress / KSI == pytest.approx(199.62, abs=5e-3)  # published
    bars = Steel(d, 2.20 * IN**2, elastic_plastic(29_000 * KSI, 60 * KSI))
    found = strength([(10 * IN, b)], block(fc), [bars, Steel(d, Aps, constant(stress))])
    # the printed area is rounded to 0.01 in2 of 2.20, which bears two thirds of the moment
    assert 0.9 * found.moment / (KSI * IN**3) == pytest.approx(1428.5, rel=0.004)


@pytest.mark.parametrize(
    ("psi", "beta"), [(3000, 0.85), (4000, 0.85), (5000, 0.80), (6000, 0.75), (8000, 0.65), (9000, 0.65)]
)
def test_beta1(psi, beta):
    assert beta1(psi * PSI) == pytest.approx(beta, rel=1e-12)  # closed form: table 22.2.2.4.3


@pytest.mark.parametrize(
    ("strain", "factor"), [(0.001, 0.65), (0.002, 0.65), (0.0035, 0.775), (0.005, 0.90), (0.02, 0.90)]
)
def test_phi(strain, factor):
    assert phi(strain) == pytest.approx(factor, rel=1e-12)  # closed form: table 21.2.2


def test_modulus_of_rupture():
    assert modulus_of_rupture(5000 * PSI) / PSI == pytest.approx(
        530.33, abs=5e-3
    )  # closed form: 7.5 sqrt(5000)


def test_stress_limits():
    """Grade 270 low relaxation, closed form: 0.94 (0.9) 270 = 228.4 is above 0.80 (270) = 216 ksi."""
    assert jacking(270.0, 243.0) == pytest.approx(216.0)
    assert jacking(270.0, 0.85 * 270.0) == pytest.approx(0.94 * 0.85 * 270.0)
    assert at_anchorages(270.0) == pytest.approx(189.0)


@pytest.mark.parametrize(
    ("fse", "rho", "slender", "expected"),
    [
        (150, 0.0015, 20, 150 + 10 + 6 / 0.15),  # fc / (100 rho)
        (150, 0.0005, 20, 150 + 60),  # 60 ksi at most
        (150, 0.0015, 40, 150 + 10 + 6 / 0.45),
        (150, 0.0005, 40, 150 + 30),
        (200, 0.0005, 20, 243),  # fpy
    ],
)
def test_unbonded_tendons(fse, rho, slender, expected):
    found = fps.unbonded(fse * KSI, 6 * KSI, rho, 243 * KSI, slender)
    assert found / KSI == pytest.approx(expected, rel=1e-12)  # closed form: table 20.3.2.4.1


def test_bonded_tendons():
    """Closed form: 270 (1 - 0.28 / 0.80 (0.00425 * 270 / 5))."""
    found = fps.bonded(270.0, 243.0, 5.0, 0.80, 0.00425, 1.0, 0.0, 0.0, 0.0)
    assert found == pytest.approx(270 * (1 - 0.28 / 0.80 * 0.00425 * 54), rel=1e-12)
    helped = fps.bonded(
        270.0, 243.0, 5.0, 0.80, 0.001, 1.0, 0.0, 0.05, 0.1
    )  # compression bars: at least 0.17
    assert helped == pytest.approx(270 * (1 - 0.28 / 0.80 * 0.17), rel=1e-12)
    assert fps.gamma_p(0.86, 1.0) == 0.40 and fps.gamma_p(0.80, 1.0) == 0.55
    assert fps.applies(135.0, 270.0) and not fps.applies(134.9, 270.0)
