"""The tables of the results from a Response. A value that does not exist is a text that says why."""

from collections.abc import Iterable, Sequence

import numpy as np

from ptbatch.design.check import Check
from ptbatch.design.checks import checks, governing, outcome, subject
from ptbatch.design.elongation import elongations
from ptbatch.design.subject import Subject
from ptbatch.design.time_losses import takes_time
from ptbatch.member import Member
from ptbatch.prestress_losses import losses_by_cause
from ptbatch.response import ANCHORED, END, JACKED, PEAK, SERVICE, SET, STAGES, Event, Response, TendonState
from ptbatch.workbook.results import TENDON, Columns

Value = float | str
Row = dict[str, Value]


def summary_row(member: Member, response: Response, found: Sequence[Check] | None = None) -> Row:
    """The columns of `summary` after `message`, but for the time. found: the checks, made here if None."""
    losses = response.losses
    row: Row = {
        "jacking_stress [MPa]": _anchor_stress(member, response, JACKED),
        "elongation_before_set [mm]": _or_stage(response.elongation_before, response),
        "elongation_after_set [mm]": _or_stage(response.elongation_after, response),
        "loss_jacking_end_fe [%]": _loss_jacking_end(member, response),
        "loss_jacking_end_analytic [%]": 100.0 * losses.loss_jacking_end,
        "loss_fixed_end_fe [%]": _loss_fixed_end(member, response),
        "loss_fixed_end_analytic [%]": 100.0 * losses.loss_fixed_end,
        "set_length_fe [mm]": _or_stage(response.set_length, response),
        "set_length_analytic [mm]": losses.set_length,
    }
    anchored = response.tendon.get(ANCHORED)
    for name in ("min", "mean", "max"):
        row[f"stress_anchored_{name} [MPa]"] = _stress(anchored, name, response)
    row["camber_anchored [mm]"] = _or_stage(response.camber, response)
    row |= _capacity(response)
    row["residual_max"] = response.residual_max
    row["newton_iterations"] = response.newton_iterations
    row |= _failure(response) | _checks(member, response, found)
    return row | _after_time(response)


def _after_time(response: Response) -> Row:
    """Mean stress and camber when time has taken its part."""
    told = _not_reached(response) if takes_time(response.member) else "no long-term loss is given"
    state, camber = response.tendon.get(SERVICE), response.camber_service
    return {
        "stress_service_mean [MPa]": told if state is None else state.mean,
        "camber_service [mm]": told if camber is None else camber,
    }


def _checks(member: Member, response: Response, found: Sequence[Check] | None) -> Row:
    """The outcome of the checks, and the one that is used most."""
    names = ("checks", "utilisation_max", "governing_check")
    found = checks(subject(member, response)) if found is None else found
    most = governing(found)
    if most is None or most.utilisation is None:
        asked = _not_reached(response) if member.standard != "none" else "no standard is asked for"
        return dict.fromkeys(names, asked)
    return dict(zip(names, (outcome(found), _used(most), most.name), strict=True))


def _used(check: Check) -> Value:
    """Demand over limit, or why there is no such number."""
    if check.utilisation is None:
        return "not compared"
    return check.utilisation if np.isfinite(check.utilisation) else "nothing is provided"


def _capacity(response: Response) -> Row:
    """Cracking, yield and peak under live load."""
    peak, at_peak, curve = response.event("peak"), response.tendon.get(PEAK), response.curve
    row: Row = {
        "load_cracking [kN]": _event_load(response, "cracking", "no crack"),
        "load_yield [kN]": _event_load(response, "yield", "no bar or tendon yields"),
    }
    names = ("load_peak [kN]", "load_factor_peak", "deflection_peak [mm]", "moment_peak [kN m]")
    stresses = ("tendon_stress_peak_mean [MPa]", "tendon_stress_peak_max [MPa]")
    if peak is None or at_peak is None or curve is None:
        none = _not_reached(response)
        return row | dict.fromkeys((*names, *stresses), none) | {"failure": response.failure or none}
    factor = curve.at(peak.step, curve.factor)
    moment = curve.at(peak.step, np.abs(curve.moment_max)) * np.sign(curve.moment_max[round(peak.step)])
    return row | {
        "load_peak [kN]": peak.load / 1e3,
        "load_factor_peak": factor if response.has_service_value else "no service live load given",
        "deflection_peak [mm]": peak.deflection,
        "moment_peak [kN m]": float(moment) / 1e6,
        "tendon_stress_peak_mean [MPa]": at_peak.mean,
        "tendon_stress_peak_max [MPa]": at_peak.most,
        "failure": response.failure,
    }


