"""What a column is: its type, unit, limit, default and meaning."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from ptbatch.workbook.units import factor

Kind = Literal["number", "integer", "list", "integers", "text", "choice", "yesno"]
System = Literal["SI", "US"]

LISTS = ("list", "integers")
LIMITS: dict[str, tuple[Callable[[float], bool], str]] = {
    "positive": (lambda x: x > 0.0, "above zero"),
    "not negative": (lambda x: x >= 0.0, "zero or more"),
    "fraction": (lambda x: 0.0 < x < 1.0, "between 0 and 1"),
    "0 to 1": (lambda x: 0.0 <= x <= 1.0, "0 to 1"),
    "0 to 100": (lambda x: 0.0 <= x <= 100.0, "0 to 100"),
    "any": (lambda x: True, "a number"),
}

# Units of headers that name none: (SI, US).
UNITS: dict[str, tuple[str, str]] = {
    "number": ("-", "-"),
    "length": ("mm", "in"),
    "area": ("mm2", "in2"),
    "force": ("kN", "kip"),
    "line load": ("kN/m", "kip/ft"),
    "force or line load": ("kN", "kip"),
    "stress": ("MPa", "ksi"),
    "unit weight": ("kN/m3", "pcf"),
    "friction": ("1/rad", "1/rad"),
    "friction per length": ("1/m", "1/ft"),
    "angle per length": ("rad/m", "rad/ft"),
    "share": ("-", "-"),
    "percent": ("%", "%"),
}


class Derived(NamedTuple):
    """A default that follows from other columns: explanation, needs, the formula in N, mm, MPa."""

    text: str
    needs: tuple[str, ...]
    formula: Callable[..., Any]


@dataclass(frozen=True)
class Column:
    """One column of a sheet.

    default: a value in the SI unit of the column, a `Derived`, or None where there is none.
    us: unit of US headers without one, where it is not that of the quantity.
    source: where the default or the law comes from. also: another header that is understood.
    """

    name: str
    meaning: str
    kind: Kind = "number"
    quantity: str = "number"
    default: Any = None
    required: bool = False
    limit: str = "positive"
    choices: tuple[str, ...] = ()
    us: str = ""
    source: str = ""
    also: str = ""

    def unit(self, system: System) -> str:
        """Unit of a header that names none."""
        si, us = UNITS[self.quantity]
        return si if system == "SI" else self.us or us

    def header(self, system: System) -> str:
        """Header as the template writes it, e.g. `span [mm]`."""
        unit = self.unit(system)
        return self.name if unit == "-" else f"{self.name} [{unit}]"

    @property
    def default_value(self) -> Any:
        """Default in N, mm, MPa (not for a `Derived` one)."""
        if isinstance(self.default, float):
            return self.default * factor(self.quantity, self.unit("SI"))
        return self.default

    @property
    def default_text(self) -> str:
        """Default as explained to users, in the SI unit of the column."""
        if isinstance(self.default, Derived):
            return self.default.text
        if isinstance(self.default, bool):
            return "yes" if self.default else "no"
        if isinstance(self.default, float):
            return f"{self.default:g}"
        return "required" if self.required else str(self.default or "none")
