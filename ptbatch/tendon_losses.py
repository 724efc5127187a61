"""Losses of a member's tendon along its ideal path.

They are kept for a while: a row is examined with them when it is read, and soon afterwards analysed.
"""

from collections.abc import Mapping
from functools import lru_cache
from types import SimpleNamespace
from typing import Any

from ptbatch.geometry.curve import Profile
from ptbatch.geometry.profile import DRAWN, KEPT, ideal_profile
from ptbatch.losses import Losses, analytic_losses

PATH = (*DRAWN, "h")  # the depth, which the tendon has to stay within
FRICTION = ("mu", "K", "Ep", "set", "jack")


def ideal_path(values: Mapping[str, Any]) -> Profile:
    """The path of a tendon without waves for wobble, by the columns of PATH."""
    return ideal_profile(SimpleNamespace(**values))


def tendon_losses(values: Mapping[str, Any], fpj: float) -> Losses:
    """Mirrored losses of a tendon that is jacked to fpj, by the columns of PATH and FRICTION; raises as
    `analytic_losses`."""
    return _losses(ideal_path(values), tuple(values[name] for name in FRICTION), fpj)


@lru_cache(KEPT)
def _losses(path: Profile, friction: tuple[Any, ...], fpj: float) -> Losses:
    mu, K, Ep, wedge_set, jack = friction
    return analytic_losses(path, fpj, mu, K, Ep, wedge_set, jack, reversal="mirror")
