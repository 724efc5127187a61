"""The profile, ideal and adjusted."""

from types import SimpleNamespace

import numpy as np
from matplotlib.figure import Figure

from ptbatch.member import Member
from ptbatch.plots import profile as module
from ptbatch.plots.profile import draw_profile
from tests.members import IMAGINARY


def lines(member) -> dict:
    axes = Figure().subplots()
    draw_profile(axes, member)
    return {line.get_gid(): line for line in axes.lines if line.get_gid()}


def test_one_line_where_nothing_is_adjusted():
    drawn = lines(Member(**IMAGINARY))
    assert list(drawn) == ["adjusted"]
    assert drawn["adjusted"].get_ydata().max() == 787.0


def test_ideal_line_beside_the_adjusted_one(monkeypatch):
    """An adjustment of our own, so that the drawing does not hang on any wobble model."""
    real = module.tendon_profile

    def adjusted(member):
        deeper = 0.0 if member.wobble == "direct" else 5.0
        return real(SimpleNamespace(**{**vars(member), "dp": tuple(d + deeper for d in member.dp)}))

    monkeypatch.setattr(module, "tendon_profile", adjusted)
    member = SimpleNamespace(**{**vars(Member(**IMAGINARY)), "wobble": "sine", "total_length": 15200.0})
    member.support_x = (0.0, 15200.0)
    drawn = lines(member)
    gap = drawn["adjusted"].get_ydata() - drawn["ideal"].get_ydata()
    assert np.allclose(gap, 5.0)
