"""Where the concrete has cracked: stretches of depth, section by section, at a few steps of the record."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.concrete import ELASTIC, NO_TENSION
from ptbatch.core.model import Model
from ptbatch.events import Recorded, gauss_places
from ptbatch.response import Crack

Array = NDArray[np.float64]

CHUNK = 64  # recorded steps at a time
ROUND_OFF = 1e-9  # strain below which concrete without tension counts as not strained


def cracks_at(recorded: Recorded, steps: Sequence[int], thickness: Array) -> list[tuple[Crack, ...]]:
    """Cracks at each of the given steps (rising) of what was recorded from the first stage on.

    A layer counts as cracked once its largest strain so far, at mid-layer, has exceeded ft / Ec (Huang and
    Kang 2018, Fig. 13); any tension does without a tension law. thickness (layers,) [mm], from the top down.
    """
    model = recorded.model
    if model.concrete.law == ELASTIC:
        return [() for _ in steps]
    worst = np.full((2 * (len(model.x) - 1), len(model.layer_y)), -np.inf)
    found, done = [], 0
    for step in steps:
        for start in range(done, step + 1, CHUNK):
            _raise_to(worst, recorded, slice(start, min(start + CHUNK, step + 1)))
        done = step + 1
        found.append(tuple(_stretches(worst > _limit(model), model, thickness)))
    return found


def _limit(model: Model) -> float:
    concrete = model.concrete
    return ROUND_OFF if concrete.tension_law == NO_TENSION else concrete.eps_cr


def _raise_to(worst: Array, recorded: Recorded, steps: slice) -> None:
    """Raise the largest strains (sections, layers) to those of more steps."""
    np.maximum(worst, recorded.layer_strain(steps).max(axis=0).reshape(worst.shape), out=worst)


def _stretches(cracked: NDArray[np.bool_], model: Model, thickness: Array) -> Iterator[Crack]:
    """Runs of cracked layers, along the member and then downwards."""
    edges = np.append(0.0, np.cumsum(thickness))
    framed = np.zeros((len(cracked), cracked.shape[1] + 2), np.int8)
    framed[:, 1:-1] = cracked
    change = np.diff(framed, axis=1)
    section, first = np.nonzero(change > 0)
    _, after = np.nonzero(change < 0)
    columns = gauss_places(model.x).ravel()[section], edges[first], edges[after]
    return map(Crack, *(column.tolist() for column in columns))
