"""Nominal cover."""

DURABLE = {  # mm, structural class S4, table 4.5N
    "X0": 10.0,
    "XC1": 25.0,
    **dict.fromkeys(("XC2", "XC3"), 35.0),
    "XC4": 40.0,
    **dict.fromkeys(("XD1", "XS1"), 45.0),
    **dict.fromkeys(("XD2", "XS2"), 50.0),
    **dict.fromkeys(("XD3", "XS3"), 55.0),
}
CLASSES = {"interior": "XC1", "weather": "XC4", "ground": "XC2"}  # what the words mean here
DEVIATION = 10.0  # mm, 4.4.1.3 (1)


def exposure_class(exposure: str) -> str:
    """Class of table 4.1."""
    return CLASSES.get(exposure, exposure)


def nominal(exposure: str, duct: float) -> float:
    """cnom of prestressing steel [mm]; duct: diameter of the duct or sheathing, zero if unknown.

    EN 1992-1-1, 4.4.1.1 (2), 4.4.1.2 (3), table 4.5N for class S4.
    """
    return max(DURABLE[exposure_class(exposure)], min(duct, 80.0)) + DEVIATION
