"""The cross-section, to scale: concrete, the tendon where it lies lowest and highest, bars."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ptbatch.member import Member
from ptbatch.plots import style
from ptbatch.plots.elevation import tendon_line
from ptbatch.workbook.column import System
from ptbatch.workbook.systems import shown

COVER = 0.1  # of the width there: bars keep this far from the sides


def draw_section(axes: Axes, member: Member, system: System) -> None:
    """Section with its outer sizes in mm or in."""
    axes.add_patch(PathPatch(outline(member), facecolor=style.CONCRETE, edgecolor=style.INK, linewidth=0.9))
    for bar in member.all_bars:
        _bar_row(axes, member, bar.depth, bar.x_end - bar.x_start < 0.999 * member.total_length)
    depths = tendon_line(member)[1]
    for depth, fill in ((depths.min(), "white"), (depths.max(), style.TENDON)):
        x, _ = _concrete_at(member, depth)
        look: dict[str, Any] = {"color": style.TENDON, "markerfacecolor": fill, "markersize": 6.5}
        axes.plot(x, len(x) * [depth], "o", gid="tendon", **look)
    reach = max(member.b, member.b_bottom or 0.0) / 2.0
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlim(-1.12 * reach, 1.12 * reach)
    axes.set_ylim(max(1.06 * member.h, 1.05 * depths.max()), -0.06 * member.h)
    axes.set_axis_off()
    factor = shown("mm", system)[1]
    _size(axes, f"{member.b * factor:g}", (0.0, 0.0), (0, 4), "bottom", "center")
    _size(axes, f"{member.h * factor:g}", (-reach, member.h / 2.0), (-4, 0), "center", "right")


def _size(axes: Axes, text: str, at: tuple[float, float], offset: tuple[int, int], va: str, ha: str) -> None:
    look: Any = {"va": va, "ha": ha, "rotation": 90 if ha == "right" else 0, "fontsize": 8}
    axes.annotate(text, at, offset, textcoords="offset points", **look)


def outline(member: Member) -> Path:
    """Edge of the concrete, x from the axis and depth below the top fibre [mm]; of a box also its void."""
    b, h = member.b, member.h
    if member.shape == "rectangle":
        return _closed([(b, 0.0), (b, h)])
    bw, hf = member.bw or 0.0, member.hf or 0.0
    if member.shape == "tee":
        return _closed([(b, 0.0), (b, hf), (bw, hf), (bw, h)])
    b_bottom, hf_bottom = member.b_bottom or 0.0, member.hf_bottom or 0.0
    bottom = [(b_bottom, h - hf_bottom), (b_bottom, h)]
    if member.shape == "i":
        return _closed([(b, 0.0), (b, hf), (bw, hf), (bw, h - hf_bottom), *bottom])
    outside = min(b, b_bottom)  # the webs stand at the edges of the narrower flange
    shell = _closed([(b, 0.0), (b, hf), (outside, hf), (outside, h - hf_bottom), *bottom])
    void = _closed([(bw - outside, hf), (bw - outside, h - hf_bottom)])  # the other way round: a hole
    return Path.make_compound_path(shell, void)


def _closed(widths: list[tuple[float, float]]) -> Path:
    """Symmetric polygon from (width, depth) down its right side."""
    right = np.array([(width / 2.0, depth) for width, depth in widths])
    left = right[::-1] * (-1.0, 1.0)
    points = np.vstack([right, left, right[:1]])
    return Path(points, [Path.MOVETO, *[Path.LINETO] * (len(points) - 2), Path.CLOSEPOLY])


def _bar_row(axes: Axes, member: Member, depth: float, part: bool) -> None:
    """A row of dots for an area of bars, whose number nobody gave; hollow where they do not run through."""
    middles, width = _concrete_at(member, depth)
    spread = np.linspace(COVER - 0.5, 0.5 - COVER, 4 // len(middles)) * width
    x = np.add.outer(middles, spread).ravel()
    fill = "white" if part else style.BARS
    axes.plot(x, len(x) * [depth], "o", color=style.BARS, markerfacecolor=fill, markersize=3.2, gid="bars")


def _concrete_at(member: Member, depth: float) -> tuple[list[float], float]:
    """Middles of the concrete at a depth, two where a box has its webs, and its width there [mm]."""
    bottom = member.b_bottom or member.b
    if member.shape == "rectangle" or depth <= (member.hf or 0.0):
        return [0.0], member.b
    if member.shape != "tee" and depth >= member.h - (member.hf_bottom or 0.0):
        return [0.0], bottom
    bw = member.bw or 0.0
    if member.shape != "box":
        return [0.0], bw
    middle = min(member.b, bottom) / 2.0 - bw / 4.0
    return [-middle, middle], bw / 2.0
