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
    cracked = np.zeros((len(model.x) - 1, 2, len(model.layer_y)), bool)
    young = int(np.count_nonzero(~recorded.aged))  # rows before the concrete has crept and shrunk: the first
    found, done = [], 0
    for step in steps:
        middle = min(max(done, young), step + 1)
        cracked |= _cracked_by_height(recorded, slice(done, middle))
        for start in range(middle, step + 1, CHUNK):
            cracked |= _cracked_by_layer(recorded, slice(start, min(start + CHUNK, step + 1)))
        done = step + 1
        found.append(tuple(_stretches(cracked.reshape(-1, len(model.layer_y)), model, thickness)))
    return found


def _limit(model: Model) -> float:
    concrete = model.concrete
    return ROUND_OFF if concrete.tension_law == NO_TENSION else concrete.eps_cr


def _cracked_by_height(recorded: Recorded, steps: slice) -> NDArray[np.bool_]:
    """Which layers (n, 2, layers) crack in steps without creep or shrinkage. Strains are straight lines: a
    section cracks up to the height, or from the height on, where its line is at the limit."""
    model = recorded.model
    eps0, kappa = recorded.eps0[steps], recorded.kappa[steps]
    beyond = eps0 - _limit(model)
    with np.errstate(divide="ignore", invalid="ignore"):
        height = beyond / kappa
    up_to = np.where(kappa > 0.0, height, -np.inf).max(axis=0, initial=-np.inf)[..., None]
    from_on = np.where(kappa < 0.0, height, np.inf).min(axis=0, initial=np.inf)[..., None]
    through = ((kappa == 0.0) & (beyond > 0.0)).any(axis=0)[..., None]
    return np.asarray((model.layer_y < up_to) | (model.layer_y > from_on) | through)


def _cracked_by_layer(recorded: Recorded, steps: slice) -> NDArray[np.bool_]:
    """The same in any steps."""
    return np.asarray(recorded.layer_strain(steps).max(axis=0) > _limit(recorded.model))


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
