"""What a rule returns, and how it says what it needs."""

from collections.abc import Callable, Iterator, Mapping
from functools import wraps
from typing import Any, NamedTuple

Values = Mapping[str, Any]


class Fault(NamedTuple):
    """One thing wrong with a member. column: name of the argument, e.g. `fc` or `bars[0].depth`."""

    column: str
    value: Any
    wrong: str
    cure: str

    def __str__(self) -> str:
        value = "" if self.value is None else f" = {self.value!r}"
        return f"{self.column}{value}: {self.wrong}; {self.cure}"


Rule = Callable[[Values], list[Fault]]


def rule(*needs: str) -> Callable[[Callable[[Values], Iterator[Fault]]], Rule]:
    """Make a rule of a generator of faults; asked only if all the values it needs are there and sound."""

    def decorate(check: Callable[[Values], Iterator[Fault]]) -> Rule:
        @wraps(check)
        def asked(values: Values) -> list[Fault]:
            ready = all(values.get(name) is not None for name in needs)
            return list(check(values)) if ready else []

        return asked

    return decorate


def counted(number: int, noun: str) -> str:
    """`1 span`, `2 spans`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
