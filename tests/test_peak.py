"""All that is told of the peak is told of one and the same state, which may lie between two steps."""

import numpy as np
import pytest

from ptbatch.analysis import analyse
from ptbatch.member import Member
from ptbatch.response import PEAK
from ptbatch.tables import summary_row, tendon_table
from tests.members import KINDS, SMALL

MEMBERS = KINDS | {
    "to a deflection": SMALL | dict(deflection_limit=15),
    "crushing": SMALL | dict(fc=30, As=900, ds=450, live="midspan"),
    "simple": SMALL | dict(self_weight=False, P_live=1000, live="third-points", crushing_strain=0.003),
}


@pytest.fixture(scope="module", params=MEMBERS.values(), ids=MEMBERS.keys())
def told(request):
    """(response, summary)."""
    response = analyse(Member(**request.param))
    assert response.status == "ok"
    return response, summary_row(response.member, response)


def along(curve, column, load, step):
    """A column where the load is that of the peak, on the straight line between the two rows about it."""
    low, high = int(np.floor(step)), int(np.ceil(step))
    if curve.load[high] == curve.load[low]:
        return column[low]
    share = (load - curve.load[low]) / (curve.load[high] - curve.load[low])
    return (1.0 - share) * column[low] + share * column[high]


def test_load_factor_deflection_moment_and_stress_are_of_one_state(told):
    response, row = told
    curve, peak = response.curve, response.event("peak")
    load = 1e3 * row["load_peak [kN]"]

    def expected(column):
        return pytest.approx(along(curve, column, load, peak.step), rel=1e-9)

    assert row["deflection_peak [mm]"] == expected(curve.deflection)
    assert 1e6 * abs(row["moment_peak [kN m]"]) == expected(np.abs(curve.moment_max))
    assert row["tendon_stress_peak_mean [MPa]"] == expected(curve.stress_mean)
    # the largest of what was interpolated, anchors included, is at most the largest interpolated
    assert row["tendon_stress_peak_max [MPa]"] == pytest.approx(
        along(curve, curve.stress_max, load, peak.step), rel=1e-4
    )
    if response.has_service_value:
        assert row["load_factor_peak"] == expected(curve.factor)
        assert load / row["load_factor_peak"] == pytest.approx(curve.load[-1] / curve.factor[-1], rel=1e-9)


def test_the_tendon_at_the_peak_is_that_of_the_summary(told):
    response, row = told
    tendon = tendon_table(response.member, response)
    pairs = zip(tendon["stage"], tendon["stress_fe [MPa]"], strict=True)
    stress = [stress for stage, stress in pairs if stage == PEAK]
    assert max(stress) == pytest.approx(row["tendon_stress_peak_max [MPa]"], rel=1e-12)


def test_some_peak_lies_between_two_steps():
    """Otherwise the tests above would show nothing."""
    steps = [analyse(Member(**MEMBERS[name])).event("peak").step for name in ("crushing", "simple")]
    assert all(step != round(step) for step in steps)


def test_moment_and_load_of_a_simple_beam_at_the_peak_agree_by_statics():
    """Closed form: P L / 6 between the third-points; as it deflects, its supports come closer by 3 mm of
    6 m."""
    response = analyse(Member(**MEMBERS["simple"]))
    row = summary_row(response.member, response)
    assert row["moment_peak [kN m]"] == pytest.approx(row["load_peak [kN]"], rel=1e-3)
