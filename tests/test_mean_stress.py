"""A member given by the mean stress after anchoring, `fpe`, in place of the jacking stress."""

import pytest

from ptbatch import analysis
from ptbatch.analysis import FPE_TOLERANCE, analyse
from ptbatch.member import Member
from tests.members import KINDS, SMALL, TWENTY

MEMBERS = {
    "small": SMALL,
    "no set": SMALL | {"set": 0.0},
    "no friction": SMALL | {"mu": 0.0, "K": 0.0},
    "two jacks": SMALL | {"jack": "both"},
    "long": TWENTY | {"set": 12.0, "Ec": 35000},
    "fixed": KINDS["fixed"],
}
any_member = pytest.mark.parametrize("values", MEMBERS.values(), ids=MEMBERS.keys())


@any_member
@pytest.mark.parametrize("fpe", [700.0, 1150.0])
def test_the_mean_stress_is_met(values, fpe):
    """Closed form: what is asked for, as near as the search is to come."""
    response = analyse(Member(**values | {"fpj": None, "fpe": fpe}))
    assert response.tendon["anchored"].mean == pytest.approx(fpe, rel=FPE_TOLERANCE)


@any_member
def test_a_member_jacked_to_the_stress_found_is_the_same(values):
    found = analyse(Member(**values | {"fpj": None, "fpe": 1100.0}))
    jacked = analyse(Member(**values | {"fpj": found.fpj}))
    assert jacked.tendon["anchored"].mean == pytest.approx(1100.0, rel=FPE_TOLERANCE)


@any_member
def test_the_second_stressing_is_all_but_right(monkeypatch, values):
    """But for the set, which takes the same from any, the mean stress is all but proportional to the jacking
    stress: the secant starts where the set takes all of it. From the origin it would miss by several per
    cent; what is left here, 0.3 % at most, is the second order of the elastic member."""
    missed = []
    stress = analysis.stress

    def watched(run):
        stress(run)
        missed.append(abs(run.rig.mean_stress - 1100.0))

    monkeypatch.setattr(analysis, "stress", watched)
    analyse(Member(**values | {"fpj": None, "fpe": 1100.0}))
    assert 2 <= len(missed) <= 3
    assert missed[1] <= 0.005 * missed[0] + 1e-6
