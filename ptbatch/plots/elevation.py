"""The elevation of a member: concrete, tendon, bars, supports, jacks and loads, depth and length to their own
scales."""

from collections import Counter
from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from ptbatch.along import Load
from ptbatch.geometry.profile import tendon_profile
from ptbatch.geometry.section import gross_section
from ptbatch.member import Member
from ptbatch.model.loading import has_service_value, live, sustained
from ptbatch.plots import style
from ptbatch.workbook.column import System
from ptbatch.workbook.systems import shown

Array = NDArray[np.float64]

SUPPORT = 7.0  # points
POINTS = 2001
BAND = 0.24  # height of a row of load arrows, in depths
ARROWS = 9  # to a whole member
SPIKE: dict[str, Any] = {"arrowstyle": "-|>,head_width=0.16,head_length=0.36", "linewidth": 0.8}


def draw_elevation(axes: Axes, member: Member, system: System) -> None:
    """Everything that one wants to see before an analysis; depths below the top fibre as in the workbook, the
    sizes in the legend in the units of a system."""
    draw_body(axes, member)
    _bars(axes, member)
    rows = [(sustained(member), style.DEAD), (live(member), style.LIVE)]
    top = 0.0
    for loads, ink in rows:
        if loads:
            _load_row(axes, member, loads, top, ink)
            top += BAND
    axes.set_ylim(top=-(top + 0.06) * member.h)
    style.legend(axes, _key(member, system))


def draw_body(axes: Axes, member: Member) -> None:
    """Concrete, tendon, supports and jacks alone."""
    end, h = member.total_length / 1e3, member.h
    axes.fill_between([0.0, end], 0.0, h, facecolor=style.CONCRETE, edgecolor=style.INK, linewidth=0.9)
    for depth in _flange_edges(member):
        axes.plot([0.0, end], [depth, depth], color=style.GREY, linewidth=0.5)
    x, path = tendon_line(member)
    axes.plot(x / 1e3, path, color=style.TENDON, linewidth=1.6, gid="tendon")
    _supports(axes, member)
    _anchors(axes, member, path[[0, -1]])
    style.along(axes, member.total_length)
    axes.grid(False)
    axes.set_ylim(max(1.2 * h, 1.05 * path.max()), -0.06 * h)  # also where the tendon lies too deep
    axes.set_ylabel("depth [mm]")
    axes.spines["left"].set_bounds(0.0, h)
    axes.set_yticks([tick for tick in axes.get_yticks() if 0.0 <= tick <= h])


def tendon_line(member: Member) -> tuple[Array, Array]:
    """x and depth of the tendon [mm], close enough to be drawn, the ends of its pieces among them."""
    profile = tendon_profile(member)
    x = np.union1d(np.linspace(0.0, member.total_length, POINTS), profile.breaks)
    return x, profile.depth(x)


def _flange_edges(member: Member) -> Array:
    """Depths where the section changes its width."""
    section = gross_section(member)
    return np.cumsum(section.thickness)[:-1][np.diff(section.width) != 0.0]


def _supports(axes: Axes, member: Member) -> None:
    """Triangle for a pin, circle for a roller, a wall for a fixed end; under the member, sized in points."""
    for x, kind in zip(member.support_x, member.supports, strict=True):
        if kind == "fixed":
            axes.plot(2 * [x / 1e3], [-0.05 * member.h, 1.15 * member.h], color=style.INK, linewidth=4.0)
            continue
        if kind != "free":
            place = style.moved(axes, axes.transData, 0.0, -SUPPORT / 2.0 - 1.0)
            look: dict[str, Any] = {"color": style.INK, "markerfacecolor": "white", "clip_on": False}
            marker = "^" if kind == "pin" else "o"
            axes.plot(x / 1e3, member.h, marker=marker, markersize=SUPPORT, transform=place, **look)


