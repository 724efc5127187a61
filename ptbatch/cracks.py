"""Where the concrete has cracked: stretches of depth, section by section, at a few steps of the record."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.concrete import ELASTIC, NO_TENSION
from ptbatch.core.model import Model
from ptbatch.events import sections
from ptbatch.response import Crack

Array = NDArray[np.float64]

CHUNK = 64  # recorded steps at a time
ROUND_OFF = 1e-9  # strain below which concrete without tension counts as not strained


def cracks_at(model: Model, u: Array, steps: Sequence[int], thickness: Array) -> list[tuple[Crack, ...]]:
    """Cracks at each of the given steps (rising) of the displacements u (rows, ndof) recorded from the first
    stage on.

    A layer counts as cracked once its largest strain so far, at mid-layer, has exceeded ft / Ec (Huang and
    Kang 2018, Fig. 13); any tension does without a tension law. thickness (layers,) [mm], from the top down.
    """
    if model.concrete.law == ELASTIC:
        return [() for _ in steps]
    worst = np.full((2 * (len(model.x) - 1), len(model.layer_y)), -np.inf)
    found, done = [], 0
    for step in steps:
        for start in range(done, step + 1, CHUNK):
            _raise_to(worst, model, u[start : min(start + CHUNK, step + 1)])
        done = step + 1
        found.append(tuple(_stretches(worst > _limit(model), model, thickness)))
    return found


def _limit(model: Model) -> float:
    concrete = model.concrete
    return ROUND_OFF if concrete.tension_law == NO_TENSION else concrete.eps_cr


def _raise_to(worst: Array, model: Model, u: Array) -> None:
    """Raise the largest strains (sections, layers) to those of more steps."""
    eps0, kappa, _ = sections(model.x, u)
    strain = eps0.reshape(len(u), -1, 1) - model.layer_y * kappa.reshape(len(u), -1, 1)
    np.maximum(worst, strain.max(axis=0), out=worst)


def _stretches(cracked: NDArray[np.bool_], model: Model, thickness: Array) -> Iterator[Crack]:
    """Runs of cracked layers, along the member and then downwards."""
    _, _, place = sections(model.x, np.zeros((1, 5 * len(model.x) + 2)))
    edges = np.append(0.0, np.cumsum(thickness))
    change = np.diff(np.pad(cracked.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    section, first = np.nonzero(change > 0)
    _, after = np.nonzero(change < 0)
    columns = place.ravel()[section], edges[first], edges[after]
    return map(Crack, *(column.tolist() for column in columns))
