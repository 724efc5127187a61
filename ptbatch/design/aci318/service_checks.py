"""The checks of stresses at transfer and in service, and of deflections."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ptbatch.design.aci318 import service
from ptbatch.design.check import FAIL, INFO, REVIEW, Check, Value, at_most, review, unless
from ptbatch.design.deflections import elastic, live_by_analysis, worst
from ptbatch.design.stresses import enveloped, fibres
from ptbatch.design.subject import NO_TIME, Subject

CLASSES = "UTC"  # the first is the strictest
LASTING = 2.0  # xi of table 24.2.4.1.3, five years or more


def at_transfer(subject: Subject) -> Iterator[Check]:
    """Stresses under self-weight and the whole prestress, at the ends of the member and elsewhere."""
    member, moments = subject.member, subject.moments
    if member.fci is None:
        return
    then = (subject.fse + subject.time_loss) / subject.fse  # secondary moments before time took of them
    found = fibres(subject, moments.weight + then * moments.secondary, 0.0)
    near_end = (found.x < member.h) | (found.x > member.total_length - member.h)
    simple = len(member.span) == 1
    parts = ((near_end, True), (~near_end, False)) if simple else ((np.ones_like(near_end), False),)
    strength = (Value("fci", member.fci, "MPa"),)
    for inside, at_end in parts:
        where = ", ends" if at_end else ""
        stress, x = found.within(inside).compression
        limit, factor = service.transfer_compression(member.fci, at_end), "0.70" if at_end else "0.60"
        name, formula = f"transfer compression{where}", f"fc <= {factor} fci"
        yield at_most(name, "ACI 318-19 24.5.3.1", formula, strength, stress, limit, "MPa", x)
        stress, x = found.within(inside).tension
        limit, factor = service.transfer_tension(member.fci, at_end), "6" if at_end else "3"
        name, formula = f"transfer tension{where}", f"ft <= {factor} sqrt(fci)"
        made = at_most(name, "ACI 318-19 24.5.3.2", formula, strength, stress, limit, "MPa", x)
        more = "bonded steel in the tension zone has to take the tension"
        yield replace(made, outcome=REVIEW, reason=more) if made.outcome == FAIL else made


def in_service(subject: Subject) -> Iterator[Check]:
    """Stresses after all losses: compression under sustained and total load, and the class by the tension."""
    member, moments = subject.member, subject.moments
    dead = moments.dead + moments.secondary
    strength = (Value("fc", member.fc, "MPa"), Value("fse", subject.fse, "MPa"))
    loads = (("sustained", member.live_sustained, True), ("total", 1.0, False))
    for name, share, sustained in loads:
        found = enveloped(subject, dead, share, subject.time_loss)
        stress, x = found.compression
        limit, factor = service.service_compression(member.fc, sustained), "0.45" if sustained else "0.60"
        clause, formula = "ACI 318-19 24.5.4.1", f"fc <= {factor} fc'"
        made = at_most(f"service compression, {name}", clause, formula, strength, stress, limit, "MPa", x)
        yield unless(made, "" if subject.timely else NO_TIME)
    stress, x = found.tension
    kind, limit = service.service_class(stress, member.fc), 7.5 * service.root(member.fc)
    formula, numbers = "U: ft <= 7.5 sqrt(fc'); T: ft <= 12 sqrt(fc')", (stress, limit, "MPa", None, INFO, x)
    told = Check("class", "ACI 318-19 24.5.2.1", formula, strength, *numbers, f"class {kind}")
    wanted = member.service_class
    if wanted != "any" and CLASSES.index(kind) > CLASSES.index(wanted):
        yield replace(told, outcome=FAIL, reason=f"class {kind}, not {wanted}")
        return
    cracked = "class C: cracked sections decide its stresses and deflections"
    yield replace(told, outcome=REVIEW, reason=cracked) if kind == "C" else told


def deflections(subject: Subject) -> Iterator[Check]:
    """Live load as the analysis has it; with creep of what is sustained, for what is attached later."""
    member = subject.member
    if not subject.has_live:
        return
    control = float(subject.moments.x[int(np.abs(elastic(subject, member.Ec).live).argmax())])
    added = live_by_analysis(subject)
    name = "deflection, live"
    if added is None:
        yield review(name, "ACI 318-19 24.2.2", "the analysis did not reach the service load", x=control)
    else:
        span = subject.span_at(control)
        formula, put_in = f"delta,live <= L / {member.deflection_live:g}", (Value("L", span, "mm"),)
        limit = span / member.deflection_live
        yield at_most(name, "ACI 318-19 24.2.2", formula, put_in, abs(added), limit, "mm", control)
    found = elastic(subject, member.Ec)
    sustained = found.dead + member.live_sustained * found.live + found.prestress
    later = LASTING * sustained + found.live
    size, x, span = worst(subject, found.x, later)
    at = int(np.abs(found.x - x).argmin())
    values = (
        Value("delta,dead", float(found.dead[at]), "mm"),
        Value("delta,prestress", float(found.prestress[at]), "mm"),
        Value("delta,live", float(found.live[at]), "mm"),
        Value("xi", LASTING),
    )
    formula = f"xi delta,sustained + delta,live <= L / {member.deflection_total:g}"
    limit = span / member.deflection_total
    name = "deflection, long-term"
    made = at_most(name, "ACI 318-19 24.2.4.2", formula, values, size, limit, "mm", x)
    dead = subject.moments.dead + subject.moments.secondary
    tension = enveloped(subject, dead, 1.0, subject.time_loss)
    cracked = service.service_class(tension.tension[0], member.fc) != "U"
    doubts = [] if subject.timely else [NO_TIME]
    doubts += ["not class U: of the uncracked section"] if cracked else []
    yield unless(made, "; ".join(doubts))
