"""One entry against the results: pass, fail, or not reproducible."""

from ptbatch.compare.entry import FAIL, NOT_REPRODUCIBLE, PASS, Entry, Line, Query, Value, Verdict
from ptbatch.compare.results import NoValueError, Results
from ptbatch.workbook.units import UnitError, conversion

STALE = "marked as not reproducible, but it is met: take the mark away"


def judge(entry: Entry, results: Results, rtol: float) -> Line:
    """The line of an entry. rtol: for numbers that come without a tolerance."""
    try:
        ours, unit = measured(entry, results)
    except NoValueError as none:
        return line(entry, None, entry.of.unit, rtol, FAIL, str(none))
    return weigh(entry, ours, unit, rtol)


def weigh(entry: Entry, ours: Value, unit: str, rtol: float) -> Line:
    """The line of an entry for our value, which is in its unit.

    Passes: within the larger of atol and rtol times the value; beyond a bound by no more than that. An entry
    marked as not reproducible needs a number of ours all the same: the mark excuses its size, nothing else.
    """
    wrong = _wrong(entry, ours, rtol)
    if not entry.not_reproducible:
        return line(entry, ours, unit, rtol, FAIL if wrong else PASS, wrong)
    if isinstance(ours, str):
        return line(entry, ours, unit, rtol, FAIL, f"the results say: {ours or 'nothing'}")
    if not wrong:
        return line(entry, ours, unit, rtol, PASS, STALE)
    return line(entry, ours, unit, rtol, NOT_REPRODUCIBLE, entry.not_reproducible)


def line(entry: Entry, ours: Value | None, unit: str, rtol: float, verdict: Verdict, because: str) -> Line:
    """A line of the report."""
    return Line(
        case=entry.case,
        member=entry.of.member,
        what=entry.what,
        ours=ours,
        theirs=entry.value,
        unit=unit,
        tolerance=_tolerance_text(entry, rtol),
        verdict=verdict,
        because=because,
        kind=entry.kind,
        source=entry.source,
        note=entry.note,
    )


def measured(entry: Entry, results: Results) -> tuple[Value, str]:
    """What the results say, and its unit: that of the entry or else theirs. Raises NoValueError."""
    if entry.against is None:
        return _in_unit(entry.of, entry.of.unit, results)
    ours, unit = _number(entry.of, entry.of.unit, results)
    other, _ = _number(entry.against, unit, results)
    if entry.how == "ratio":
        return _ratio(ours, other, entry.against), ""
    if entry.base is None:
        return ours - other, unit
    base, _ = _number(entry.base, unit, results)
    return 100.0 * _ratio(ours - other, base, entry.base), "%"


def _number(query: Query, unit: str, results: Results) -> tuple[float, str]:
    value, unit = _in_unit(query, unit, results)
    if isinstance(value, str):
        raise NoValueError(f"{query.name} of {query.member} is no number but: {value}")
    return value, unit


def _ratio(value: float, to: float, query: Query) -> float:
    if to == 0.0:
        raise NoValueError(f"there is no ratio to {query}, which is zero")
    return value / to


def _in_unit(query: Query, unit: str, results: Results) -> tuple[Value, str]:
    """A value in this unit, in that of the results where it is empty."""
    value, own = results.look_up(query)
    if isinstance(value, str) or not unit:
        return value, own
    try:
        return value / conversion(unit, own), unit
    except UnitError as error:
        raise NoValueError(f"{query.name} is in {own or 'no unit'}: {error}") from error


def _wrong(entry: Entry, ours: Value, rtol: float) -> str:
    """What is wrong with our value, empty if it passes."""
    theirs = entry.value
    if theirs is None:
        return "no number is printed"
    if isinstance(ours, str) or isinstance(theirs, str):
        return "" if _text(ours) == _text(theirs) else _text_differs(ours, theirs)
    atol, share = _tolerances(entry, rtol)
    allowed = max(atol, share * abs(theirs))
    if entry.bound == "at least":
        return "" if ours >= theirs - allowed else f"less by {theirs - ours:.3g}"
    if entry.bound == "at most":
        return "" if ours <= theirs + allowed else f"more by {ours - theirs:.3g}"
    off = abs(ours - theirs)
    percent = f" ({100.0 * off / abs(theirs):.2g} %)" if theirs else ""
    return "" if off <= allowed else f"off by {off:.3g}{percent}"


def _text(value: Value) -> str:
    """As it would be typed, capitals or not: the text 12 is read as a number."""
    return value.strip().casefold() if isinstance(value, str) else f"{value:.15g}"


def _text_differs(ours: Value, theirs: Value) -> str:
    if isinstance(ours, str):
        return f"the results say: {ours or 'nothing'}"
    return f"a number in the results, a text in the table: {theirs}"


def _tolerances(entry: Entry, rtol: float) -> tuple[float, float]:
    """atol and rtol of an entry; a bound that comes without has none."""
    given = entry.rtol is not None or entry.atol is not None
    otherwise = 0.0 if given or entry.bound != "equal" else rtol
    return entry.atol or 0.0, entry.rtol or otherwise


def _tolerance_text(entry: Entry, rtol: float) -> str:
    """`± 0.5 or 2 %`, `at least`, `at most, plus 2 %`."""
    if isinstance(entry.value, str | None):
        return ""
    atol, share = _tolerances(entry, rtol)
    parts = [f"{atol:.6g}"] if atol else []
    parts += [f"{100.0 * share:.4g} %"] if share else []
    text = " or ".join(parts)
    if entry.bound == "equal":
        return f"± {text or 0}"
    sign = "less" if entry.bound == "at least" else "plus"
    return f"{entry.bound}, {sign} {text}" if text else entry.bound
