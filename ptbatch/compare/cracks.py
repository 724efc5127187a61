"""What the cracks of a member amount to at a stage: numbers made of the rows of the sheet `cracks`."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Measure(NamedTuple):
    """A number made of places x and heights of the cracked stretches [mm], and its unit."""

    unit: str
    value: Callable[[Array, Array], float]


MEASURES = {
    "cracked_sections": Measure("", lambda x, height: len(np.unique(x))),
    "cracked_from": Measure("mm", lambda x, height: x.min()),
    "cracked_to": Measure("mm", lambda x, height: x.max()),
    "crack_height_mean": Measure("mm", lambda x, height: height.mean()),
    "crack_height_max": Measure("mm", lambda x, height: height.max()),
}


def measure(name: str, x: Array, top: Array, bottom: Array) -> float:
    """One of MEASURES, of cracks at x between these depths [mm], at least one."""
    return float(MEASURES[name].value(x, bottom - top))
