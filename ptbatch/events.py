"""Cracking, yield, peak and failure, found on the recorded curve."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ptbatch.core.beam import GAUSS
from ptbatch.core.concrete import ELASTIC, NO_TENSION
from ptbatch.core.model import Model
from ptbatch.core.tendon import ELASTIC_TENDON
from ptbatch.response import Curve, Event
from ptbatch.statics import node_values

Array = NDArray[np.float64]

CRUSHING, TENDON_RUPTURE, BAR_RUPTURE = "concrete crushing", "tendon rupture", "bar rupture"
REACHED = 0.9999  # of a limit strain counts as reached: steps land on it to 0.5 %


@dataclass(frozen=True)
class Recorded:
    """Steps as recorded: eps0 (steps, n, 1) and kappa (steps, n, 2) of the Gauss sections, T (steps, tendon
    elements), the tendon's largest strain (steps,); which of them (steps,) come after the concrete has crept
    and shrunk, and the strain that it did so by in all layers (n, 2, layers), tension positive."""

    model: Model
    eps0: Array
    kappa: Array
    T: Array
    strain: Array
    aged: NDArray[np.bool_]
    free: Array

    def since(self, step: int) -> "Recorded":
        """The steps from one on."""
        steps = slice(step, None)
        strains = self.eps0[steps], self.kappa[steps]
        return Recorded(self.model, *strains, self.T[steps], self.strain[steps], self.aged[steps], self.free)

    def layer_strain(self, steps: slice) -> Array:
        """Strain that the layers of concrete have their stress from (steps, n, 2, layers)."""
        strain = self.eps0[steps, ..., None] - self.model.layer_y * self.kappa[steps, ..., None]
        aged = self.aged[steps]
        if aged.any():
            strain[aged] -= self.free
        return np.asarray(strain)

    def face_strain(self) -> Array:
        """The same at the top and the bottom fibre (2, steps, n, 2)."""
        model, y = self.model, self.model.layer_y
        faces = np.stack([self.eps0 - height * self.kappa for height in (model.top, model.bottom)])
        if self.aged.any():
            free = self.free[..., [0, -1]]
            if len(y) > 1:  # on the line through the two layers next to it
                slopes = (free - self.free[..., [1, -2]]) / (y[[0, -1]] - y[[1, -2]])
                free = free + slopes * ([model.top, model.bottom] - y[[0, -1]])
            faces[:, self.aged] -= np.moveaxis(free, -1, 0)[:, None]
        return faces


def find_events(service: Recorded, curve: Curve) -> tuple[tuple[Event, ...], str]:
    """All events of the service stage (row 0 the anchored state) in their order, and the name of the first
    failure ('' where no material reached its limit).

    The peak is the largest load up to the first failure: a law that holds its last stress beyond the crushing
    strain lends no capacity.
    """
    measures = _measures(service)
    events = []
    for name, (measure, place) in measures.items():
        step = _crossing(measure, REACHED if name in (CRUSHING, TENDON_RUPTURE, BAR_RUPTURE) else 1.0)
        if step is not None:
            x = place[int(np.ceil(step))]
            events.append(Event(name, step, *_at(step, curve), float(x)))
    failures = [event for event in events if event.name in (CRUSHING, TENDON_RUPTURE, BAR_RUPTURE)]
    first = min(failures, key=lambda event: event.step, default=None)
    if first is not None:  # what comes later belongs to a member that has failed
        events = [event for event in events if event.step <= first.step]
    events.append(_peak(curve, first))
    return tuple(sorted(events, key=lambda event: event.step)), "" if first is None else first.name


def nearest_to_failure(recorded: Recorded) -> str:
    """Which material had come nearest to its limit strain in the last step, how near, and where."""
    limits = {CRUSHING: "crushing strain", BAR_RUPTURE: "rupture strain", TENDON_RUPTURE: "rupture strain"}
    parts = {CRUSHING: "concrete", BAR_RUPTURE: "a bar", TENDON_RUPTURE: "the tendon"}
    last = {
        name: (float(measure[-1]), float(place[-1]))
        for name, (measure, place) in _measures(recorded).items()
        if name in limits
    }
    if not last:
        return "all materials are elastic"
    name = max(last, key=lambda name: last[name][0])
    share, x = last[name]
    return f"{parts[name]} at x = {x:.0f} mm was then at {share:.0%} of its {limits[name]}"


def _peak(curve: Curve, failure: Event | None) -> Event:
    """The largest load up to the first failure, which may itself fall between two rows."""
    rows = len(curve.load) if failure is None else int(np.floor(failure.step)) + 1
    peak = int(np.argmax(curve.load[:rows]))
    if failure is not None and failure.load > curve.load[peak]:
        return replace(failure, name="peak")
    place = np.nan if failure is None else failure.place
    return Event("peak", float(peak), float(curve.load[peak]), float(curve.deflection[peak]), place)


def _at(step: float, curve: Curve) -> tuple[float, float]:
    """(load, deflection) at a fractional row."""
    return curve.at(step, curve.load), curve.at(step, curve.deflection)


def _crossing(measure: Array, limit: float) -> float | None:
    """Fractional row where a measure first reaches its limit."""
    over = np.flatnonzero(measure >= limit)
    if not over.size:
        return None
    i = int(over[0])
    if i == 0:
        return 0.0
    return i - 1 + float((limit - measure[i - 1]) / (measure[i] - measure[i - 1]))


def _measures(service: Recorded) -> dict[str, tuple[Array, Array]]:
    """By event: (largest demand over limit, place of it) for each row."""
    model = service.model
    concrete, steel, strand = model.concrete, model.steel, model.strand
    place, faces = gauss_places(model.x), service.face_strain()
    measures = {}
    if concrete.law != ELASTIC:
        eps_cr = 0.0 if concrete.tension_law == NO_TENSION else concrete.eps_cr
        measures["cracking"] = _largest(1.0 + (faces.max(axis=0) - eps_cr) / 1e-3, place)
        measures[CRUSHING] = _largest(-faces.min(axis=0) / concrete.crushing_strain, place)
    stress = service.T / strand.Aps
    pulled = model.x[stress.argmax(axis=1)]  # a tendon element lies about the beam node of its number
    tendon_yield = stress.max(axis=1) / strand.fpy, pulled
    if strand.law != ELASTIC_TENDON:
        measures["yield"] = tendon_yield
        measures[TENDON_RUPTURE] = service.strain / strand.epu, pulled
    if model.bar_y.size:
        bars = np.stack([np.abs(service.eps0 - y * service.kappa) for y in model.bar_y])  # (r, steps, n, 2)
        bars *= model.bar_area.T[:, None, :, None] > 0.0
        yields = bars * (steel.Es / model.bar_fy)[:, None, None, None]
        bar_yield, at = _largest(yields.max(axis=0), place)
        measures[BAR_RUPTURE] = _largest(bars.max(axis=0) / steel.esu, place)
        if "yield" in measures:
            at = np.where(bar_yield < tendon_yield[0], pulled, at)
            bar_yield = np.maximum(bar_yield, tendon_yield[0])
        measures["yield"] = bar_yield, at
    return measures


def section_strains(x: Array, u: Array) -> tuple[Array, Array]:
    """eps0 (rows, n, 1) and kappa (rows, n, 2) of the Gauss sections for displacements u (rows, ndof)."""
    length = np.diff(x)
    d = [np.diff(node_values(u, len(x), i), axis=-1) for i in range(2)]
    theta = node_values(u, len(x), 2)
    now = np.hypot(length + d[0], d[1])
    eps0 = (2.0 * length * d[0] + d[0] ** 2 + d[1] ** 2) / (now + length) / length
    turn = np.arctan2(d[1], length + d[0])
    one, two = theta[..., :-1] - turn, theta[..., 1:] - turn
    kappa = np.stack([((6.0 * xi - 4.0) * one + (6.0 * xi - 2.0) * two) / length for xi in GAUSS], axis=-1)
    return eps0[..., None], kappa


def gauss_places(x: Array) -> Array:
    """Places (n, 2) of the Gauss sections between nodes (n+1,)."""
    return np.asarray(x[:-1, None] + np.diff(x)[:, None] * np.array(GAUSS))


def _largest(measure: Array, place: Array) -> tuple[Array, Array]:
    """Largest over the sections of each row, and where."""
    flat = measure.reshape(len(measure), -1)
    at = flat.argmax(axis=1)
    return flat[np.arange(len(flat)), at], place.ravel()[at]
