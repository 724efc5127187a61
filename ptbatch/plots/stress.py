"""Tendon stress along the member: after stressing with the analytic line, and redistributed under load."""

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes

from ptbatch.plots import style
from ptbatch.response import ANCHORED, END, JACKED, PEAK, SERVICE
from ptbatch.workbook.stored import Stored

X, FE, ANALYTIC = "x [mm]", "stress_fe [MPa]", "stress_analytic [MPa]"
STRESSING, LOADED = (JACKED, ANCHORED), (PEAK, END)
NARROWEST = 0.05  # of the stress: less would make the round-off of a frictionless tendon look like a loss
DASHES = {ANCHORED: (0, (1, 1.5)), PEAK: "-", END: (0, (5, 1.5))}


def draw_stress(axes: Axes, stored: Stored) -> None:
    """Stress at jacking and after anchoring beside the analytic one, as in the paper's Figs. 7, 9 and 10."""
    for stage in STRESSING:
        line = stored.tendon.stage(stage)
        if not len(line):
            continue
        look: dict[str, Any] = {"color": style.STAGES[stage], "marker": ".", "markersize": 4.5}
        x = line.numbers(X) / 1e3
        axes.plot(x, line.numbers(FE), label=f"{stage}, FE", gid=stage, **look)
        dashed: dict[str, Any] = {"color": style.INK, "linewidth": 0.9, "linestyle": (0, (4, 2)), "zorder": 3}
        axes.plot(x, line.numbers(ANALYTIC), label="analytic", gid=f"{stage} analytic", **dashed)
    _along(axes, [stored])
    handles, names = axes.get_legend_handles_labels()
    by_name = dict(zip(names, handles, strict=True))
    style.legend(axes, sorted(by_name.values(), key=lambda handle: handle.get_label() == "analytic"))


def draw_redistribution(axes: Axes, several: Sequence[Stored]) -> None:
    """Stress at the peak and at the end of the curve, as in Fig. 11; of one member also after anchoring and
    when time has taken its part."""
    for i, stored in enumerate(several):
        alone = len(several) == 1
        for stage in (ANCHORED, SERVICE, *LOADED) if alone else LOADED:
            line = stored.tendon.stage(stage)
            if not len(line):
                continue
            label = stage if alone else f"{stored.name}, {stage}"
            look: dict[str, Any] = {"color": style.STAGES[stage] if alone else style.colour(i)}
            look |= {"linestyle": "-" if alone else DASHES[stage], "gid": f"{stored.name} {stage}"}
            axes.plot(line.numbers(X) / 1e3, line.numbers(FE), label=label, **look)
    _along(axes, several)
    style.legend(axes, axes.get_legend_handles_labels()[0])


def _along(axes: Axes, several: Sequence[Stored]) -> None:
    members = [stored.member for stored in several if stored.member is not None]
    longest = max(members, key=lambda member: member.total_length)
    style.along(axes, longest.total_length, longest.support_x)
    axes.set_ylabel("tendon stress [MPa]")
    axes.margins(y=0.08)
    low, high = axes.get_ylim()
    middle, reach = 0.5 * (high + low), max(high - low, NARROWEST * high)
    axes.set_ylim(middle - 0.5 * reach, middle + 0.5 * reach)
