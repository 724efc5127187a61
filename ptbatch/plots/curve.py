"""Load against deflection, with cracking, yield, peak and failure marked."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from ptbatch.plots import style
from ptbatch.workbook.column import System
from ptbatch.workbook.stored import Stored

LOAD, DEFLECTION = "load [kN]", "deflection [mm]"
MARKERS = {"cracking": "o", "yield": "^", "peak": "D"}
FAILURE = "x"


class Mark(NamedTuple):
    """An event on the curve: its name, deflection [mm], load [kN] and marker."""

    name: str
    deflection: float
    load: float
    marker: str


def draw_curve(axes: Axes, several: Sequence[Stored]) -> None:
    """Load-deflection curves as in the paper's Figs. 12, 14 and 15; what follows a failure is dotted."""
    alone = len(several) == 1
    handles = []
    for i, stored in enumerate(several):
        if not len(stored.curves):
            continue
        look: dict[str, Any] = {"color": style.colour(i), "linestyle": style.dashes(i)}
        (line,) = axes.plot(*_until_failure(stored), label=stored.name, gid=stored.name, **look)
        ink = look["color"]
        axes.plot(*_after_failure(stored), color=ink, linewidth=0.9, linestyle=(0, (1, 1.5)))
        handles += [] if alone else [line]
        for mark in marks(stored):
            axes.plot(mark.deflection, mark.load, gid=mark.name, **_look(mark.marker, ink))
    axes.set_xlabel("deflection at the control point [mm]")
    axes.set_ylabel("live load [kN]")
    axes.set_ylim(bottom=0.0)
    axes.margins(y=0.08)
    axes.set_xlim(left=axes.dataLim.xmin)
    style.legend(axes, handles + _key(several))


def marks(stored: Stored) -> list[Mark]:
    """The events of a member at their place on the curve, in their order."""
    found = [Mark(name, *_place(stored, name), marker) for name, marker in MARKERS.items()]
    failure = stored.value("failure_deflection [mm]"), stored.value("failure_load [kN]")
    found.append(Mark(str(stored.summary.get("failure")), *failure, FAILURE))
    return [mark for mark in found if np.isfinite(mark.load) and np.isfinite(mark.deflection)]


def _place(stored: Stored, name: str) -> tuple[float, float]:
    """(deflection, load) of an event: by its load between the steps before and after it, or the step itself
    where the summary gives no load; nan where it did not happen."""
    if name == "peak":
        return stored.value("deflection_peak [mm]"), stored.value("load_peak [kN]")
    events = [str(row.get("event") or "").split(", ") for row in stored.curves.rows]
    step = next((i for i, names in enumerate(events) if name in names), None)
    if step is None:
        return np.nan, np.nan
    load, deflection = stored.curves.numbers(LOAD), stored.curves.numbers(DEFLECTION)
    at = stored.value(f"load_{name} [kN]")
    if step == 0 or not load[step - 1] <= at <= load[step]:
        return float(deflection[step]), float(load[step])
    between = [step - 1, step]
    return float(np.interp(at, load[between], deflection[between])), at


def _until_failure(stored: Stored) -> tuple[Any, Any]:
    """(deflection, load) up to the failure of a material, or the whole curve."""
    deflection, load = stored.curves.numbers(DEFLECTION), stored.curves.numbers(LOAD)
    end = stored.value("failure_deflection [mm]")
    if not np.isfinite(end):
        return deflection, load
    before = deflection < end
    return (
        np.append(deflection[before], end),
        np.append(load[before], stored.value("failure_load [kN]")),
    )


def _after_failure(stored: Stored) -> tuple[Any, Any]:
    end = stored.value("failure_deflection [mm]")
    deflection, load = stored.curves.numbers(DEFLECTION), stored.curves.numbers(LOAD)
    after = deflection > end
    return np.append(end, deflection[after]), np.append(stored.value("failure_load [kN]"), load[after])


def _look(marker: str, ink: str) -> dict[str, Any]:
    return {"marker": marker, "color": ink, "markerfacecolor": "white", "linestyle": "none", "zorder": 3}


def _told(mark: Mark, system: System) -> str:
    """Load and deflection."""
    load = style.amount(mark.load, "kN", system)
    return f"{load}, {style.amount(mark.deflection, 'mm', system, 3)}"


def _key(several: Sequence[Stored]) -> list[Line2D]:
    """What the markers mean: of one member with its loads, else by name alone."""
    if len(several) == 1:
        texts = [(f"{mark.name} {_told(mark, several[0].system)}", mark.marker) for mark in marks(several[0])]
    else:
        used = {mark.marker for stored in several for mark in marks(stored)}
        named = [*MARKERS.items(), ("failure of a material", FAILURE)]
        texts = [(name, marker) for name, marker in named if marker in used]
    ink = style.colour(0) if len(several) == 1 else style.GREY
    return [Line2D([], [], label=text, **_look(marker, ink)) for text, marker in texts]
