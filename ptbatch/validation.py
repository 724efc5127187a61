"""From the values of a member as given to sound, complete values, or to all that is wrong with them.

First each value by itself (type, finite, limit, choice), then the defaults, then the rules between values.
A rule whose values are faulty is not asked, so that one mistake is reported once.
"""

from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from math import isfinite
from numbers import Real
from typing import Any

from ptbatch.along import Bar, Load, Point
from ptbatch.rules import RULES, WARNINGS
from ptbatch.rules.fault import Fault, Values
from ptbatch.workbook.column import LIMITS, LISTS, Column, Derived
from ptbatch.workbook.columns import BY_NAME, MEMBERS
from ptbatch.workbook.optional import LOADS, PROFILE, REBAR

# Arguments that hold rows of the optional sheets: what a row is, and its columns.
TABLES: dict[str, tuple[type, tuple[Column, ...]]] = {
    "profile_points": (Point, PROFILE[1:]),
    "bars": (Bar, REBAR[1:]),
    "loads": (Load, LOADS[1:]),
}


def member_faults(values: Values, known_bad: Iterable[str] = ()) -> list[Fault]:
    """All faults of a member's values (N, mm, MPa), sorted out in one go.

    known_bad: names already reported as faulty, of which nothing more is to be said.
    """
    return examine(values, known_bad)[1]


def member_warnings(values: Values) -> list[Fault]:
    """What is allowed but probably not meant; values: complete ones, as `vars(member)`."""
    return [fault for rule in WARNINGS for fault in rule(values)]


def examine(values: Values, known_bad: Iterable[str] = ()) -> tuple[dict[str, Any], list[Fault]]:
    """Complete values and all faults; where there are faults some values are missing."""
    given = {name: value for name, value in values.items() if not _absent(value)}
    sound, faults = _check_each(given, set(known_bad))
    bad = {*known_bad, *(fault.column.partition("[")[0] for fault in faults)}
    complete = _complete(sound, bad)
    asked = complete | {"given": frozenset(given)}
    faults += [fault for rule in RULES for fault in rule(asked)]
    return complete, faults


def _absent(value: Any) -> bool:
    return value is None or (isinstance(value, tuple | list) and not value)


def _check_each(given: Values, bad: set[str]) -> tuple[dict[str, Any], list[Fault]]:
    """Sound values, as tuples and floats, and the faults of the others."""
    sound: dict[str, Any] = {}
    faults = list(_unknown(given))
    for column in MEMBERS:
        name = column.name
        if name in given:
            sound[name], wrong = checked(column, given[name])
            faults += [Fault(name, given[name], *wrong)] if wrong else []
        elif column.required and name not in bad and not (name == "dp" and given.get("profile_points")):
            faults.append(Fault(name, None, "missing", f"give {name}: {column.meaning.partition(';')[0]}"))
    for name in TABLES:
        sound[name], wrongs = _check_table(name, given.get(name, ()))
        faults += wrongs
    faulty = {fault.column.partition("[")[0] for fault in faults} | bad
    return {name: value for name, value in sound.items() if name not in faulty}, faults


def _unknown(given: Values) -> Iterator[Fault]:
    for name in given.keys() - BY_NAME.keys() - TABLES.keys():
        yield Fault(name, given[name], "there is no such column", likely(name, BY_NAME))


def _check_table(name: str, rows: Any) -> tuple[tuple[Any, ...], list[Fault]]:
    """Rows of an optional sheet in their type; their order is kept, and what is wrong is numbered from 0."""
    make, columns = TABLES[name]
    if not isinstance(rows, list | tuple):
        return (), [Fault(name, rows, "is not a list", "give a list of rows")]
    sound, faults = [], []
    for i, row in enumerate(rows):
        if not isinstance(row, tuple | list) or len(row) != len(columns):
            cure = f"give {', '.join(column.name for column in columns)}"
            faults.append(Fault(f"{name}[{i}]", row, "is incomplete", cure))
            continue
        pairs = [checked(column, value) for column, value in zip(columns, row, strict=True)]
        sound.append(make(*(value for value, _ in pairs)))
        for column, (value, wrong) in zip(columns, pairs, strict=True):
            faults += [Fault(f"{name}[{i}].{column.name}", value, *wrong)] if wrong else []
    return tuple(sound), faults


def _complete(sound: Mapping[str, Any], bad: set[str]) -> dict[str, Any]:
    """Sound values with the defaults of the others, as far as these can be told."""
    values = dict(sound)
    for column in MEMBERS:
        name, default = column.name, column.default
        if name in values or name in bad or column.required:
            continue
        if not isinstance(default, Derived):
            values[name] = column.default_value
        elif all(need in values for need in default.needs):
            values[name] = default.formula(*(values[need] for need in default.needs))
    if values.get("profile_points"):
        values.setdefault("dp", ())
    return values


def checked(column: Column, value: Any) -> tuple[Any, tuple[str, str] | None]:
    """The value in its type, and what is wrong with it (with the cure) if anything is."""
    if column.kind == "text":
        sound = isinstance(value, str) and bool(value.strip())
        return value, None if sound else ("is not a text", f"give {column.meaning}")
    if column.kind == "yesno":
        return value, None if isinstance(value, bool) else ("is not yes or no", "give yes or no")
    if column.kind == "choice":
        sound = value in column.choices
        return value, None if sound else ("is not one of the choices", likely(str(value), column.choices))
    if column.kind in LISTS:
        items = value if isinstance(value, Iterable) and not isinstance(value, str) else (value,)
        pairs = [_checked_number(column, item) for item in items]
        wrong = next(
            (wrong for _, wrong in pairs if wrong), None if pairs else ("is empty", "give its numbers")
        )
        return tuple(item for item, _ in pairs), wrong
    return _checked_number(column, value)


def _checked_number(column: Column, value: Any) -> tuple[Any, tuple[str, str] | None]:
    cure = f"give {column.meaning}"
    if isinstance(value, bool) or not isinstance(value, Real):
        return value, ("is not a number", cure)
    number = float(value)
    holds, limit = LIMITS[column.limit]
    if not isfinite(number):
        return value, ("is not a finite number", cure)
    if not holds(number):
        return value, (f"must be {limit}", cure)
    if column.kind in ("integer", "integers"):
        return int(number), None if number.is_integer() else ("is not a whole number", cure)
    return number, None


def likely(word: str, choices: Iterable[str]) -> str:
    """Cure for a word that is none of the choices: the one probably meant, or all of them."""
    choices = list(choices)
    meant = closest(word, choices)
    if meant:
        return f"did you mean {meant}?"
    return f"choose one of {', '.join(choices)}" if len(choices) <= 12 else "check the spelling"


def closest(word: str, choices: Iterable[str]) -> str | None:
    """The choice that a word is probably a misspelling of."""
    by_folded = {choice.casefold(): choice for choice in choices}
    close = get_close_matches(word.casefold(), by_folded, n=1, cutoff=0.6)
    return by_folded[close[0]] if close else None
