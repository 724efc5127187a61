"""Values as they are read: digits that fit the unit, and a text where there is no number."""

from math import isfinite
from typing import Any, NamedTuple

from ptbatch.workbook.column import System
from ptbatch.workbook.systems import shown

DECIMALS = {
    **{"MPa": 1, "mm": 1, "%": 2, "kN": 1, "kN m": 1, "m": 2, "-": 3, "MPa m": 1},
    **{"ksi": 2, "in": 3, "kip": 2, "kip ft": 1, "ft": 2, "ksi ft": 1},
}
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


class Words(NamedTuple):
    """Values of SI units in words, in a unit system."""

    system: System

    def unit(self, unit: str) -> str:
        """The unit that stands for one of SI."""
        return shown(unit, self.system)[0].replace("2", "²").replace("3", "³")

    def number(self, value: float, unit: str) -> str:
        """A number with the decimals of its unit."""
        other, factor = shown(unit, self.system)
        return fixed(value * factor, other)

    def amount(self, value: float, unit: str) -> str:
        """The same with its unit."""
        return f"{self.number(value, unit)} {self.unit(unit)}"

    def digits(self, value: float, unit: str, count: int = 4) -> str:
        """A number to some digits at least."""
        return digits(value * shown(unit, self.system)[1], count)

    def size(self, value: float, unit: str) -> str:
        """The same with its unit."""
        return f"{self.digits(value, unit)} {self.unit(unit)}"

    def said(self, value: Any, unit: str) -> str:
        """A cell of the results: its number, or the text that says why there is none."""
        if isinstance(value, int | float) and not isinstance(value, bool):
            return self.number(value, unit) if isfinite(value) else "not a finite number"
        return str(value) if value not in (None, "") else "not in the results"


def _signed(text: str) -> str:
    """With a minus sign as long as a plus."""
    return text.replace("-", MINUS)
