"""Rows of the result sheets from a Response. A value that does not exist is a text that says why."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from ptbatch.design.check import Check
from ptbatch.design.checks import checks, governing, outcome, subject
from ptbatch.design.elongation import elongations
from ptbatch.design.subject import Subject
from ptbatch.design.time_losses import takes_time
from ptbatch.member import Member
from ptbatch.prestress_losses import losses_by_cause
from ptbatch.response import ANCHORED, JACKED, PEAK, SERVICE, SET, STAGES, Event, Response, TendonState
from ptbatch.workbook.results import MOMENTS

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


def tendon_rows(member: Member, response: Response) -> Iterator[Row]:
    """Rows of `tendon`: one an anchor and one a tendon element, for each stage."""
    losses, end = response.losses, member.total_length
    analytic = {JACKED: losses.stress_jacked, SET: losses.stress_anchored, ANCHORED: losses.stress_anchored}
    for stage in STAGES:
        state = response.tendon.get(stage)
        if state is None:
            continue
        x = np.concatenate([[0.0], state.x, [end]])
        stress = np.concatenate([state.anchor_stress[:1], state.stress, state.anchor_stress[1:]])
        slip = np.concatenate([state.end_slip[:1], state.slip, state.end_slip[1:]])
        curve = analytic[stage](x) if stage in analytic else None
        for i in range(len(x)):
            yield {
                "member": member.member,
                "stage": stage,
                "x [mm]": float(x[i]),
                "stress_fe [MPa]": float(stress[i]),
                "stress_analytic [MPa]": "" if curve is None else float(curve[i]),
                "slip [mm]": float(slip[i]),
            }


def curve_rows(member: Member, response: Response) -> Iterator[Row]:
    """Rows of `curves`: one a recorded step from the anchored state on, with what happened by then."""
    curve = response.curve
    if curve is None:
        return
    for i in range(len(curve.load)):
        events = [event.name for event in response.events if int(np.ceil(event.step)) == i]
        yield {
            "member": member.member,
            "step": i,
            "load_factor": float(curve.factor[i]),
            "load [kN]": float(curve.load[i]) / 1e3,
            "deflection [mm]": float(curve.deflection[i]),
            "moment_max [kN m]": float(curve.moment_max[i]) / 1e6,
            "tendon_stress_min [MPa]": float(curve.stress_min[i]),
            "tendon_stress_mean [MPa]": float(curve.stress_mean[i]),
            "tendon_stress_max [MPa]": float(curve.stress_max[i]),
            "event": ", ".join(events),
        }


def crack_rows(member: Member, response: Response) -> Iterator[Row]:
    """Rows of `cracks`: one a cracked stretch of a section, at each stage that was looked at."""
    curve, peak = response.curve, response.event("peak")
    for stage, cracks in response.cracks.items():
        assert curve is not None  # cracks are told of members that reached the live load
        step = {ANCHORED: 0, PEAK: round(peak.step) if peak else 0}.get(stage, len(curve.load) - 1)
        for crack in cracks:
            yield {
                "member": member.member,
                "stage": stage,
                "step": step,
                "x [mm]": crack.x,
                "crack_from [mm]": crack.top,
                "crack_to [mm]": crack.bottom,
            }


def check_rows(member: Member, found: Iterable[Check]) -> Iterator[Row]:
    """Rows of `checks`: one a check, in the order of construction."""
    for check in found:
        yield {
            "member": member.member,
            "check": check.name,
            "clause": check.clause,
            "x [mm]": "all of it" if check.x is None else check.x,
            "formula": check.formula,
            "numbers": check.numbers,
            "demand": check.demand if np.isfinite(check.demand) else "see reason",
            "limit": check.limit if np.isfinite(check.limit) else "none",
            "unit": check.unit,
            "utilisation": _used(check),
            "outcome": check.outcome,
            "reason": check.reason,
        }


def elongation_rows(member: Member, response: Response) -> Iterator[Row]:
    """Rows of `elongation`: one a live end."""
    for one in elongations(member, response):
        yield {
            "member": member.member,
            "end": one.end,
            "jack_force [kN]": one.jack_force / 1e3,
            "before_set [mm]": one.before,
            "after_set [mm]": one.after,
            "least [mm]": one.least,
            "most [mm]": one.most,
            "to_read": one.rounded,
            "warning": one.warning,
        }


def loss_rows(member: Member, response: Response) -> Iterator[Row]:
    """Rows of `losses`: one a cause."""
    for one in losses_by_cause(response):
        yield {
            "member": member.member,
            "cause": one.cause,
            "source": one.source,
            "loss [MPa]": one.loss,
            "share [%]": 100.0 * one.loss / response.fpj,
            "stress_after [MPa]": one.left,
        }


def moment_rows(about: Subject | None) -> Iterator[Row]:
    """Rows of `moments`: one a place, if there is something to check."""
    if about is None:
        return
    member, moments = about.member, about.moments
    names = ("weight", "dead", "live", "live_most", "live_least", "primary", "secondary")
    headers = [header for header in MOMENTS if header.endswith("[kN m]")]
    for i in moments.told:
        service = moments.dead[i] + moments.live[i] + moments.secondary[i]
        values = (*(getattr(moments, name)[i] for name in names), service)
        told = {header: float(value) / 1e6 for header, value in zip(headers, values, strict=True)}
        yield {"member": member.member, "x [mm]": float(moments.x[i]), **told}


def reaction_rows(about: Subject | None) -> Iterator[Row]:
    """Rows of `reactions`: one a support, if there is something to check."""
    if about is None:
        return
    member, found = about.member, about.reactions
    for i, (x, kind) in enumerate(zip(member.support_x, member.supports, strict=True)):
        if kind != "free":
            places: Row = {"member": member.member, "support": i + 1, "x [mm]": x}
            yield places | {f"{name} [kN]": float(values[i]) / 1e3 for name, values in found.items()}
