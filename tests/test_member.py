"""A member's values: defaults, types, and every fault at once."""

from dataclasses import fields, replace
from math import sqrt

import numpy as np
import pytest

from ptbatch.analysis import prepare
from ptbatch.geometry.profile import ideal_profile
from ptbatch.member import Bar, Load, Member, MemberError
from ptbatch.model.arrays import set_up
from ptbatch.rules.plausible import WARNINGS as BUILT_RULES
from ptbatch.validation import TABLES, member_faults
from ptbatch.workbook.columns import MEMBERS

SOUND = dict(member="B1", span=12000, b=300, h=600, fc=40, Aps=592, dp=(300, 500, 300), fpj=1395)
TWO = SOUND | {"span": (8000, 9000), "dp": (300, 500, 100, 500, 300)}


def faults(base=SOUND, **changes) -> dict[str, str]:
    """What is wrong, by column."""
    return {fault.column: fault.wrong for fault in member_faults(base | changes)}


def test_fields_are_the_columns():
    names = {field.name for field in fields(Member)}
    assert names == {column.name for column in MEMBERS} - {"k_ec2"} | set(TABLES)


def test_defaults():
    member = Member(**SOUND)
    assert member.ft == 0.62 * sqrt(40)  # closed form, as all below
    assert member.Ec == 4700 * sqrt(40)
    assert (member.fpy, member.epu, member.crushing_strain) == (0.9 * 1860, 0.035, 0.0038)
    assert (member.span, member.live_spans, member.support_x) == ((12000.0,), (1,), (0.0, 12000.0))
    assert member.deflection_limit == 12000 / 50
    assert member.K == pytest.approx(0.0033e-3)
    assert member.density == pytest.approx(24e-6)
    assert (member.fpe, member.w_live, member.bw, member.As, member.bars) == (None, None, None, (), ())
    assert (member.elements, member.layers) == (20, 40)
    assert Member(**SOUND, concrete_law="parabola-rectangle").crushing_strain == 0.0035
    assert Member(**TWO).live_spans == (1, 2)


def test_wobble_as_an_angle():
    assert Member(**SOUND, mu=0.2, k_ec2=1e-5).K == pytest.approx(0.2e-5)  # closed form


def test_scalars_and_arrays_are_taken():
    member = Member(**SOUND | {"dp": np.array([300, 500, 300]), "fc": np.float32(40)}, As=500, ds=550)
    assert member.dp == (300.0, 500.0, 300.0)
    assert (member.As, member.ds) == ((500.0,), (550.0,))


def test_no_bars_may_be_typed_as_zero():
    assert faults(As=0, ds=0, As_top=0) == {}
    assert "outside" in faults(As=(0, 500), ds=(0, 0))["ds"]


def test_box_takes_its_bottom_from_its_top():
    member = Member(**SOUND, shape="box", bw=100, hf=80)
    assert (member.b_bottom, member.hf_bottom) == (300.0, 80.0)


def test_replace_keeps_the_rest():
    member = replace(Member(**SOUND), fpj=1300)
    assert member.fpj == 1300.0
    assert replace(member, fpj=1395) == Member(**SOUND)


def test_error_lists_every_fault():
    with pytest.raises(MemberError) as error:
        Member(**SOUND | {"b": -300, "fc": float("nan"), "fpj": 2000})
    assert {fault.column for fault in error.value.faults} == {"b", "fc", "fpj"}
    assert "b = -300: must be above zero" in str(error.value)
    assert "fpj = 2000.0: stress of 2000 MPa is above fpu = 1860 MPa" in str(error.value)


@pytest.mark.parametrize("name", [column.name for column in MEMBERS if column.required])
def test_required(name):
    assert faults({key: value for key, value in SOUND.items() if key != name}) == {name: "missing"}


