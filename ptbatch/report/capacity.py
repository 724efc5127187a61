"""What the member bears: cracking, yield, peak and failure under live load."""

from typing import NamedTuple

import numpy as np

from ptbatch.plots.curve import marks
from ptbatch.report.words import DASH, Words, fixed
from ptbatch.workbook.stored import Stored

EVENTS = ("cracking", "yield", "peak")
AT_PEAK = (
    ("moment_peak [kN m]", "largest section moment, everything included", "kN m"),
    ("tendon_stress_peak_mean [MPa]", "mean tendon stress", "MPa"),
    ("tendon_stress_peak_max [MPa]", "largest tendon stress", "MPa"),
)


class Event(NamedTuple):
    """Something that happens under live load: load, load factor, deflection, place; or the reason why it does
    not, alone."""

    name: str
    load: str = ""
    factor: str = ""
    deflection: str = ""
    place: str = ""
    reason: str = ""


def events(stored: Stored) -> list[Event]:
    """Cracking, yield and peak, and the failure of a material, of which alone the results have the place."""
    found = {mark.name: mark for mark in marks(stored)}
    words, rows = Words(stored.system), []
    for name in EVENTS:
        load = stored.value(f"load_{name} [kN]")
        if np.isfinite(load):
            deflection = words.digits(found[name].deflection, "mm", 3) if name in found else DASH
            rows.append(
                Event(name, words.number(load, "kN"), _factor(stored, load), deflection, _place(stored, load))
            )
        else:
            rows.append(Event(name, reason=words.said(stored.summary.get(f"load_{name} [kN]"), "kN")))
    return [*rows, _failure(stored)]


def _place(stored: Stored, load: float) -> str:
    """Where a material fails, of an event under the same load."""
    x = stored.value("failure_x [mm]")
    fails = np.isfinite(x) and np.isclose(load, stored.value("failure_load [kN]"), rtol=1e-9)
    return f"x = {Words(stored.system).amount(x / 1e3, 'm')}" if fails else DASH


def _factor(stored: Stored, load: float) -> str:
    """Load factor that goes with a load [kN]."""
    peak, factor = stored.value("load_peak [kN]"), stored.value("load_factor_peak")
    return fixed(factor * load / peak, "-") if np.isfinite(factor) and peak else "no service load"


def _failure(stored: Stored) -> Event:
    """The first material at its limit strain; it has a place also where no load could come on."""
    name, x = f"failure: {stored.summary.get('failure')}", stored.value("failure_x [mm]")
    words = Words(stored.system)
    place = f"x = {words.amount(x / 1e3, 'm')}" if np.isfinite(x) else ""
    load = stored.value("failure_load [kN]")
    if not np.isfinite(load):
        why = words.said(stored.summary.get("failure_load [kN]"), "kN")
        return Event(name, reason="; ".join(filter(None, (why, place))))
    deflection = words.digits(stored.value("failure_deflection [mm]"), "mm", 3)
    return Event(name, words.number(load, "kN"), _factor(stored, load), deflection, place or DASH)


def at_peak(stored: Stored) -> list[tuple[str, str, str]]:
    """(what, value, unit) of other quantities at the peak."""
    words = Words(stored.system)
    return [
        (text, words.said(stored.summary.get(header), unit), words.unit(unit))
        for header, text, unit in AT_PEAK
        if np.isfinite(stored.value(header))
    ]


def quality(stored: Stored) -> str:
    """How well the analysis balances, and what it took."""
    residual, iterations = stored.value("residual_max"), stored.value("newton_iterations")
    if not np.isfinite(residual):
        return ""
    return (
        f"Largest out-of-balance of an accepted step {residual:.1e} of the jacking force; "
        f"{iterations:.0f} iterations."
    )
