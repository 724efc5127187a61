"""From the record of a run to a Response: tendon states, elongations, curve."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ptbatch import stages
from ptbatch.events import Service, find_events
from ptbatch.model.loading import has_service_value
from ptbatch.response import ANCHORED, JACKED, PEAK, SET, Curve, Response, TendonState
from ptbatch.statics import node_values, section_moments

if TYPE_CHECKING:
    from ptbatch.analysis import Run

Array = NDArray[np.float64]

STAGE_ROWS = {JACKED: stages.JACKING, SET: stages.SETTING, ANCHORED: stages.ANCHORING}


def stopped(run: "Run", message: str) -> Response:
    """Response of a member that found no equilibrium in a stage before the live load: what was reached, and no capacity."""
    return Response(**_common(run), status="not converged", message=message)


def finished(run: "Run", complete: bool) -> Response:
    """Response of a member that was loaded; `complete` where the loading ended by itself."""
    common = _common(run)
    rows = _service_rows(run)
    curve = _curve(run, rows, common["tendon"][ANCHORED].length)
    service = Service(run.rig.case.model, run.rig.case.history.u[rows], run.rig.case.history.T[rows], curve)
    events, failure = find_events(service)
    if not complete and not failure:
        last = curve.load[-1]
        if last > 0.98 * curve.load.max():
            where = f"{last / 1e3:.4g} kN, deflection {curve.deflection[-1]:.4g} mm"
            return Response(
                **common, curve=curve, status="not converged", message=f"live load: no equilibrium found beyond {where}"
            )
        failure = "no equilibrium beyond the peak"
    peak = next(event for event in events if event.name == "peak")
    common["tendon"][PEAK] = _tendon_state(run, int(rows[int(peak.step)]))
    note = "" if complete else f"the curve ends at {curve.deflection[-1]:.4g} mm, where no further equilibrium was found"
    return Response(
        **common,
        curve=curve,
        events=events,
        failure=failure or "deflection limit",
        status="ok",
        message=note,
    )


def _common(run: "Run") -> dict[str, Any]:
    """What a run has whether or not it went on to the end."""
    history, setup = run.rig.case.history, run.setup
    used = slice(0, int(history.count[0]))
    last = {name: _last_row(run, stage) for name, stage in STAGE_ROWS.items()}
    common: dict[str, Any] = {
        "member": setup.member,
        "fpj": run.fpj,
        "losses": run.losses,
        "tendon": {name: _tendon_state(run, row) for name, row in last.items() if row is not None},
        "residual_max": float(history.residual[used].max(initial=0.0)),
        "newton_iterations": int(history.iterations[used].sum()),
        "has_service_value": has_service_value(setup.member),
    }
    for name, stage in (("elongation_before", JACKED), ("elongation_after", SET)):
        if last[stage] is not None:
            pulled = history.u[last[stage]][[0, -2]] - run.start.gap
            common[name] = float(pulled[list(setup.live)].sum())
    if last[SET] is not None:
        common["set_length"] = _set_length(run, last[JACKED], last[SET])
    if last[ANCHORED] is not None:
        common["camber"] = float(history.u[last[ANCHORED], 5 * setup.mesh.control + 3])
    return common


def _last_row(run: "Run", stage: int) -> int | None:
    history = run.rig.case.history
    rows = np.flatnonzero(history.stage[: history.count[0]] == stage)
    return int(rows[-1]) if rows.size else None


def _service_rows(run: "Run") -> NDArray[np.int64]:
    """Rows from the anchored state on."""
    first = _last_row(run, stages.ANCHORING)
    assert first is not None
    return np.arange(first, int(run.rig.case.history.count[0]))


def _tendon_state(run: "Run", row: int) -> TendonState:
    history, line, Aps = run.rig.case.history, run.setup.duct, run.setup.member.Aps
    s = history.s[row]
    middle = np.clip(0.5 * (s[1:] + s[:-1]), line.s[0], line.s[-1])
    fine = np.linspace(line.x[0], line.x[-1], 20 * len(line.x) + 1)
    moved = s - run.start.s
    return TendonState(
        np.interp(middle, run.setup.profile.arc_length(fine), fine),
        history.T[row] / Aps,
        0.5 * (moved[1:] + moved[:-1]),
        (float(history.anchor[row, 0] / Aps), float(history.anchor[row, 1] / Aps)),
        run.start.rest,
    )


def _set_length(run: "Run", jacked: int, after: int) -> float:
    """Length over which friction turned round, from the live end: the tributary lengths of the nodes whose step in force did, and the
    part of the last one's that did."""
    line, history = run.setup.duct, run.rig.case.history

    def steps(row: int) -> Array:
        force = np.concatenate([history.anchor[row, :1], history.T[row], history.anchor[row, 1:]])
        return np.diff(np.log(force))

    before = steps(jacked)
    if np.abs(before).sum() < 1e-9:
        return float(line.s[-1])
    s = np.concatenate([line.s[:1], history.s[after, 1:-1], line.s[-1:]])
    tributary = np.convolve(np.diff(s), [0.5, 0.5])
    safe = np.where(np.abs(before) > 1e-12, before, np.inf)
    turned = np.clip(0.5 * (1.0 - steps(after) / safe), 0.0, 1.0)
    if not run.setup.live[0]:
        turned, tributary = turned[::-1], tributary[::-1]
    whole = int(np.argmax(turned < 0.99)) if (turned < 0.99).any() else len(turned)
    return float((turned * tributary)[: whole + 1].sum())


def _curve(run: "Run", rows: NDArray[np.int64], length: Array) -> Curve:
    history, setup = run.rig.case.history, run.setup
    Aps = setup.member.Aps
    factor, u, T = history.factor[rows], history.u[rows], history.T[rows]
    up = node_values(u, len(setup.mesh.x), 1)[:, setup.mesh.control]
    ends = history.anchor[rows] / Aps
    moments = [section_moments(setup.mesh.x, u[i], history.f[row]) for i, row in enumerate(rows)]
    return Curve(
        factor,
        factor * setup.live_total,
        setup.mesh.sense * (up - up[0]),
        np.array([moment.ravel()[np.argmax(np.abs(moment))] for moment in moments]),
        np.minimum(T.min(axis=1) / Aps, ends.min(axis=1)),
        np.average(T, axis=1, weights=length) / Aps,
        np.maximum(T.max(axis=1) / Aps, ends.max(axis=1)),
    )
