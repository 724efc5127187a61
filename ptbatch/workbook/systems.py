"""The unit system that results are written in: what becomes of a header and of the numbers below it.

Results are made in SI units, by the headers of `results`; they are converted once, on their way to a table,
and back once, when a table is read.
"""

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any

from ptbatch.workbook.column import System
from ptbatch.workbook.units import conversion, is_us, parse_header

NEUTRAL = ("", "-", "%", "1/rad")  # units of both systems
_US = {"MPa": "ksi", "mm": "in", "kN": "kip", "kN m": "kip ft"}
_SI = {us: si for si, us in _US.items()}
_ELSEWHERE: Mapping[System, Mapping[str, str]] = {"US": _US, "SI": _SI}


@lru_cache(1024)
def written(header: str, system: System) -> tuple[str, float]:
    """The header in a system, and the number that its values are to be multiplied by."""
    name, unit = parse_header(header)
    other = _ELSEWHERE[system].get(unit, unit)
    return (header, 1.0) if other == unit else (f"{name} [{other}]", conversion(unit, other))


def headers_in(headers: Iterable[str], system: System) -> list[str]:
    """Headers in a system."""
    return [written(header, system)[0] for header in headers]


def record_in(record: Mapping[str, Any], system: System) -> dict[str, Any]:
    """Values by header, in a system; texts and whole numbers stay."""
    converted = ((*written(header, system), value) for header, value in record.items())
    return {header: times(value, factor) for header, factor, value in converted}


def times(value: Any, factor: float) -> Any:
    """A number in another unit; anything else as it is."""
    return value * factor if factor != 1.0 and isinstance(value, float | int) else value


def typical(headers: Iterable[str]) -> System:
    """The system that these headers have their units from; of a table in both it is SI."""
    units = [unit for header in headers if (unit := parse_header(header).unit) not in NEUTRAL]
    return "US" if sum(map(is_us, units)) > 2 / 3 * len(units) > 0.0 else "SI"
