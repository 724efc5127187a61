"""The unit system that results are written in: what becomes of a header and of the numbers below it.

Results are made in SI units, by the headers of `results`; they are converted once, on their way to a table,
and back once, when a table is read.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any

from ptbatch.workbook.column import System
from ptbatch.workbook.units import conversion, is_us, parse_header

NEUTRAL = ("", "-", "%", "1/rad")  # units of both systems
_US = {"MPa": "ksi", "mm": "in", "kN": "kip", "kN m": "kip ft"}
_SI = {us: si for si, us in _US.items()}
_ELSEWHERE: Mapping[System, Mapping[str, str]] = {"US": _US, "SI": _SI}
# What figures and reports use besides: units of the US, and of a product the number of them in one of SI
_SHOWN = {"m": "ft", "mm2": "in2", "kN/m": "kip/ft", "kN/m3": "pcf", "1/m": "1/ft", "rad/m": "rad/ft"}
_NUMBER = r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?"
_AMOUNT = re.compile(rf"({_NUMBER})(?: to ({_NUMBER}))? (mm2|mm|m|kN/m3|kN/m|kN m|kN|MPa)\b(?!/)")
_PRODUCTS = {"MPa m": ("ksi ft", conversion("MPa", "ksi") * conversion("m", "ft"))}


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
    made = {header: times(value, factor) for header, factor, value in converted}
    return made | _with_own_unit(record, system) if "unit" in record else made


def columns_in(columns: Mapping[str, Sequence[Any]], system: System) -> dict[str, list[Any]]:
    """A table by header, in a system."""
    if "unit" in columns:  # each row has its own
        records = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
        made = [record_in(record, system) for record in records]
        return {header: [record[header] for record in made] for header in headers_in(columns, system)}
    to = {header: written(header, system) for header in columns}
    return {to[h][0]: [times(value, to[h][1]) for value in values] for h, values in columns.items()}


def _with_own_unit(record: Mapping[str, Any], system: System) -> dict[str, Any]:
    """What a row of checks says in the unit that it names, or in words."""
    unit, factor = shown(str(record["unit"] or ""), system)
    numbers = {name: times(record[name], factor) for name in ("demand", "limit")}
    texts = {name: sentence_in(str(record.get(name) or ""), system) for name in ("numbers", "reason")}
    return {"unit": unit, **numbers, **texts}


def times(value: Any, factor: float) -> Any:
    """A number in another unit; anything else as it is."""
    return value * factor if factor != 1.0 and isinstance(value, float | int) else value


def sentence_in(text: str, system: System) -> str:
    """A message that names quantities, or ranges of them, in SI units, in a system."""
    return text if system == "SI" else _AMOUNT.sub(lambda found: _amount(found, system), text)


def _amount(found: re.Match[str], system: System) -> str:
    first, last, si = found.groups()
    unit, factor = shown(si, system)
    return " to ".join(f"{float(number) * factor:.4g}" for number in (first, last) if number) + f" {unit}"


def typical(headers: Iterable[str]) -> System:
    """The system that these headers have their units from; of a table in both it is SI."""
    units = [unit for header in headers if (unit := parse_header(header).unit) not in NEUTRAL]
    return "US" if sum(map(is_us, units)) > 2 / 3 * len(units) > 0.0 else "SI"


@lru_cache(64)
def shown(unit: str, system: System) -> tuple[str, float]:
    """The unit that a figure or a report uses for one of SI, and the number of them in it."""
    if system == "US" and unit in _PRODUCTS:
        return _PRODUCTS[unit]
    other = (_US | _SHOWN).get(unit, unit) if system == "US" else unit
    return other, 1.0 if other == unit else conversion(unit, other)
