"""One check of a code: what is asked, by which clause, with which numbers, and how it came out."""

from dataclasses import dataclass, replace
from typing import NamedTuple

PASS, FAIL, REVIEW, INFO = "pass", "fail", "review", "info"


class Value(NamedTuple):
    """A number that is put into a formula: its symbol, the value and its unit (SI, as it is told)."""

    symbol: str
    value: float
    unit: str = ""

    def __str__(self) -> str:
        return f"{self.symbol} = {self.value:.5g} {self.unit}".rstrip()


@dataclass(frozen=True)
class Check:
    """A check with its outcome: `pass`, `fail`, `review` (an engineer must look: see reason) or `info`.

    demand and limit are in `unit`, x in mm (None where the check has no place). utilisation: above 1 fails;
    None where nothing is compared.
    """

    name: str
    clause: str
    formula: str
    values: tuple[Value, ...]
    demand: float
    limit: float
    unit: str
    utilisation: float | None
    outcome: str
    x: float | None = None
    reason: str = ""

    @property
    def numbers(self) -> str:
        """The numbers put in, in words."""
        return "; ".join(map(str, self.values))


def at_most(
    name: str, clause: str, formula: str, values: tuple[Value, ...], demand: float, limit: float, unit: str,
    x: float | None = None,
) -> Check:  # fmt: skip
    """A demand that must not exceed a limit."""
    used = max(demand, 0.0) / limit if limit > 0.0 else float("inf")
    return Check(name, clause, formula, values, demand, limit, unit, used, PASS if used <= 1.0 else FAIL, x)


def at_least(
    name: str, clause: str, formula: str, values: tuple[Value, ...], provided: float, required: float,
    unit: str, x: float | None = None,
) -> Check:  # fmt: skip
    """Something provided that must reach what is required; demand is what is required."""
    used = required / provided if provided > 0.0 else (0.0 if required <= 0.0 else float("inf"))
    outcome = PASS if used <= 1.0 else FAIL
    return Check(name, clause, formula, values, required, provided, unit, used, outcome, x)


def review(
    name: str, clause: str, reason: str, values: tuple[Value, ...] = (), x: float | None = None
) -> Check:
    """A check that the clause does not allow to be made: why, in place of an outcome."""
    nan = float("nan")
    return Check(name, clause, "", values, nan, nan, "", None, REVIEW, x, reason)


def untold(check: Check, missing: str) -> Check:
    """A check that fails for what has not been given is to be reviewed; what is missing is said."""
    return (
        replace(check, outcome=REVIEW, utilisation=None, reason=missing) if check.outcome == FAIL else check
    )


def unless(check: Check, doubt: str) -> Check:
    """A check that is passed under a doubt is to be reviewed."""
    return replace(check, outcome=REVIEW, reason=doubt) if doubt and check.outcome == PASS else check
