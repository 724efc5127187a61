"""A workbook of 2,000 rows with fifty faults sown into it, each of another kind, at places drawn by seed."""

from collections.abc import Iterator
from datetime import date, time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from openpyxl import Workbook
from openpyxl.utils import get_column_letter

ROWS = 2000
LIGHT = {
    "span": 6000, "b": 250, "h": 450, "fc": 35, "Aps": 300, "dp": "225; 380; 225", "fpj": 1300, "fpe": None,
    "As": 300, "ds": 410, "w_dead": 4, "w_live": 8, "elements": 4, "layers": 8, "shape": None, "jack": None,
    "ft": None, "set": None, "mu": None, "K": None, "k_ec2": None, "self_weight": None, "support_right": None,
    "profile": None, "harp": None, "inflection": None, "live": None, "P_live": None, "live_spans": None,
    "bw": None, "hf": None, "crushing_strain": None, "deflection_limit": 12,
}  # fmt: skip
HEADERS = ("member", *LIGHT)


class Fault(NamedTuple):
    """What is typed into a row, by column; the column at fault; a piece of what must be said of it."""

    typed: dict[str, Any]
    column: str
    said: str


def _one(column: str, value: Any, said: str, **others: Any) -> Fault:
    return Fault({column: value, **others}, column, said)


FAULTS = (
    _one("fc", "forty", "a text is not a number"),
    _one("fc", "12,5", "a comma is not clear"),
    _one("span", "6000, 7000", "a comma is not clear"),
    _one("span", "6000;;7000", "an item of the list is missing"),
    _one("b", "250 mm", "a number with something after it"),
    _one("b", "250;300", "a list where one number is wanted"),
    _one("fc", "NaN", "is not a finite number"),
    _one("Aps", "inf", "is not a finite number"),
    _one("fc", "#DIV/0!", "the cell shows the error #DIV/0!"),
    _one("h", "#REF!", "the cell shows the error #REF!"),
    _one("fc", True, "TRUE or FALSE is not a number"),
    _one("b", date(2024, 3, 1), "a date or time is not a number"),
    _one("h", time(3, 4), "a date or time is not a number"),
    _one("b", -300, "must be above zero"),
    _one("h", 0, "must be above zero"),
    _one("Aps", "\u2212300", "must be above zero"),
    _one("fc", None, "missing"),
    _one("Aps", " \u00a0 ", "missing"),
    _one("fc", "=20+15", "the formula has no stored value"),
    _one("dp", "225; 700; 225", "lies outside the section"),
    _one("dp", "225; 380", "2 depths given"),
    _one("dp", "225; low; 225", "a text is not a number"),
    _one("fpj", 2500, "above fpu"),
    _one("fpj", None, "neither fpj nor fpe is given"),
    _one("fpe", 1000, "both fpj and fpe are given"),
    _one("shape", "rectangel", "is not one of the choices"),
    _one("jack", "top", "is not one of the choices"),
    _one("jack", 1, "is not one of the choices"),
    _one("self_weight", "perhaps", "is not yes or no"),
    _one("elements", 12.5, "is not a whole number"),
    _one("elements", -4, "must be"),
    _one("layers", "many", "a text is not a number"),
    _one("mu", -0.1, "must be zero or more"),
    _one("set", "six", "a text is not a number"),
    _one("ds", 600, "lie outside the section"),
    Fault({"As": "300; 200"}, "ds", "1 depth for 2 areas"),
    _one("w_dead", -5, "must be zero or more"),
    _one("live", "everywhere", "is not one of the choices"),
    _one("live_spans", 3, "there is no span 3"),
    _one("inflection", 1.5, "must be between 0 and 1"),
    _one("harp", "0.7; 0.3", "not in order", profile="harped"),
    _one("support_right", "hinge", "is not one of the choices"),
    _one("k_ec2", 0.01, "both K and k_ec2 are given", K=0.003),
    _one("bw", 500, "wider than a flange", shape="tee", hf=100),
    _one("hf", None, "shape tee needs it", shape="tee", bw=120),
    _one("crushing_strain", 35, "must be between 0 and 1"),
    _one("crushing_strain", 0.0002, "hognestad peaks"),
    _one("member", None, "missing"),
    _one("member", date(2025, 1, 2), "a date or time is not a member"),
    _one("member", "G0007", "the same name stands in"),
)


class Sown(NamedTuple):
    """A fault where it was sown: row of the sheet and cell."""

    fault: Fault
    row: int
    cell: str


def rows(seed: int) -> tuple[list[dict[str, Any]], list[Sown]]:
    """All rows, by column, and what is wrong in them; loads and strengths differ from row to row."""
    rng = np.random.default_rng(seed)
    # not into the first rows, one of which shall have its name taken by another
    places = np.sort(rng.choice(np.arange(20, ROWS), len(FAULTS), replace=False))
    sound = [
        {"member": f"G{i:04d}", **LIGHT, "fc": 30 + i % 20, "w_live": round(8.0 + 6.0 * i / ROWS, 3)}
        for i in range(ROWS)
    ]
    sown = []
    for place, fault in zip(places, rng.permutation(len(FAULTS)), strict=True):
        chosen = FAULTS[fault]
        sound[place] |= chosen.typed
        column = get_column_letter(HEADERS.index(chosen.column) + 1)
        sown.append(Sown(chosen, int(place) + 2, f"{column}{place + 2}"))
    return sound, sown


def write(path: Path, content: list[dict[str, Any]]) -> Path:
    """The rows as a workbook."""
    book = Workbook(write_only=True)
    sheet = book.create_sheet("members")
    for line in _lines(content):
        sheet.append(line)
    book.save(path)
    return path


def _lines(content: list[dict[str, Any]]) -> Iterator[list[Any]]:
    yield list(HEADERS)
    for row in content:
        yield [row[header] for header in HEADERS]