@pytest.mark.parametrize(
    ("column", "value", "wrong"),
    [
        ("b", 0, "must be above zero"),
        ("mu", -0.1, "must be zero or more"),
        ("h", float("inf"), "is not a finite number"),
        ("Aps", True, "is not a number"),
        ("fc", "40", "is not a number"),
        ("span", (12000, None), "is not a number"),
        ("elements", 20.5, "is not a whole number"),
        ("shape", "circle", "is not one of the choices"),
        ("self_weight", 1, "is not yes or no"),
        ("harp", (0.3, 1.3), "must be between 0 and 1"),
        ("member", "  ", "is not a text"),
        ("Member", "B1", "there is no such column"),
        ("span", {}, "is empty"),
        ("bars", 5, "is not a list"),
    ],
)
def test_each_value_by_itself(column, value, wrong):
    assert faults(**{column: value}) == {column: wrong}


@pytest.mark.parametrize(
    ("changes", "column", "wrong"),
    [
        ({"fpj": None}, "fpj", "neither fpj nor fpe"),
        ({"fpe": 1100}, "fpe", "both fpj and fpe"),
        ({"fpj": None, "fpe": 1900}, "fpe", "above fpu"),
        ({"fpy": 1860}, "fpy", "not below fpu"),
        ({"epu": 0.005}, "epu", "lies before fpu / Ep"),
        ({"fc": 90}, "crushing_strain", "peaks at a strain"),
        ({"esu": 0.001}, "esu", "before yield"),
        ({"hardening": 1.0}, "hardening", "not below Es"),
        ({"tension_end": 1.0}, "tension_end", "before the concrete cracks"),
        ({"K": 1e-6, "k_ec2": 1e-5}, "k_ec2", "both K and k_ec2"),
        ({"wobble": "sine", "mu": 0}, "wobble", "without curvature friction"),
        ({"wobble": "sine", "mu": 0.001}, "wobble", "waves steeper than 0.5"),
        ({"wobble": "sine", "mu": 0.005}, "wobble", "outside the section"),
        ({"wobble": "sine", "elements": 3}, "elements", "too few for waves"),
        ({"set": 90}, "set", "slack"),
        ({"fpj": None, "fpe": 1300, "set": 90}, "fpe", "above fpu"),
        ({"dp": (300, 500)}, "dp", "2 depths given; parabola over 1 span needs 3"),
        ({"profile": "straight"}, "dp", "3 depths given; straight over 1 span needs 1"),
        ({"dp": (300, 600, 300)}, "dp", "outside the section"),
        ({"harp": (0.6, 0.4)}, "harp", "not in order"),
        ({"inflection": 0.5}, "inflection", "not between support and midspan"),
        ({"As": (500, 500), "ds": 550}, "ds", "1 depth for 2 areas"),
        ({"As": 500}, "ds", "0 depths for 1 area"),
        ({"As_top": 500, "ds_top": 640}, "ds_top", "outside the section"),
        ({"shape": "tee", "bw": 150}, "hf", "missing"),
        ({"shape": "tee", "bw": 350, "hf": 100}, "bw", "wider than a flange"),
        ({"shape": "box", "bw": 100, "hf": 300}, "hf", "leave no web"),
        ({"live_spans": 2}, "live_spans", "no span 2"),
        ({"live_spans": (1, 1)}, "live_spans", "named twice"),
        ({"live": "loads"}, "live", "no live rows"),
    ],
)
def test_values_together(changes, column, wrong):
    found = faults(**changes)
    assert list(found) == [column]
    assert wrong in found[column]


@pytest.mark.parametrize(
    ("left", "right", "spans", "fault"),
    [
        ("pin", "roller", 1, ""),
        ("fixed", "free", 1, ""),
        ("pin", "free", 2, ""),
        ("roller", "roller", 2, ""),
        ("free", "free", 3, ""),
        ("pin", "free", 1, "unstable"),
        ("free", "free", 2, "unstable"),
        ("roller", "roller", 1, "horizontally"),
    ],
)
def test_supports(left, right, spans, fault):
    depths = (300, *(500, 300) * spans)
    found = faults(support_left=left, support_right=right, span=(9000,) * spans, dp=depths)
    assert (fault in found["support_left"]) if fault else not found


@pytest.mark.parametrize(("left", "right"), [("pin", "pin"), ("fixed", "pin"), ("fixed", "fixed")])
def test_two_ends_that_cannot_move_are_warned_about(left, right):
    member = Member(**SOUND, support_left=left, support_right=right)
    assert "take part of the prestress" in member.warnings[0].wrong


