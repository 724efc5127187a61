"""Losses of a member's tendon along its ideal path.

They are kept for a while: a row is examined with them when it is read, and soon afterwards analysed.
"""

from collections.abc import Mapping
from functools import lru_cache
from types import SimpleNamespace
from typing import Any

from ptbatch.geometry.curve import Profile
from ptbatch.geometry.profile import ideal_profile
from ptbatch.losses import Losses, analytic_losses

PATH = ("span", "profile", "dp", "profile_points", "h", "inflection", "harp")
FRICTION = ("mu", "K", "Ep", "set", "jack")
KEPT = 256  # more than are read ahead of the analysis


def ideal_path(values: Mapping[str, Any]) -> Profile:
    """The path of a tendon without waves for wobble, by the columns of PATH."""
    return _path(tuple(values[name] for name in PATH))


def tendon_losses(values: Mapping[str, Any], fpj: float) -> Losses:
    """Mirrored losses of a tendon that is jacked to fpj, by the columns of PATH and FRICTION; raises as
    `analytic_losses`."""
    path = tuple(values[name] for name in PATH)
    return _losses(path, tuple(values[name] for name in FRICTION), fpj)


@lru_cache(KEPT)
def _path(path: tuple[Any, ...]) -> Profile:
    return ideal_profile(SimpleNamespace(**dict(zip(PATH, path, strict=True))))


@lru_cache(KEPT)
def _losses(path: tuple[Any, ...], friction: tuple[Any, ...], fpj: float) -> Losses:
    mu, K, Ep, wedge_set, jack = friction
    return analytic_losses(_path(path), fpj, mu, K, Ep, wedge_set, jack, reversal="mirror")
