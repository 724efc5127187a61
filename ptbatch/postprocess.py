"""From the record of a run to a Response: tendon states, elongations, curve."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptbatch import stages
from ptbatch.core.ramp import DONE, NO_EQUILIBRIUM
from ptbatch.cracks import cracks_at
from ptbatch.design.longterm import TimeLoss
from ptbatch.events import Recorded, find_events, nearest_to_failure, section_strains
from ptbatch.geometry.section import gross_section
from ptbatch.model.loading import has_service_value
from ptbatch.response import ANCHORED, END, JACKED, PEAK, SERVICE, SET, Curve, Event, Response, TendonState
from ptbatch.run import Run
from ptbatch.statics import node_values, section_moments

Array = NDArray[np.float64]

SLIGHT = 1e-3  # of the force: less friction than this along the whole tendon holds no set back
LIMIT = "deflection limit"
HELD = (
    "; its supports hold the member lengthwise, so that shrinkage cracks it through: let all but one of them "
    "be rollers, or give long_term_loss, which leaves the concrete alone"
)
SUSTAINED, AND_TIME = "the sustained load", "the sustained load and long-term losses"
STAGE_ROWS = {
    JACKED: stages.JACKING,
    SET: stages.SETTING,
    ANCHORED: stages.ANCHORING,
    SERVICE: stages.TIME,
}


def stopped(run: Run, stage: int, message: str, loss: TimeLoss | None = None) -> Response:
    """Response of a member that found no equilibrium in a stage before the live load: the stages before it,
    and no capacity."""
    common = _common(run, stage) | {"time_loss": loss}
    advice = HELD if stage == stages.TIME and loss and loss.eps_cs and _lengthwise(run) > 1 else ""
    return Response(**common, status="not converged", message=f"{message}{_why(run)}{advice}")


def _lengthwise(run: Run) -> int:
    """How many supports hold the member lengthwise."""
    return int(np.count_nonzero(node_values(run.rig.case.model.held, len(run.setup.mesh.x), 0)))


def _why(run: Run) -> str:
    """What may have stopped a run, from its last step; empty before the first one."""
    history = run.rig.case.history
    last = slice(int(history.rows[0]) - 1, int(history.rows[0]))
    if last.start < 0:
        return ""
    return f"; {nearest_to_failure(recorded(run, last))}"


def recorded(run: Run, rows: slice) -> Recorded:
    """Rows of the record."""
    case, history = run.rig.case, run.rig.case.history
    free = np.moveaxis(run.rig.own_strain.reshape(-1, len(case.model.x) - 1, 2), 0, -1)
    aged = (history.stage[rows] >= stages.TIME) & free.any()
    strains = section_strains(case.model.x, history.u[rows])
    return Recorded(case.model, *strains, history.T[rows], history.strain[rows], aged, free)


def anchored(run: Run) -> Response:
    """Response of a member so far: it is anchored."""
    return Response(**_common(run, stages.SUSTAINED), status="ok", message="")


def finished(run: Run, ended: int, loss: TimeLoss | None) -> Response:
    """Response of a member that was loaded; ended: how the loading did; loss: what time took before."""
    complete = ended == DONE
    common = _common(run, stages.LIVE) | {"time_loss": loss}
    rows = _service_rows(run)
    curve = _curve(run, rows, common["tendon"][ANCHORED].length)
    steps = recorded(run, slice(int(rows[-1]) + 1))
    events, failure = find_events(steps.since(int(rows[0])), curve)
    before = _before_live(run, events, failure) if failure else ""
    if complete and not failure and not _live_rows(run):
        under = AND_TIME if loss else SUSTAINED
        before, failure = f"the deflection limit is passed under {under}: no live load can be carried", LIMIT
    if before:
        common |= _states(run, steps, rows, common["tendon"])
        events = tuple(event for event in events if event.name != "peak")
        return Response(
            **common, curve=curve, events=events, failure=failure, status="warning", message=before
        )
    if not complete and not failure:
        last = curve.load[-1]
        if ended != NO_EQUILIBRIUM or last >= 0.98 * curve.load.max():
            end = f"{last / 1e3:.4g} kN, deflection {curve.deflection[-1]:.4g} mm"
            message = f"live load: {stages.WHY[ended]} beyond {end}{_why(run)}"
            common |= _states(run, steps, rows, common["tendon"])
            return Response(**common, curve=curve, status="not converged", message=message)
        failure = "no equilibrium beyond the peak"
    peak = next(event for event in events if event.name == "peak")
    common |= _states(run, steps, rows, common["tendon"], peak.step)
    note = "" if complete else f"{stages.WHY[ended]} beyond a deflection of {curve.deflection[-1]:.4g} mm"
    return Response(
        **common,
        curve=curve,
        events=events,
        failure=failure or LIMIT,
        status="ok",
        message=note,
    )


def _before_live(run: Run, events: tuple[Event, ...], failure: str) -> str:
    """What to say of a member that failed before any live load came on; empty if it did not."""
    event = next(event for event in events if event.name == failure)
    loaded = _live_rows(run)
    if loaded and event.step > len(_service_rows(run)) - loaded - 1:
        return ""
    stage = run.rig.case.history.stage[_service_rows(run)[int(np.ceil(event.step))]]
    under = {stages.ANCHORING: "stressing", stages.TIME: AND_TIME}.get(int(stage), SUSTAINED)
    return f"{failure} at x = {event.place:.0f} mm under {under}: no live load can be carried"


def _live_rows(run: Run) -> int:
    """Steps under live load."""
    return int(np.count_nonzero(run.rig.case.history.stage[_service_rows(run)] == stages.LIVE))


def _common(run: Run, before: int) -> dict[str, Any]:
    """What a run has that completed the stages before the given one."""
    history, setup = run.rig.case.history, run.setup
    used = slice(0, int(history.rows[0]))
    last = {name: _last_row(run, stage) if stage < before else None for name, stage in STAGE_ROWS.items()}
    common: dict[str, Any] = {
        "member": setup.member,
        "fpj": run.fpj,
        "losses": run.losses,
        "tendon": {name: _tendon_state(run, row) for name, row in last.items() if row is not None},
        "residual_max": float(history.residual[used].max(initial=0.0)),
        "newton_iterations": int(run.rig.case.work.spent[0]),
        "has_service_value": has_service_value(setup.member),
    }
    if (row := last[JACKED]) is not None:
        common["elongations"] = _elongations(run, row)
        common["elongation_before"] = sum(common["elongations"])
    if last[SET] is not None:
        common["elongation_after"] = common["elongation_before"] - setup.member.set * sum(setup.live)
    if (jacked := last[JACKED]) is not None and (after := last[SET]) is not None:
        common["set_length"] = _set_length(run, jacked, after)
    for name, stage in (("camber", ANCHORED), ("camber_service", SERVICE)):
        if (row := last[stage]) is not None:
            common[name] = float(history.u[row, 5 * setup.mesh.control + 3])
    return common


def _states(
    run: Run,
    steps: Recorded,
    rows: NDArray[np.int64],
    tendon: dict[str, TendonState],
    peak: float | None = None,
) -> dict[str, Any]:
    """Tendon and cracks at the peak, a row of the curve with a fraction, if there is one, and at the end if
    that is another row. Cracks are those of the nearest row."""
    at = {ANCHORED: float(rows[0])}
    at |= {} if peak is None else {PEAK: rows[0] + peak}
    at |= {} if peak is not None and round(peak) == len(rows) - 1 else {END: float(rows[-1])}
    near = [round(row) for row in at.values()]
    cracks = cracks_at(steps, near, gross_section(run.setup.member).thickness)
    later = {stage: _tendon_state(run, row) for stage, row in at.items() if stage not in tendon}
    return {"tendon": tendon | later, "cracks": dict(zip(at, cracks, strict=True))}


def _last_row(run: Run, stage: int) -> int | None:
    """The last row of a stage; None where it was not reached."""
    history = run.rig.case.history
    recorded = history.stage[: history.rows[0]]  # in the order of the stages
    last = int(np.searchsorted(recorded, stage, side="right")) - 1
    return last if last >= 0 and recorded[last] == stage else None


def _service_rows(run: Run) -> NDArray[np.int64]:
    """Rows from the anchored state on."""
    first = _last_row(run, stages.ANCHORING)
    assert first is not None  # service comes after anchoring
    return np.arange(first, int(run.rig.case.history.rows[0]))


def _tendon_state(run: Run, row: float) -> TendonState:
    """The tendon at a recorded row, or between two."""
    history, line, Aps = run.rig.case.history, run.setup.duct, run.setup.member.intact_area
    s, T, anchor = (_between(column, row) for column in (history.s, history.T, history.anchor))
    middle = np.clip(0.5 * (s[1:] + s[:-1]), line.s[0], line.s[-1])
    moved = s - run.start.s
    return TendonState(
        run.setup.profile.place(middle),
        T / Aps,
        0.5 * (moved[1:] + moved[:-1]),
        (float(anchor[0] / Aps), float(anchor[1] / Aps)),
        (float(moved[0]), float(moved[-1])),
        run.start.rest,
    )


def _between(rows: Array, row: float) -> Array:
    """A row of an array, interpolated where it falls between two."""
    low = int(row)
    share = row - low
    return rows[low] if share == 0.0 else (1.0 - share) * rows[low] + share * rows[low + 1]


def _elongations(run: Run, row: int) -> tuple[float, ...]:
    """What is measured at each live jack: the way of the tendon's end, and the stretch of the strand that has
    come out on it."""
    history, setup = run.rig.case.history, run.setup
    out = history.u[row][[0, -2]] - run.start.gap
    strain = history.T[row][[0, -1]] / (setup.member.intact_area * setup.member.Ep)
    if all(setup.live):
        out = out + np.array([1.0, -1.0]) * _slide(run, row)
    return tuple((out * (1.0 + strain))[list(setup.live)].tolist())


def _slide(run: Run, row: int) -> float:
    """How far a tendon with two live ends has moved to the right where both pull alike [mm]: friction lets it
    lie anywhere within half a node's spacing, but neither jack sees that as stretch."""
    friction, state = run.losses.friction, _tendon_state(run, row)
    still = min(friction.stations, key=lambda x: abs(friction.exponent(x, "left") - friction.total / 2.0))
    if friction.total == 0.0:  # then they pull alike everywhere
        still = 0.5 * run.setup.member.total_length
    return float(np.interp(still, state.x, state.slip))


