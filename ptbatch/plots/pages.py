"""Figures put together: one kind of one or several members, or one page with all of a member."""

from collections.abc import Callable, Sequence
from textwrap import fill
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from ptbatch.member import Member
from ptbatch.plots import style
from ptbatch.plots.cracks import draw_cracks
from ptbatch.plots.curve import draw_curve
from ptbatch.plots.elevation import draw_elevation
from ptbatch.plots.missing import lack, missing, reason
from ptbatch.plots.profile import draw_profile
from ptbatch.plots.section import draw_section
from ptbatch.plots.stress import draw_redistribution, draw_stress
from ptbatch.workbook.column import System
from ptbatch.workbook.stored import Stored
from ptbatch.workbook.systems import shown

TITLES = {
    "stress": "Tendon stress after stressing",
    "redistribution": "Tendon stress under live load",
    "load-deflection": "Live load and deflection",
    "cracks": "Cracks",
}
OVERLAID: dict[str, Callable[[Axes, Sequence[Stored]], None]] = {
    "redistribution": draw_redistribution,
    "load-deflection": draw_curve,
}
SINGLE: dict[str, Callable[[Axes, Any], None]] = {
    "stress": draw_stress,
    "cracks": draw_cracks,
    "profile": lambda axes, stored: draw_profile(axes, stored.member),
}
WIDTH = 7.2  # inches
HEIGHTS = {"stress": 3.2, "redistribution": 3.6, "load-deflection": 4.4, "cracks": 2.3, "profile": 2.8}
LINE = 110  # characters of a footer


def figure_of(several: Sequence[Stored], kind: str, height: float | None = None) -> Figure:
    """One kind of figure: members laid over each other, or one below the other.

    height: of a panel in inches, in place of the usual one.
    """
    height = height or HEIGHTS[kind]
    with rc_context(style.RC):
        if kind in OVERLAID:
            sheet = _sheet(WIDTH, height)
            _panel(sheet.subplots(), several, kind, several[0].name if len(several) == 1 else TITLES[kind])
            return sheet
        sheet = _sheet(WIDTH, height * len(several))
        panels = sheet.subplots(len(several), 1, squeeze=False)[:, 0]
        for axes, stored in zip(panels, several, strict=True):
            _panel(axes, [stored], kind, stored.name)
        return sheet


def page_of(stored: Stored) -> Figure:
    """All panels of a member on one page."""
    with rc_context(style.RC):
        sheet = _sheet(10.0, 10.2)
        grid = sheet.add_gridspec(3, 12, height_ratios=(0.85, 1.0, 1.0))
        if stored.member is not None:
            _drawing(sheet, stored.member, stored.system, grid[0, :8], grid[0, 8:])
        places = [grid[1, :6], grid[1, 6:], grid[2, :6], grid[2, 6:]]
        for kind, place in zip(HEIGHTS, places, strict=False):
            _panel(sheet.add_subplot(place), [stored], kind, TITLES[kind])
        _head(sheet, stored.name, _outcome(stored))
        return sheet


def geometry_of(member: Member, system: System = "SI") -> Figure:
    """Elevation and cross-section, before any analysis."""
    with rc_context(style.RC):
        sheet = _sheet(10.0, 3.9)
        grid = sheet.add_gridspec(1, 12)
        _drawing(sheet, member, system, grid[0, :8], grid[0, 8:])
        _head(sheet, member.member, "")
        return sheet


def drawing_of(member: Member, system: System) -> Figure:
    """The same without a head, as wide as the other figures."""
    with rc_context(style.RC):
        sheet = _sheet(WIDTH, 2.9)
        grid = sheet.add_gridspec(1, 12)
        _drawing(sheet, member, system, grid[0, :9], grid[0, 9:])
        return sheet


def _sheet(width: float, height: float) -> Figure:
    engine = ConstrainedLayoutEngine(w_pad=0.08, h_pad=0.08, wspace=0.03, hspace=0.04)
    return Figure(figsize=(width, height), layout=engine)


def _head(sheet: Figure, title: str, footer: str) -> None:
    sheet.suptitle(title, x=0.01, ha="left", fontsize=12, fontweight="bold")
    if footer:
        sheet.supxlabel(fill(footer, LINE), x=0.01, ha="left", fontsize=8, color=style.GREY)


def _drawing(sheet: Figure, member: Member, system: System, left: Any, right: Any) -> None:
    elevation, section = sheet.add_subplot(left), sheet.add_subplot(right)
    draw_elevation(elevation, member, system)
    style.in_system(elevation, system)
    elevation.set_title("Elevation, not to scale")
    draw_section(section, member, system)
    section.set_title(f"Section [{shown('mm', system)[0]}]", pad=16)


def _panel(axes: Axes, several: Sequence[Stored], kind: str, title: str) -> None:
    """One panel, or a note of what the results lack for it."""
    axes.set_title(title)
    able = [stored for stored in several if not missing(stored, kind)]
    if not able:
        style.note(axes, "\n".join(fill(lack(stored, missing(stored, kind)), 56) for stored in several))
        return
    if kind in OVERLAID:
        OVERLAID[kind](axes, able)
    else:
        SINGLE[kind](axes, able[0])
    style.in_system(axes, able[0].system)


def _outcome(stored: Stored) -> str:
    """The footer of a page: how the member ended."""
    peak, factor = stored.value("load_peak [kN]"), stored.value("load_factor_peak")
    if not np.isfinite(peak):
        return reason(stored)
    (unit, factor_to), (length, per_m) = shown("kN", stored.system), shown("m", stored.system)
    text = f"peak {peak * factor_to:.4g} {unit}" + (
        f" (load factor {factor:.3f})" if np.isfinite(factor) else ""
    )
    x = stored.value("failure_x [mm]")
    place = f" at x = {x / 1e3 * per_m:.2f} {length}" if np.isfinite(x) else ""
    message = stored.summary.get("message")
    return f"{text}; {stored.summary['failure']}{place}" + (f"; {message}" if message else "")
