"""The crack map: the cracked depth of every section, on the elevation of the member."""

from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from ptbatch.plots import style
from ptbatch.plots.elevation import draw_body
from ptbatch.response import ANCHORED, END, PEAK
from ptbatch.workbook.stored import Stored

LOOK = {  # colour, width, name
    END: (style.SKY, 3.2, "at the end"),
    PEAK: (style.INK, 1.1, "at the peak"),
    ANCHORED: (style.ORANGE, 2.4, "after anchoring"),
}


def draw_cracks(axes: Axes, stored: Stored) -> None:
    """Cracks as in the paper's Fig. 13. Later stages are drawn wider and below: what they add shows."""
    member = stored.member
    assert member is not None  # by `missing`
    draw_body(axes, member)
    handles: list[Line2D] = []
    for stage, (ink, width, name) in LOOK.items():
        cracks = stored.cracks.stage(stage)
        if not len(cracks):
            continue
        x, top, bottom = (cracks.numbers(header) for header in ("x [mm]", "crack_from [mm]", "crack_to [mm]"))
        axes.vlines(x / 1e3, top, bottom, color=ink, linewidth=width, gid=stage, zorder=2.5)
        handles.insert(0, Line2D([], [], color=ink, linewidth=width, label=f"cracked {name}"))
    if not handles:
        axes.text(0.5, 0.75, "no cracks", transform=axes.transAxes, ha="center", color=style.GREY)
    style.legend(axes, handles)
