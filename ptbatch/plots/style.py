"""How all figures look: type, lines, colours that a colour-blind reader tells apart, axes and legends."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Transform, offset_copy

from ptbatch.workbook.column import System
from ptbatch.workbook.systems import shown
from ptbatch.workbook.units import parse_header

RC: Any = {
    **{"font.family": "DejaVu Sans", "font.size": 8.5, "text.parse_math": False},
    **{"axes.titlesize": 9.5, "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.titlepad": 7},
    **{"axes.labelsize": 8.5, "axes.linewidth": 0.7, "axes.edgecolor": "#555555", "axes.axisbelow": True},
    **{"axes.formatter.useoffset": False},
    **{"axes.spines.top": False, "axes.spines.right": False, "axes.grid": True},
    **{"grid.color": "#dddddd", "grid.linewidth": 0.5},
    **{"xtick.color": "#555555", "ytick.color": "#555555", "xtick.labelcolor": "black"},
    **{"ytick.labelcolor": "black", "xtick.major.width": 0.7, "ytick.major.width": 0.7},
    **{"lines.linewidth": 1.5, "lines.markersize": 6, "lines.markeredgewidth": 1.2},
    **{"legend.frameon": False, "legend.fontsize": 8, "legend.handlelength": 2.2},
    **{"savefig.dpi": 200, "svg.hashsalt": "ptbatch", "pdf.fonttype": 42},
}

# Okabe and Ito (2008), the darker ones first
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = "#0072B2", "#D55E00", "#009E73", "#AA4499", "#E69F00", "#56B4E9"
CYCLE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, "#000000")
INK, GREY, CONCRETE = "#222222", "#777777", "#ececea"
TENDON, BARS, LIVE, DEAD = VERMILION, BLUE, INK, GREY

LEGEND_BELOW = 32.0  # points below the axes: ticks and axis label are that high
LETTERS_PER_INCH = 15.0  # of a legend
LONGEST = 60  # text of a legend
TICKS, ROUND_OFF = 7, 1e-9

STAGES = {"jacked": GREY, "anchored": BLUE, "service": GREEN, "peak": VERMILION, "end": PURPLE}


def colour(i: int) -> str:
    """Colour of the i-th of several members."""
    return CYCLE[i % len(CYCLE)]


def dashes(i: int) -> Any:
    """Line style of the i-th of several members: every second one dashed, to show the one that it lies on."""
    return (0, (4, 1.5)) if i % 2 else "-"


def along(axes: Axes, length: float, supports: Iterable[float] = ()) -> None:
    """An axis along a member [mm], ticked in m, with its supports."""
    margin = 0.02 * length
    axes.set_xlim(-margin / 1e3, (length + margin) / 1e3)
    axes.set_xlabel("x [m]")
    for x in supports:
        axes.axvline(x / 1e3, color=GREY, linewidth=0.6, linestyle=(0, (1, 2)), zorder=0.5)


def in_system(axes: Axes, system: System) -> None:
    """Tell the axes, which are drawn in SI units, in those of a system: labels, and round ticks."""
    for axis in (axes.xaxis, axes.yaxis):
        label = axis.get_label_text()
        unit = parse_header(label).unit
        other, factor = shown(unit, system)
        if other == unit or axis.get_scale() != "linear":
            continue
        axis.set_label_text(label.replace(f"[{unit}]", f"[{other}]"))
        low, high = sorted(axis.get_view_interval())
        bounds = axes.spines["left"].get_bounds() if axis is axes.yaxis else None
        low, high = (low, high) if bounds is None else (max(low, bounds[0]), min(high, bounds[1]))
        locator = MaxNLocator(TICKS, steps=[1, 2, 2.5, 5, 10])
        ticks = np.array(locator.tick_values(low * factor, high * factor))
        ticks = ticks[(ticks >= low * factor - ROUND_OFF) & (ticks <= high * factor + ROUND_OFF)]
        axis.set_ticks(ticks / factor, [f"{tick:g}" for tick in ticks])


def legend(axes: Axes, handles: Sequence[Any]) -> None:
    """A legend under the axis label, where it covers nothing, in as many columns as there is room for."""
    if not handles:
        return
    place = moved(axes, axes.transAxes, 0.0, -LEGEND_BELOW)
    look: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (0.0, 0.0), "bbox_transform": place}
    look |= {"borderaxespad": 0.0, "borderpad": 0.0, "columnspacing": 1.6}
    labels = [short(str(handle.get_label())) for handle in handles]
    width = axes.get_position().width * _figure(axes).get_figwidth()
    axes.legend(handles, labels, ncols=_columns(labels, width), **look)


def moved(axes: Axes, base: Transform, x: float, y: float) -> Transform:
    """A transform moved by x to the right and y up, in points: for what keeps its size at any scale."""
    return offset_copy(base, _figure(axes), x=x, y=y, units="points")


def _figure(axes: Axes) -> Figure:
    figure = axes.figure
    assert isinstance(figure, Figure)  # there are no figures within figures here
    return figure


def _columns(labels: Sequence[str], inches: float) -> int:
    """Most columns that fit, each with its handle as wide as eight letters; too few rather than too many."""
    room = inches * LETTERS_PER_INCH
    for count in range(len(labels), 1, -1):
        columns = np.array_split([len(label) for label in labels], count)  # as a legend shares them out
        if sum(8 + column.max() for column in columns) <= room:
            return count
    return 1


def short(text: str) -> str:
    """A text that is no longer than a legend bears."""
    return text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."


def note(axes: Axes, text: str) -> None:
    """Say in the middle of empty axes why they are empty."""
    axes.set_xticks([])
    axes.set_yticks([])
    axes.spines[:].set_visible(False)
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GREY, wrap=True)


def small(number: float) -> str:
    """A number for a legend: four digits at most, no exponent."""
    return f"{number:.0f}" if abs(number) >= 1000 else f"{number:.4g}"


def amount(value: float, unit: str, system: System, digits: int = 4) -> str:
    """A value of an SI unit for a legend, in the unit of a system."""
    other, factor = shown(unit, system)
    value = value * factor + 0.0  # no -0
    number = f"{value:.{digits}g}" if digits < 4 else small(value)
    return f"{number} {other.replace('2', '²')}"
