"""How the columns of a results sheet look: number formats and widths, from their headers."""

from ptbatch.workbook.units import parse_header

_BY_UNIT = {
    **{"MPa": "0.0", "mm": "0.00", "%": "0.00", "kN": "0.0", "kN m": "0.0", "ms": "0"},
    **{"ksi": "0.00", "in": "0.000", "ft": "0.00", "kip": "0.00", "kip ft": "0.0"},
}
_BY_NAME = {
    "ratio": "0.0000",
    "x": "0",
    "failure_x": "0",
    "load_factor": "0.000",
    "load_factor_peak": "0.000",
    "residual_max": "0.0E+00",
    **dict.fromkeys(("utilisation", "utilisation_max"), "0.00"),
    **dict.fromkeys(("demand", "limit"), "0.0"),
}
_WIDTHS = {
    **{"member": 26, "status": 14, "message": 70, "failure": 20, "event": 20, "stage": 10},
    **{"span": 18, "dp": 28, "note": 60},
    **{"what is wrong": 60, "how to put it right": 60, "value": 30, "name": 24, "meaning": 90, "default": 36},
    **{"column": 20, "choices": 46, "limit": 16},
    **{"case": 26, "quantity": 46, "ours": 12, "theirs": 12, "tolerance": 14, "verdict": 16, "because": 60},
    **{"check": 26, "clause": 26, "formula": 36, "numbers": 70, "reason": 50, "governing_check": 24},
    **{"to_read": 24, "warning": 40, "gauge": 12},
    **{"source": 60, "class": 12, "not_reproducible": 40},
}


def number_format(header: str) -> str:
    """Excel format of the numbers under a header."""
    name, unit = parse_header(header)
    if unit == "in" and _BY_NAME.get(name) == "0":  # a place: to a tenth
        return "0.0"
    return _BY_NAME.get(name) or _BY_UNIT.get(unit, "General")


def width(header: str) -> float:
    """Width of a column in characters, the unit standing below the name."""
    name, unit = parse_header(header)
    return _WIDTHS.get(name, min(max(10, len(name) + 2, len(unit) + 4), 40))