def _set_length(run: Run, jacked: int, after: int) -> float:
    """Length that the set moved, from the (left) live end: the tributary lengths of the nodes whose friction
    turned round, and of the last one the part that did.
    """
    line, history = run.setup.duct, run.rig.case.history

    def steps(row: int) -> Array:
        force = np.concatenate([history.anchor[row, :1], history.T[row], history.anchor[row, 1:]])
        return np.diff(np.log(force))

    s = np.concatenate([line.s[:1], history.s[after, 1:-1], line.s[-1:]])
    tributary = np.convolve(np.diff(s), [0.5, 0.5])
    before, inward = steps(jacked), history.s[after] - history.s[jacked]
    inward[-1] = inward[-2]  # a dead end does not move: its half element does what its neighbour does
    if not run.setup.live[0]:
        inward[0] = inward[1]
        before, inward, tributary = before[::-1], -inward[::-1], tributary[::-1]
    now = steps(after) if run.setup.live[0] else steps(after)[::-1]
    if run.setup.member.set == 0.0:
        return 0.0
    if np.abs(before).sum() < SLIGHT:
        turned = np.ones_like(before)
    else:
        turned = np.clip(0.5 * (1.0 - now / np.where(np.abs(before) > 1e-12, before, np.inf)), 0.0, 1.0)
    if all(
        run.setup.live
    ):  # beyond the point that does not move friction turns round for the other end's set
        turned[np.maximum.accumulate(inward <= 0.0)] = 0.0
    whole = int(np.argmax(turned < 0.99)) if (turned < 0.99).any() else len(turned)
    return float((turned * tributary)[: whole + 1].sum())


def _curve(run: Run, rows: NDArray[np.int64], length: Array) -> Curve:
    history, setup = run.rig.case.history, run.setup
    Aps = setup.member.intact_area
    factor, u, T = history.factor[rows], history.u[rows], history.T[rows]
    up = node_values(u, len(setup.mesh.x), 1)[:, setup.mesh.control]
    ends = history.anchor[rows] / Aps
    moments = section_moments(setup.mesh.x, u, history.f[rows]).reshape(len(rows), -1)
    return Curve(
        factor,
        factor * setup.live_total,
        setup.mesh.sense * (up - up[0]),
        moments[np.arange(len(rows)), np.abs(moments).argmax(axis=1)],
        np.minimum(T.min(axis=1) / Aps, ends.min(axis=1)),
        np.average(T, axis=1, weights=length) / Aps,
        np.maximum(T.max(axis=1) / Aps, ends.max(axis=1)),
    )
