"""ACI 318-19, 24.5: closed forms in the units of the code."""

import pytest

from ptbatch.design.aci318 import PSI
from ptbatch.design.aci318 import service as aci


def test_limits():
    fc, fci = 5000 * PSI, 3600 * PSI
    assert aci.service_compression(fc, True) / PSI == pytest.approx(2250.0)
    assert aci.service_compression(fc, False) / PSI == pytest.approx(3000.0)
    assert aci.transfer_compression(fci, False) / PSI == pytest.approx(2160.0)
    assert aci.transfer_compression(fci, True) / PSI == pytest.approx(2520.0)
    assert aci.transfer_tension(fci, False) / PSI == pytest.approx(180.0)  # 3 sqrt(3600)
    assert aci.transfer_tension(fci, True) / PSI == pytest.approx(360.0)


@pytest.mark.parametrize(("psi", "kind"), [(-100, "U"), (530, "U"), (531, "T"), (848, "T"), (849, "C")])
def test_classes(psi, kind):
    assert aci.service_class(psi * PSI, 5000 * PSI) == kind  # 7.5 and 12 sqrt(5000) are 530.3 and 848.5
