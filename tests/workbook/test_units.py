"""Units in headers."""

import pytest

from ptbatch.workbook.units import UnitError, conversion, factor, parse_header


@pytest.mark.parametrize(
    ("text", "name", "unit"),
    [
        ("span", "span", ""),
        ("span [m]", "span", "m"),
        (" span[ft] ", "span", "ft"),
        ("Aps [mm\u00b2]", "Aps", "mm2"),
        ("Aps\u00a0[in\u00b2]", "Aps", "in2"),
        ("density [kN/m\u00b3]", "density", "kN/m3"),
        ("K [m\u207b\u00b9]", "K", "m-1"),
        ("fc (ksi)", "fc", "ksi"),
        ("fc [ksi", "fc", "ksi"),
        ("fc []", "fc", ""),
        ("mark [A] of the drawing", "mark [A] of the drawing", ""),
    ],
)
def test_header(text, name, unit):
    assert parse_header(text) == (name, unit)


@pytest.mark.parametrize(
    ("quantity", "unit", "value"),
    [  # closed form: exact definitions of the units
        ("length", "mm", 1.0),
        ("length", "in", 25.4),
        ("length", "ft", 304.8),
        ("area", "cm2", 100.0),
        ("area", "in2", 645.16),
        ("area", "ft2", 92903.04),
        ("force", "MN", 1e6),
        ("force", "kip", 4448.2216152605),
        ("force", "lbf", 4.4482216152605),
        ("stress", "N/mm2", 1.0),
        ("stress", "kPa", 1e-3),
        ("stress", "GPa", 1e3),
        ("stress", "psi", 6.894757293168361e-3),
        ("stress", "ksi", 6.894757293168361),
        ("line load", "kN/m", 1.0),
        ("line load", "N/m", 1e-3),
        ("line load", "plf", 0.01459390293720636),
        ("line load", "lb/ft", 0.01459390293720636),
        ("line load", "klf", 14.59390293720636),
        ("line load", "kip/ft", 14.59390293720636),
        ("unit weight", "kN/m3", 1e-6),
        ("unit weight", "kg/m3", 9.80665e-9),
        ("unit weight", "pcf", 1.5708746384e-7),
        ("unit weight", "lb/ft3", 1.5708746384e-7),
        ("friction", "1/rad", 1.0),
        ("friction per length", "1/m", 1e-3),
        ("friction per length", "1/ft", 1 / 304.8),
        ("friction per length", "m\u207b\u00b9", 1e-3),
        ("angle per length", "rad/ft", 1 / 304.8),
        ("number", "-", 1.0),
    ],
)
def test_factor(quantity, unit, value):
    assert factor(quantity, unit) == pytest.approx(value, rel=1e-10)


@pytest.mark.parametrize("unit", ["mpa", "MPA", " MPa ", "N / mm\u00b2"])
def test_spelling_of_units(unit):
    assert factor("stress", unit) == 1.0


def test_kips_and_pounds():
    assert factor("force", "kips") == factor("force", "kip")
    assert factor("line load", "kips/ft") == factor("line load", "klf")


def test_unknown_unit_names_the_known_ones():
    with pytest.raises(UnitError, match="there is no unit furlong; use one of mm, cm, m, in, ft"):
        factor("length", "furlong")


def test_unit_of_another_quantity_is_named():
    with pytest.raises(UnitError, match="rad/m is a unit of angle per length, not of friction per length"):
        factor("friction per length", "rad/m")


@pytest.mark.parametrize(
    ("unit", "to", "value"),
    [
        ("kN", "kN", 1.0),
        ("N", "kN", 1e-3),
        ("ksi", "MPa", 6.894757293168),
        ("kip ft", "kN m", 1.3558179483314),  # closed form
        ("kNm", "kN m", 1.0),
        ("%", "%", 1.0),
        ("-", "%", 100.0),
        ("s", "s", 1.0),  # of no quantity that is known here, but the same
    ],
)
def test_conversion(unit, to, value):
    assert conversion(unit, to) == pytest.approx(value, rel=1e-10)


def test_conversion_between_quantities_is_refused():
    with pytest.raises(UnitError, match="kN is a unit of force, not of stress; use one of MPa"):
        conversion("kN", "MPa")
    with pytest.raises(UnitError, match="h is not ms; give it in ms"):
        conversion("h", "ms")
