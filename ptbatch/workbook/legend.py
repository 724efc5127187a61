"""What every column of the results means: the sheet `legend`."""

from collections.abc import Iterator, Mapping, Sequence

from ptbatch.workbook.units import parse_header

LEGEND = ("sheet", "column", "unit", "meaning")
_TYPED = "as typed in the input"
_STRESS = "of the tendon over its whole length"
_ANALYTIC = "P = P0 exp(-(mu alpha + K x)) on the exact angle of the profile"

MEANINGS: Mapping[str, Mapping[str, str]] = {
    "summary": {
        "member": "name as typed; one row per row of the input, in its order",
        "status": "ok; warning (see message); invalid (see the sheet problems); not converged (no capacity); "
        "not analysed (the run was interrupted)",
        "message": "what is to be known of this row",
        "jacking_stress": "jack force / Aps, at the live end's anchor",
        "elongation_before_set": "of the tendon at the jack, before the wedges draw in",
        "elongation_after_set": "the same after the wedge set",
        "loss_jacking_end_fe": "1 - stress after anchoring / jacking stress at the live end, by the analysis",
        "loss_jacking_end_analytic": f"the same by {_ANALYTIC}, with the wedge set as the area between two "
        "curves",
        "loss_fixed_end_fe": "the same at the fixed end; with two live ends where the stress is least",
        "loss_fixed_end_analytic": "the same, analytically",
        "set_length_fe": "how far the wedge set is felt, by the analysis",
        "set_length_analytic": "the same, analytically",
        "stress_anchored_min": f"least stress {_STRESS}, after anchoring",
        "stress_anchored_mean": f"mean stress {_STRESS}, after anchoring",
        "stress_anchored_max": f"largest stress {_STRESS}, after anchoring",
        "camber_anchored": "at the control point after anchoring, up positive",
        "load_cracking": "total live load on the member at the first crack",
        "load_yield": "the same when the first bar or tendon yields",
        "load_peak": "the largest total live load up to the first failure or to deflection_limit",
        "load_factor_peak": "load_peak in multiples of the service value",
        "deflection_peak": "at the control point at the peak, down positive, from the anchored state",
        "moment_peak": "largest section moment at the peak, all loads included",
        "tendon_stress_peak_mean": f"mean stress {_STRESS}, at the peak",
        "tendon_stress_peak_max": f"largest stress {_STRESS}, at the peak",
        "failure": "what ended the member: a material, or deflection limit",
        "residual_max": "largest accepted out-of-balance by statics, relative to the jacking force",
        "newton_iterations": "all tries of the solver, failed ones as well",
        "time": "of the analysis of this row",
        "failure_x": "where the first material reached its limit strain, from the left end",
        "failure_load": "total live load then",
        "failure_deflection": "deflection at the control point then",
        "checks": "the gravest outcome of the checks by `standard`: pass, fail or review",
        "utilisation_max": "the largest demand over limit of all checks",
        "governing_check": "the check that it is of",
        "stress_service_mean": f"mean stress {_STRESS}, when time has taken its part, before the live load",
        "camber_service": "at the control point when time has taken its part, up positive",
    },
    "checks": {
        "member": "name; one row per check by the standard of its row",
        "check": "what is checked",
        "clause": "of the code",
        "x": "place of the section, from the left end",
        "formula": "in the code's symbols",
        "numbers": "put in, with their units",
        "demand": "in `unit`; of a least amount what is required",
        "limit": "in `unit`; of a least amount what is provided",
        "unit": "of demand and limit",
        "utilisation": "demand over limit",
        "outcome": "pass; fail; review (see reason: an engineer must look); info (nothing is compared)",
        "reason": "why it is to be reviewed, or fails",
    },
    "losses": {
        "member": "name; one row per cause, in the order in which they act",
        "cause": "what takes the stress",
        "source": "the analysis, or the document by which it is computed",
        "loss": f"of the mean stress {_STRESS}; below zero where stress is gained",
        "share": "of the stress at the jack",
        "stress_after": "mean stress that is left",
    },
    "moments": {
        "member": "name; of the uncracked elastic member, sagging positive; rows with a standard only",
        "x": "place of the section, from the left end",
        "self_weight": "of the member's own weight",
        "dead": "of all sustained load, self-weight included",
        "live": "of the live load at its service value",
        "live_max": "of the same, on the spans where it makes the largest moment here",
        "live_min": "of the same, on the spans where it makes the least (or the most hogging) one",
        "primary": "of the prestress: its force times its eccentricity, after all losses",
        "secondary": "of the reactions that the prestress causes",
        "service": "dead + live + secondary: what the section has to bear, the tendon being part of it",
    },
    "reactions": {
        "member": "name; one row per support, upward positive; rows with a standard only",
        "support": "1 = left",
        "x": "place of the support, from the left end",
        "self_weight": "to the member's own weight",
        "dead": "to all sustained load, self-weight included",
        "live": "to the live load at its service value",
        "secondary": "to the prestress: in balance with each other, they make the secondary moments",
    },
    "tendon": {
        "member": "name; one row per tendon element and per anchor, at each stage",
        "stage": "jacked, set, anchored, service (time has taken its part), peak, end (the last step, "
        "where that is not the peak)",
        "x": "middle of the tendon element, or place of the anchor, from the left end",
        "stress_fe": "stress of the tendon by the analysis",
        "stress_analytic": f"stress by {_ANALYTIC}; none from the live load on",
        "slip": "of the tendon against the duct since jacking began",
    },
    "curves": {
        "member": "name; one row per step from the anchored state on",
        "step": "0 is the anchored state",
        "load_factor": "live load in multiples of the service value",
        "load": "total live load on the member",
        "deflection": "at the control point, down positive, from the anchored state",
        "moment_max": "largest section moment, all loads included",
        "tendon_stress_min": f"least stress {_STRESS}",
        "tendon_stress_mean": f"mean stress {_STRESS}",
        "tendon_stress_max": f"largest stress {_STRESS}",
        "event": "what happened by this step: cracking, yield, peak, a failure",
    },
    "cracks": {
        "member": "name; one row per cracked stretch of a section",
        "stage": "anchored, peak, end",
        "step": "of the sheet curves",
        "x": "place of the section, from the left end",
        "crack_from": "depth below the top fibre where the crack begins",
        "crack_to": "depth where it ends",
    },
    "elongation": {
        "member": "name; one row per live end",
        "end": "left or right",
        "jack_force": "at this end",
        "before_set": "theoretical elongation while jacking, before the wedges draw in",
        "after_set": "the same after the wedge set: what is measured is compared with this",
        "least": "7 % less, ACI 318-19, 26.10.2 (e)",
        "most": "7 % more",
        "to_read": "after_set as a tape has it: to 1 mm and to 1/8 in",
        "warning": "where rounding alone exceeds the 7 %",
        "gauge": "to be filled in: pressure of the jack",
        "measured": "to be filled in",
        "deviation": "of the measured elongation",
        "verdict": "OK within the 7 %, else NG",
    },
    "problems": {
        "sheet": "of the input",
        "cell": "of the input",
        "column": "its header",
        "value": "as typed",
        "what is wrong": "faults make a row invalid, warnings do not",
        "how to put it right": "the cure",
    },
}


def notes(name: str, headers: Sequence[str]) -> dict[str, str]:
    """Comments on the headers of a sheet, where they are known."""
    meanings = MEANINGS.get(name, {})
    known = ((header, parse_header(header).name) for header in headers)
    return {header: meanings[column] for header, column in known if column in meanings}


def legend(sheets: Mapping[str, Sequence[str]]) -> Iterator[list[str]]:
    """Lines for these sheets, each with its headers; a column that is not known here is the user's."""
    for name, headers in sheets.items():
        for header in headers:
            if name in MEANINGS:
                column, unit = parse_header(header)
                meaning = MEANINGS[name].get(column)
                yield [name, column, unit or "-", meaning] if meaning else [name, header, "-", _TYPED]