@pytest.mark.parametrize("changes", [{"bw": 150}, {"P_live": 1000}, {"live": "midspan", "w_live": 5}])
def test_unused_values_are_warned_about(changes):
    assert ["not used" in fault.wrong for fault in Member(**SOUND, **changes).warnings] == [True]


@pytest.mark.parametrize(
    ("changes", "own"),
    [
        ({"As": 0}, []),  # and no depth for it
        ({"As": (0, 0), "As_top": 300, "ds_top": 50}, [(50.0, 300.0)]),
        ({"As": (0, 400), "ds": (0, 550), "As_top": (0,)}, [(550.0, 400.0)]),
    ],
)
def test_bars_without_an_area_are_none(changes, own):
    sheet = Bar(1000.0, 6000.0, 540.0, 200.0, 500.0)
    member = Member(**SOUND, **changes, bars=[sheet])
    through = [Bar(0.0, member.total_length, depth, area, member.fy) for depth, area in own]
    assert member.all_bars == (*through, sheet)
    areas = prepare(set_up(member), member.fpj).rig.case.model.bar_area
    assert areas[0].tolist() == [*(area for _, area in own), 0.0]  # the sheet's begin farther on


@pytest.mark.parametrize(
    "changes", [{"elements": 10**15}, {"elements": 2001, "wobble": "sine"}, {"layers": 10**9}]
)
def test_a_mesh_that_no_machine_can_bear_is_refused(changes):
    (found,) = faults(**changes).values()
    assert "more than" in found


def test_free_tendon_needs_no_depths():
    points = ((0, 300), (5000, 500), (12000, 300))
    values = {key: value for key, value in SOUND.items() if key != "dp"}
    assert Member(**values, profile_points=points).dp == ()
    assert list(faults(values, profile_points=((0, 300), (0, 500), (11000, 700)))) == [
        "profile_points[1].x",
        "profile_points[2].x",
        "profile_points[2].dp",
    ]


def test_bars_and_loads_along_the_member():
    member = Member(
        **SOUND, live="loads", bars=[(0, 6000, 550, 400, 500)], loads=[Load("live", "point", 1e3, 1e3, 5e3)]
    )
    assert member.bars == (Bar(0.0, 6000.0, 550.0, 400.0, 500.0),)
    found = faults(
        bars=[Bar(7000, 6000, 650, 400, 500), (1, 2)],
        loads=[("dead", "uniform", 0, 13000, 2), ("dead", "point", 5, 5, 0)],
    )
    assert found["bars[1]"] == "is incomplete"
    assert "beyond the right end" in found["loads[0].x_end"]
    assert found["loads[1].value"] == "the load is zero"
    assert "not right of" in faults(bars=[Bar(7000, 6000, 550, 400, 500)])["bars[0].x_end"]
    assert "outside" in faults(bars=[Bar(0, 6000, 650, 400, 500)])["bars[0].depth"]


@pytest.mark.parametrize("profile", ["parabola", "harped"])
def test_tendon_stays_between_its_given_depths(profile):
    """The rule that looks at the given depths alone is enough."""
    member = Member(**TWO, profile=profile)
    depth = ideal_profile(member).depth(np.linspace(0, member.total_length, 2001))
    assert min(member.dp) - 1e-9 <= depth.min()
    assert depth.max() <= max(member.dp) + 1e-9


@pytest.mark.parametrize(
    ("column", "value"),
    [("fc", 5000), ("span", 12), ("b", 0.3), ("h", 24), ("fpu", 270), ("density", 150), ("set", 250)],
)
def test_a_value_in_another_unit_is_warned_of(column, value):
    """psi under MPa, m and in under mm, ksi under MPa, pcf under kN/m3."""
    values = {**SOUND, "w_live": 10.0, column: value}
    found = [fault for built in BUILT_RULES for fault in built(values)]
    assert [(fault.column, fault.cure) for fault in found] == [(column, "check the unit in the header")]


def test_usual_values_are_not_warned_of():
    assert Member(**SOUND, w_live=10).warnings == []
