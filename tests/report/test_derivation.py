"""The numbers put in are those of the results."""

from math import exp

import pytest

from ptbatch.report.capacity import events
from ptbatch.report.derivation import derivation, losses_of
from ptbatch.report.stressing import stages
from ptbatch.report.words import MINUS, Words, digits, fixed
from tests.report.conftest import LONG, SCRIPT

SOUND = ["simple", "US tee", "two spans", "stuck", SCRIPT, "=1+1", LONG, "mean", "frictionless", "too heavy"]


def steps(stored) -> dict:
    return {step.quantity: step for step in derivation(stored)}


def number(text) -> float:
    return float(text.replace(MINUS, "-").split()[0])


@pytest.mark.parametrize("name", SOUND)
def test_losses_are_those_of_the_summary(stored, name):
    one = stored[name]
    losses = losses_of(one)
    assert 100.0 * losses.loss_jacking_end == pytest.approx(
        one.value("loss_jacking_end_analytic [%]"), abs=1e-5
    )
    assert 100.0 * losses.loss_fixed_end == pytest.approx(one.value("loss_fixed_end_analytic [%]"), abs=1e-5)
    assert losses.set_length == pytest.approx(one.value("set_length_analytic [mm]"), rel=1e-6)


def test_the_numbers_put_in_give_the_value(stored):
    """By hand: 6 m, parabola of 150 mm, 1200 MPa on 400 mm2, set 2 mm."""
    found = steps(stored["simple"])
    assert number(found["jacking force"].analytic) == 480.0
    alpha, x = number(found["angle turned"].analytic), number(found["length"].analytic)
    assert alpha == pytest.approx(0.1993, abs=1e-4)  # 2 atan(4 * 150 / 6000)
    assert number(found["force there, jacked"].analytic) == pytest.approx(
        480.0 * exp(-(0.07 * alpha + 0.0033 * x)), abs=0.06
    )
    assert number(found["area between the curves"].analytic) == 390.0  # 195 GPa * 2 mm
    level, anchor = (
        number(found[name].analytic) for name in ("level of the mirrored curve", "stress at the anchor")
    )
    assert anchor == pytest.approx(level - 1200.0, abs=0.11)
    assert number(found["loss, jacking end"].analytic) == pytest.approx(
        100.0 * (1.0 - anchor / 1200.0), abs=0.01
    )
    assert "exp(" in found["force there, jacked"].formula and "(38)" in found["force there, jacked"].formula


@pytest.mark.parametrize("name", ["simple", "=1+1", "frictionless"])
def test_the_mirrored_curve_has_its_formula(stored, name):
    step = steps(stored[name])["level of the mirrored curve"]
    assert step.formula.startswith("λ = (2 ∫")
    top, length = step.numbers.split(" MPa m / ")
    area, removed = (float(text) for text in top.removeprefix("(2 · ").rstrip(")").split(f" {MINUS} "))
    assert number(step.analytic) == pytest.approx((2.0 * area - removed) / number(length), rel=2e-4)


def test_without_set(stored):
    assert steps(stored["mean"])["wedge set"].analytic == "none"


def test_a_live_end_on_the_right_sees_the_other_half(stored):
    left, right = (steps(stored[name]) for name in ("simple", "=1+1"))
    assert right["angle turned"].analytic == left["angle turned"].analytic
    assert "0.00 m from the left" in right["length"].numbers


def test_stages(stored):
    rows = {stage.name: stage for stage in stages(stored["simple"])}
    assert list(rows)[:4] == ["jacked", "set", "anchored", "peak"]
    assert rows["anchored"].fe[1] == fixed(stored["simple"].value("stress_anchored_mean [MPa]"), "MPa")
    for name in ("jacked", "anchored"):
        assert [float(t) for t in rows[name].fe] == pytest.approx(
            [float(t) for t in rows[name].analytic], rel=0.01
        )


def test_events(stored):
    rows = {event.name: event for event in events(stored["simple"])}
    assert rows["peak"].load == fixed(stored["simple"].value("load_peak [kN]"), "kN")
    assert rows["peak"].factor == fixed(stored["simple"].value("load_factor_peak"), "-")
    assert events(stored["frictionless"])[2].factor == "no service load"
    assert all(event.reason for event in events(stored["too heavy"]))


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0003, "0.0003"), (12005.4, "12005"), (0.0, "0"), (1e-9, f"1.000e{MINUS}09"), (-5.25, f"{MINUS}5.25")],
)
def test_digits(value, text):
    assert digits(value) == text


def test_said():
    said = Words("SI").said
    assert said(-0.0001, "%") == "0.00"
    assert said("no crack", "kN") == "no crack"
    assert said(None, "kN") == "not in the results"


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (1395.0, "MPa", "202.33 ksi"),  # 1 ksi = 6.894757 MPa, NIST SP 811, as the others
        (25.4, "mm", "1.000 in"),
        (3.048, "m", "10.00 ft"),
        (4.4482216, "kN", "1.00 kip"),
        (1.3558179, "kN m", "1.0 kip ft"),
        (6.8947573 * 0.3048, "MPa m", "1.0 ksi ft"),
    ],
)
def test_values_in_us_units(value, unit, text):
    assert Words("US").amount(value, unit) == text
    assert Words("SI").amount(value, unit).endswith(f" {unit}")
