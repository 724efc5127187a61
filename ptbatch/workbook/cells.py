"""From one raw cell to a value in N, mm, MPa. What is not clear is reported, never guessed."""

import re
from datetime import date, time, timedelta
from typing import Any

from ptbatch.validation import likely
from ptbatch.workbook.column import LISTS, Column
from ptbatch.workbook.read import UnsavedFormula
from ptbatch.workbook.units import plain

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_FRACTION = re.compile(r"(\d+)\s*/\s*([1-9]\d*)")
_WITH_UNIT = re.compile(r"[+-]?\d[\d.]*\s*[a-zA-Z%].*")
_YES_NO = {"yes": True, "no": False, "y": True, "n": False, "true": True, "false": False}


class CellError(ValueError):
    """A cell that holds no value of its column's type."""

    def __init__(self, wrong: str, cure: str) -> None:
        super().__init__(wrong)
        self.wrong, self.cure = wrong, cure


def parse(column: Column, raw: Any, factor: float = 1.0) -> Any:
    """Value of a cell, numbers times the factor of their unit; None for `all` of a list. Raises CellError."""
    _refuse_no_value(raw)
    if column.kind == "text":
        return parse_text(column, raw)
    if column.kind == "choice":
        return _choice(column, raw)
    if column.kind == "yesno":
        return _yes_no(column, raw)
    if column.kind == "integers" and isinstance(raw, str) and plain(raw).casefold() == "all":
        return None
    if column.kind in LISTS:
        items = raw.split(";") if isinstance(raw, str) else [raw]
        return tuple(_number(item, "; between numbers") * factor for item in items)
    return _number(raw) * factor


def parse_text(column: Column, raw: Any) -> str:
    """Text of a cell; a number such as 12 is a name as well."""
    if isinstance(raw, str):
        return raw.strip()
    if isinstance(raw, bool) or not isinstance(raw, int | float):
        raise CellError(f"{_kind(raw)} is not a {column.name}", "format the cell as text and type it again")
    return f"{raw:.15g}" if isinstance(raw, float) else str(raw)


def _refuse_no_value(raw: Any) -> None:
    if isinstance(raw, UnsavedFormula):
        cure = "open the workbook in Excel, let it calculate, and save it"
        raise CellError("the formula has no stored value", cure)
    if isinstance(raw, str) and re.fullmatch(r"#[A-Z/0]+[!?]?|#N/A", raw.strip()):
        raise CellError(f"the cell shows the error {raw.strip()}", "put the formula right, or type the value")


def _kind(raw: Any) -> str:
    if isinstance(raw, bool):
        return "TRUE or FALSE"
    return "a date or time" if isinstance(raw, date | time | timedelta) else "this value"


def _number(raw: Any, between: str = "") -> float:
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        cure = "type the number again, with the cell formatted as Number"
        raise CellError(f"{_kind(raw)} is not a number", cure)
    if isinstance(raw, str):
        return _number_in(plain(raw), between)
    try:
        return float(raw)
    except OverflowError:
        raise CellError("the number is too large", "check the number") from None


def _number_in(text: str, between: str) -> float:
    """Number typed as text: plain digits with a decimal point, or a fraction of two whole numbers."""
    if _NUMBER.fullmatch(text):
        return float(text)
    if fraction := _FRACTION.fullmatch(text):
        return int(fraction[1]) / int(fraction[2])
    if not text:
        raise CellError("an item of the list is missing", "give a number on either side of each ;")
    if "," in text:
        cure = "use a point for decimals" + (f" and {between}" if between else ", and no thousands separator")
        raise CellError("a comma is not clear", cure)
    if text.casefold() in ("nan", "inf", "+inf", "-inf", "infinity"):
        raise CellError("is not a finite number", "give a number")
    if ";" in text:
        raise CellError("a list where one number is wanted", "give one number")
    if _WITH_UNIT.fullmatch(text):
        raise CellError("a number with something after it", "units belong into the header, e.g. span [m]")
    raise CellError("a text is not a number", "give a number" + (f", with {between}" if between else ""))


def _choice(column: Column, raw: Any) -> str:
    if not isinstance(raw, str):
        raise CellError(f"{_kind(raw)} is not one of the choices", likely(str(raw), column.choices))
    if raw in column.choices:
        return raw
    chosen = {_word(choice): choice for choice in column.choices}.get(_word(raw))
    if chosen is None:
        raise CellError("is not one of the choices", likely(plain(raw), column.choices))
    return chosen


def _word(text: str) -> str:
    """A choice however it is spaced and spelt."""
    return re.sub(r"[\s_-]+", "-", plain(text)).casefold()


def _yes_no(column: Column, raw: Any) -> bool:
    if isinstance(raw, bool):
        return raw
    answer = _YES_NO.get(plain(raw).casefold()) if isinstance(raw, str) else None
    if answer is None:
        raise CellError("is not yes or no", "give yes or no")
    return answer
