"""Units in headers, and the factor from each to N, mm, MPa and radians."""

import re
import unicodedata
from functools import lru_cache
from typing import NamedTuple

IN, FT = 25.4, 304.8  # mm
LBF = 4.4482216152605  # N
GRAVITY = 9.80665  # N/kg

_FORCES = {"N": 1.0, "kN": 1e3, "MN": 1e6, "lbf": LBF, "kip": 1e3 * LBF}
_LINE_LOADS = {
    **{"N/mm": 1.0, "kN/m": 1.0, "N/m": 1e-3},
    **{"plf": LBF / FT, "lbf/ft": LBF / FT, "klf": 1e3 * LBF / FT, "kip/ft": 1e3 * LBF / FT},
    **{"lbf/in": LBF / IN, "kip/in": 1e3 * LBF / IN},
}
_LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1e3, "in": IN, "ft": FT}

QUANTITIES: dict[str, dict[str, float]] = {
    "number": {"-": 1.0},
    "length": _LENGTHS,
    "area": {f"{unit}2": factor**2 for unit, factor in _LENGTHS.items()},
    "force": _FORCES,
    "line load": _LINE_LOADS,
    "moment": {"kN m": 1e6, "N mm": 1.0, "kip ft": 1e3 * LBF * FT, "kip in": 1e3 * LBF * IN},
    "share": {"-": 1.0, "%": 0.01},
    "percent": {"%": 1.0},
    "force or line load": _FORCES | _LINE_LOADS,
    "stress": {
        **{"MPa": 1.0, "N/mm2": 1.0, "kPa": 1e-3, "GPa": 1e3, "kN/cm2": 10.0},
        **{"psi": LBF / IN**2, "ksi": 1e3 * LBF / IN**2},
    },
    "unit weight": {
        **{"kN/m3": 1e-6, "kg/m3": GRAVITY * 1e-9},
        **{"pcf": LBF / FT**3, "lbf/ft3": LBF / FT**3},
    },
    "friction": {"1/rad": 1.0, "-": 1.0},
    "friction per length": {"1/m": 1e-3, "1/mm": 1.0, "1/ft": 1 / FT},
    "angle per length": {"rad/m": 1e-3, "rad/mm": 1.0, "rad/ft": 1 / FT},
}

_HEADER = re.compile(r"(?P<name>[^\[(]*?)\s*(?:[\[(](?P<unit>[^\])]*)[\])]?\s*)?")


class UnitError(ValueError):
    """A unit that does not measure the quantity, and those that do."""

    def __init__(self, wrong: str, cure: str) -> None:
        super().__init__(f"{wrong}; {cure}")
        self.wrong, self.cure = wrong, cure


class Header(NamedTuple):
    """Name and unit of a column as typed; the unit is empty where none is given."""

    name: str
    unit: str


def plain(text: str) -> str:
    """Text with compatibility characters (superscripts, hard spaces, minus signs) in their ASCII form."""
    return unicodedata.normalize("NFKC", text).replace("\u2212", "-").strip()


def parse_header(text: str) -> Header:
    """Split `name [unit]`; round brackets are understood as well."""
    match = _HEADER.fullmatch(plain(text))
    return Header(match["name"], (match["unit"] or "").strip()) if match else Header(plain(text), "")


@lru_cache(1024)
def factor(quantity: str, unit: str) -> float:
    """Number that turns a value in this unit into N, mm, MPa or radians. Raises UnitError."""
    units = QUANTITIES[quantity]
    value = _among(units, unit)
    if value is None:
        other = next((name for name, others in QUANTITIES.items() if _among(others, unit)), "")
        what = f"{unit} is a unit of {other}, not of {quantity}" if other else f"there is no unit {unit}"
        raise UnitError(what, f"use one of {', '.join(units)}")
    return value


def conversion(unit: str, to: str) -> float:
    """Number that turns a value in one unit into another unit of the same quantity. Raises UnitError."""
    if _spelling(unit) == _spelling(to):
        return 1.0
    for quantity, units in QUANTITIES.items():
        target = _among(units, to)
        if target is not None:
            return factor(quantity, unit) / target
    raise UnitError(f"{unit} is not {to}", f"give it in {to}")


def is_us(unit: str) -> bool:
    """Whether this is a unit of the US, and not one of SI."""
    return bool(re.search(r"\b(in|ft|lbf|kip|psi|ksi|pcf|plf|klf)", re.sub(r"[\d\s]", " ", _spelling(unit))))


def _among(units: dict[str, float], unit: str) -> float | None:
    return {_spelling(name): value for name, value in units.items()}.get(_spelling(unit))


def _spelling(unit: str) -> str:
    """One spelling for kip and kips, lb and lbf, inches and in, m^-1 and 1/m, with or without spaces."""
    text = re.sub(r"[\s^]", "", plain(unit)).casefold().rstrip(".")
    text = re.sub(r"inch(es)?", "in", re.sub(r"feet|foot", "ft", text))
    text = re.sub(r"^(mm|m|ft)-1$", r"1/\1", text)
    return re.sub(r"^(lb|kip)s?(?=$|/)", lambda match: {"lb": "lbf", "kip": "kip"}[match[1]], text)
