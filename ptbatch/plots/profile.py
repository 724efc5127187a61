"""The tendon profile; where wobble is a sine on it, as in the paper's Fig. 8, beside the ideal one."""

from types import SimpleNamespace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ptbatch.geometry.profile import Profile, tendon_profile
from ptbatch.member import Member
from ptbatch.plots import style

POINTS = 4001
SAME = 1e-6  # mm


def draw_profile(axes: Axes, member: Member) -> None:
    """Depth of the tendon and the angle it turns by; the ideal profile dashed where the adjusted one differs
    from it."""
    ideal, adjusted = profiles(member)
    x = np.union1d(np.linspace(0.0, member.total_length, POINTS), adjusted.breaks)
    differ = bool(np.abs(adjusted.depth(x) - ideal.depth(x)).max() > SAME)
    label = f"{'adjusted for wobble' if differ else 'tendon'}: turns by {adjusted.total_angle:.3f} rad"
    axes.plot(x / 1e3, adjusted.depth(x), color=style.TENDON, linewidth=1.2, label=label, gid="adjusted")
    if differ:
        look: dict[str, Any] = {"color": style.INK, "linewidth": 0.9, "linestyle": (0, (4, 2))}
        axes.plot(x / 1e3, ideal.depth(x), label=f"ideal: {ideal.total_angle:.3f} rad", gid="ideal", **look)
    style.along(axes, member.total_length, member.support_x)
    axes.set_ylabel("depth below the top fibre [mm]")
    axes.margins(y=0.1)
    axes.invert_yaxis()
    style.legend(axes, axes.get_legend_handles_labels()[0])


def profiles(member: Member) -> tuple[Profile, Profile]:
    """The profile as drawn by the designer, and as the analysis takes it."""
    ideal = SimpleNamespace(**{**vars(member), "wobble": "direct"})
    return tendon_profile(ideal), tendon_profile(member)