def _failure(response: Response) -> Row:
    """Where and under how much live load the first material reached its limit strain."""
    names = ("failure_x [mm]", "failure_load [kN]", "failure_deflection [mm]")
    event = response.event(response.failure)
    if response.event("peak") is None:
        none = _not_reached(response)
        return dict.fromkeys(names, none) | ({names[0]: event.place} if event else {})
    if event is None:
        return dict.fromkeys(names, "no material reached its limit")
    return dict(zip(names, (event.place, event.load / 1e3, event.deflection), strict=True))


def _not_reached(response: Response) -> str:
    """Why a member has no capacity."""
    return "none: see message" if response.status == "warning" else "not converged: see message"


def _or_stage(value: float | None, response: Response) -> Value:
    return _not_reached(response) if value is None else value


def _stress(state: TendonState | None, name: str, response: Response) -> Value:
    if state is None:
        return _not_reached(response)
    return {"min": state.least, "mean": state.mean, "max": state.most}[name]


def _event_load(response: Response, name: str, otherwise: str) -> Value:
    """Load of an event, or why there is none."""
    event = response.event(name)
    if response.curve is None or response.event("peak") is None:
        return _not_reached(response)
    if event is None:
        return f"{otherwise} before failure or the end of the curve"
    return "before any live load" if _before_live(event, response) else event.load / 1e3


def _before_live(event: Event, response: Response) -> bool:
    """Whether something had happened by the last step without live load."""
    assert response.curve is not None
    return event.step <= np.flatnonzero(response.curve.factor != 0.0)[0] - 1


def _live_end(member: Member) -> int:
    return 1 if member.jack == "right" else 0


def _anchor_stress(member: Member, response: Response, stage: str) -> Value:
    """Stress at the (left) live end's anchor."""
    state = response.tendon.get(stage)
    return _not_reached(response) if state is None else state.anchor_stress[_live_end(member)]


def _loss_jacking_end(member: Member, response: Response) -> Value:
    jacked, anchored = (_anchor_stress(member, response, stage) for stage in (JACKED, ANCHORED))
    if isinstance(jacked, str) or isinstance(anchored, str):
        return _not_reached(response)
    return 100.0 * (1.0 - anchored / jacked)


def _loss_fixed_end(member: Member, response: Response) -> Value:
    """At the dead end's anchor; with two live ends where the stress is least."""
    jacked, anchored = _anchor_stress(member, response, JACKED), response.tendon.get(ANCHORED)
    if isinstance(jacked, str) or anchored is None:
        return _not_reached(response)
    far = anchored.least if member.jack == "both" else anchored.anchor_stress[1 - _live_end(member)]
    return 100.0 * (1.0 - far / jacked)


def tendon_table(member: Member, response: Response) -> Columns:
    """`tendon`: one row an anchor and one a tendon element, for each stage."""
    losses, end = response.losses, member.total_length
    analytic = {JACKED: losses.stress_jacked, SET: losses.stress_anchored, ANCHORED: losses.stress_anchored}
    table: dict[str, list[Value]] = {header: [] for header in TENDON[1:]}
    for stage in STAGES:
        state = response.tendon.get(stage)
        if state is None:
            continue
        x = np.concatenate([[0.0], state.x, [end]])
        parts = {
            "stage": [stage] * len(x),
            "x [mm]": x.tolist(),
            "stress_fe [MPa]": [state.anchor_stress[0], *state.stress.tolist(), state.anchor_stress[1]],
            "stress_analytic [MPa]": analytic[stage](x).tolist() if stage in analytic else [""] * len(x),
            "slip [mm]": [state.end_slip[0], *state.slip.tolist(), state.end_slip[1]],
        }
        for header, values in parts.items():
            table[header] += values
    return table