def _anchors(axes: Axes, member: Member, depths: Iterable[float]) -> None:
    """A head that points outwards at a live end, a plate at a dead one."""
    ends = (0.0, member.total_length / 1e3)
    for side, x, depth in zip(("left", "right"), ends, depths, strict=True):
        live_end = member.jack in (side, "both")
        outwards = -1.0 if side == "left" else 1.0
        place = style.moved(axes, axes.transData, outwards * (4.0 if live_end else 1.5), 0.0)
        marker = {"left": "<", "right": ">"}[side] if live_end else "|"
        look: dict[str, Any] = {"color": style.TENDON, "clip_on": False, "zorder": 4}
        look |= {"markersize": 6} if live_end else {"markersize": 9, "markeredgewidth": 2.5}
        axes.plot(x, depth, marker=marker, transform=place, **look)


def _bars(axes: Axes, member: Member) -> None:
    for bar in member.all_bars:
        axes.plot(
            [bar.x_start / 1e3, bar.x_end / 1e3], 2 * [bar.depth], color=style.BARS, linewidth=1.0, gid="bars"
        )


def _load_row(axes: Axes, member: Member, loads: list[Load], top: float, ink: str) -> None:
    """Arrows of some loads; top: how much of the space above the member is taken, in depths."""
    h = member.h
    tip, tail = -(top + 0.03) * h, -(top + BAND - 0.03) * h
    for load in loads:
        if load.type == "point":
            _arrow(axes, load.x, tail, tip, ink, 1.3)
            continue
        count = max(2, round(ARROWS * len(member.span) * (load.x_end - load.x) / member.total_length) + 1)
        axes.plot([load.x / 1e3, load.x_end / 1e3], 2 * [tail], color=ink, linewidth=0.8)
        for x in np.linspace(load.x, load.x_end, count):
            _arrow(axes, x, tail, tip, ink, 0.7)


def _arrow(axes: Axes, x: float, tail: float, tip: float, ink: str, width: float) -> None:
    look = SPIKE | {"color": ink, "linewidth": width, "shrinkA": 0.0, "shrinkB": 0.0}
    axes.annotate("", (x / 1e3, tip), (x / 1e3, tail), arrowprops=look, annotation_clip=False)


def _key(member: Member, system: System) -> list[Line2D]:
    """What the lines are, with their sizes."""
    depths = tendon_line(member)[1]
    bars = Counter((bar.depth, bar.area) for bar in member.all_bars)
    length, (_, per_area) = shown("mm", system), shown("mm2", system)
    steel = "; ".join(
        f"{style.small(area * per_area)} at {depth * length[1]:.6g}" for depth, area in sorted(bars)
    )
    low, high = depths.min() * length[1], depths.max() * length[1]
    reach = f"{low:.4g}" if np.ptp(depths) < 1e-6 else f"{low:.4g} to {high:.4g}"
    tendon = f"tendon {style.amount(member.intact_area, 'mm2', system)} at {reach} {length[0]}"
    lines: list[tuple[str, str, float]] = [(tendon, style.TENDON, 1.6)]
    lines += [(f"bars {steel} {length[0]}", style.BARS, 1.0)] if steel else []
    dead = told(sustained(member), system)
    lines += [(f"sustained {dead}", style.DEAD, 0.8)] if dead else []
    pattern = told(live(member), system) if has_service_value(member) else "pattern (no service value)"
    lines += [(f"live {pattern}", style.LIVE, 0.8)]
    return [Line2D([], [], color=ink, linewidth=width, label=text) for text, ink, width in lines]


def told(loads: list[Load], system: System = "SI") -> str:
    """Loads in words: `10 kN/m`, `2 × 15 kN`."""
    counts = Counter((load.type, load.value) for load in loads)
    words = []
    for (kind, value), count in counts.items():
        unit, factor = shown("kN" if kind == "point" else "kN/m", system)
        size = f"{(value / 1e3 if kind == 'point' else value) * factor:.4g} {unit}"
        words.append(f"{count} × {size}" if count > 1 and kind == "point" else size)
    return ", ".join(words)
