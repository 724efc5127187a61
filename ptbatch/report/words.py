"""Values as they are read: digits that fit the unit, and a text where there is no number."""

from math import isfinite
from typing import Any

DECIMALS = {"MPa": 1, "mm": 1, "%": 2, "kN": 1, "kN m": 1, "m": 2, "-": 3}
MINUS, DASH = "\u2212", "\u2013"  # DASH: there is nothing to be told


def fixed(value: float, unit: str) -> str:
    """A number with the decimals of its unit, of which `-` stands for none: `1395.0`."""
    text = f"{value:.{DECIMALS[unit]}f}"
    return _signed(text if float(text) else text.lstrip("-"))


def digits(value: float, count: int = 4) -> str:
    """A number to some digits at least, without an exponent where it reads well: `0.0003`, `12005`."""
    if value != 0.0 and not 1e-4 <= abs(value) < 1e7:
        return _signed(f"{value:.{count - 1}e}")
    text = f"{value:.{count}g}"
    return _signed(f"{value:.0f}" if "e" in text or abs(value) >= 10 ** (count - 1) else text)


def said(value: Any, unit: str) -> str:
    """A cell of the results: its number, or the text that says why there is none."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return fixed(value, unit) if isfinite(value) else "not a finite number"
    return str(value) if value not in (None, "") else "not in the results"


def _signed(text: str) -> str:
    """With a minus sign as long as a plus."""
    return text.replace("-", MINUS)