def curve_table(response: Response) -> Columns:
    """`curves`: one row a recorded step from the anchored state on, with what happened by then."""
    curve = response.curve
    if curve is None:
        return {}
    events = [""] * len(curve.load)
    for event in response.events:
        step = int(np.ceil(event.step))
        events[step] = f"{events[step]}, {event.name}" if events[step] else event.name
    return {
        "step": list(range(len(events))),
        "load_factor": curve.factor.tolist(),
        "load [kN]": (curve.load / 1e3).tolist(),
        "deflection [mm]": curve.deflection.tolist(),
        "moment_max [kN m]": (curve.moment_max / 1e6).tolist(),
        "tendon_stress_min [MPa]": curve.stress_min.tolist(),
        "tendon_stress_mean [MPa]": curve.stress_mean.tolist(),
        "tendon_stress_max [MPa]": curve.stress_max.tolist(),
        "event": events,
    }


def crack_table(response: Response) -> Columns:
    """`cracks`: one row a cracked stretch of a section, at each stage that was looked at."""
    curve, peak = response.curve, response.event("peak")
    if curve is None:
        return {}
    steps = {ANCHORED: 0, PEAK: round(peak.step) if peak else 0, END: len(curve.load) - 1}
    found = [(stage, crack) for stage, cracks in response.cracks.items() for crack in cracks]
    return {
        "stage": [stage for stage, _ in found],
        "step": [steps[stage] for stage, _ in found],
        "x [mm]": [crack.x for _, crack in found],
        "crack_from [mm]": [crack.top for _, crack in found],
        "crack_to [mm]": [crack.bottom for _, crack in found],
    }


def check_table(found: Iterable[Check]) -> Columns:
    """`checks`: one row a check, in the order of construction."""
    found = list(found)
    return {
        "check": [check.name for check in found],
        "clause": [check.clause for check in found],
        "x [mm]": ["all of it" if check.x is None else check.x for check in found],
        "formula": [check.formula for check in found],
        "numbers": [check.numbers for check in found],
        "demand": [check.demand if np.isfinite(check.demand) else "see reason" for check in found],
        "limit": [check.limit if np.isfinite(check.limit) else "none" for check in found],
        "unit": [check.unit for check in found],
        "utilisation": [_used(check) for check in found],
        "outcome": [check.outcome for check in found],
        "reason": [check.reason for check in found],
    }


def elongation_table(member: Member, response: Response) -> Columns:
    """`elongation`: one row a live end."""
    found = elongations(member, response)
    return {
        "end": [one.end for one in found],
        "jack_force [kN]": [one.jack_force / 1e3 for one in found],
        "before_set [mm]": [one.before for one in found],
        "after_set [mm]": [one.after for one in found],
        "least [mm]": [one.least for one in found],
        "most [mm]": [one.most for one in found],
        "to_read": [one.rounded for one in found],
        "warning": [one.warning for one in found],
    }


def loss_table(response: Response) -> Columns:
    """`losses`: one row a cause."""
    found = list(losses_by_cause(response))
    return {
        "cause": [one.cause for one in found],
        "source": [one.source for one in found],
        "loss [MPa]": [one.loss for one in found],
        "share [%]": [100.0 * one.loss / response.fpj for one in found],
        "stress_after [MPa]": [one.left for one in found],
    }


def moment_table(about: Subject | None) -> Columns:
    """`moments`: one row a place, if there is something to check."""
    if about is None:
        return {}
    moments, told = about.moments, about.moments.told
    columns = {
        "self_weight [kN m]": moments.weight,
        "dead [kN m]": moments.dead,
        "live [kN m]": moments.live,
        "live_max [kN m]": moments.live_most,
        "live_min [kN m]": moments.live_least,
        "primary [kN m]": moments.primary,
        "secondary [kN m]": moments.secondary,
        "service [kN m]": moments.dead + moments.live + moments.secondary,
    }
    in_knm = {header: (values[told] / 1e6).tolist() for header, values in columns.items()}
    return {"x [mm]": moments.x[told].tolist(), **in_knm}


def reaction_table(about: Subject | None) -> Columns:
    """`reactions`: one row a support, if there is something to check."""
    if about is None:
        return {}
    member = about.member
    held = [i for i, kind in enumerate(member.supports) if kind != "free"]
    return {
        "support": [i + 1 for i in held],
        "x [mm]": [member.support_x[i] for i in held],
        **{
            f"{name} [kN]": [float(values[i]) / 1e3 for i in held] for name, values in about.reactions.items()
        },
    }
