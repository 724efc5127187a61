"""The checks of ACI 318-19 that are made of a member."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ptbatch.design.aci318 import flexure, service, stress_limits, tendon_stress
from ptbatch.design.bending import Resistance, bending, two_views
from ptbatch.design.check import FAIL, INFO, REVIEW, Check, Value, at_least, at_most, unless
from ptbatch.design.flexure import Steel, compressed, constant, elastic_plastic, strength
from ptbatch.design.sections import NO_TIME, SAGGING, Subject
from ptbatch.design.stresses import fibres
from ptbatch.geometry.section import gross_section
from ptbatch.response import ANCHORED, JACKED

COMBINATIONS = ((1.4, 0.0), (1.2, 0.0), (1.2, 1.6))  # table 5.3.1, prestress by 5.3.11


def checks(subject: Subject) -> Iterator[Check]:
    """Every check, in the order of construction."""
    yield from _stressing(subject)
    yield from _transfer(subject)
    yield from _service(subject)
    yield from _least_steel(subject)
    chapter = "7.5.1.1" if subject.member.kind == "slab" else "9.5.1.1"
    yield from bending(subject, f"ACI 318-19 {chapter}, 22.3", "Mu <= phi Mn", COMBINATIONS, resistance)
    yield from two_views(subject, "ACI 318-19 22.3", resistance)


def _stressing(subject: Subject) -> Iterator[Check]:
    member, tendon = subject.member, subject.response.tendon
    clause = "ACI 318-19 20.3.2.5.1"
    steel = Value("fpu", member.fpu, "MPa"), Value("fpy", member.fpy, "MPa")
    jack = max(tendon[JACKED].anchor_stress)
    limit = stress_limits.jacking(member.fpu, member.fpy)
    formula = "fpj <= min(0.94 fpy, 0.80 fpu)"
    yield at_most("stress at the jack", clause, formula, steel, jack, limit, "MPa")
    anchored = max(tendon[ANCHORED].anchor_stress)
    limit = stress_limits.at_anchorages(member.fpu)
    yield at_most("stress at the anchorages", clause, "fp <= 0.70 fpu", steel[:1], anchored, limit, "MPa")


def _transfer(subject: Subject) -> Iterator[Check]:
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


def _service(subject: Subject) -> Iterator[Check]:
    """Stresses after all losses: compression under sustained and total load, and the class by the tension."""
    member, moments = subject.member, subject.moments
    dead = moments.dead + moments.secondary
    strength = (Value("fc", member.fc, "MPa"), Value("fse", subject.fse, "MPa"))
    loads = (("sustained", member.live_sustained, True), ("total", 1.0, False))
    for name, share, sustained in loads:
        found = fibres(subject, dead + share * moments.live, subject.time_loss)
        stress, x = found.compression
        limit, factor = service.service_compression(member.fc, sustained), "0.45" if sustained else "0.60"
        clause, formula = "ACI 318-19 24.5.4.1", f"fc <= {factor} fc'"
        made = at_most(f"service compression, {name}", clause, formula, strength, stress, limit, "MPa", x)
        yield unless(made, "" if subject.timely else NO_TIME)
    stress, x = found.tension
    kind, limit = service.service_class(stress, member.fc), 7.5 * service.root(member.fc)
    formula, numbers = "U: ft <= 7.5 sqrt(fc'); T: ft <= 12 sqrt(fc')", (stress, limit, "MPa", None, INFO, x)
    told = Check("class", "ACI 318-19 24.5.2.1", formula, strength, *numbers, f"class {kind}")
    cracked = "class C: cracked sections decide its stresses and deflections"
    yield replace(told, outcome=REVIEW, reason=cracked) if kind == "C" else told


def _least_steel(subject: Subject) -> Iterator[Check]:
    """Bonded steel of a member with unbonded tendons, in the middle of its longest span."""
    member = subject.member
    if member.bond != "unbonded":
        return
    longest = max(range(len(member.span)), key=lambda i: member.span[i])
    x = member.support_x[longest] + 0.5 * member.span[longest]
    section = gross_section(member)
    tension, _ = compressed(subject.strips(-SAGGING), member.h - section.centroid)
    provided = sum(bar.area for bar in subject.bars(x) if bar.depth > section.centroid)
    clause = "ACI 318-19 7.6.2.3" if member.kind == "slab" else "ACI 318-19 9.6.2.3"
    values = (Value("Act", tension, "mm2"), Value("As", provided, "mm2"))
    required = flexure.least_bonded_steel(tension)
    yield at_least("least bonded steel", clause, "As >= 0.004 Act", values, provided, required, "mm2", x)


def resistance(subject: Subject, x: float, sense: int) -> Resistance:
    """phi Mn and Mn at a place."""
    member = subject.member
    fps = nominal_stress(subject, x, sense)
    steel = [Steel(subject.tendon_depth(x, sense), member.Aps, constant(fps))]
    steel += [
        Steel(subject.depth(bar.depth, sense), bar.area, elastic_plastic(member.Es, bar.fy))
        for bar in subject.bars(x)
    ]
    found = strength(subject.strips(sense), flexure.block(member.fc), steel)
    if found is None:
        return Resistance(0.0, 0.0, (Value("fps", fps, "MPa"),), fps)
    phi = flexure.phi(found.deepest_strain)
    values = (Value("fps", fps, "MPa"), Value("c", found.c, "mm"), Value("phi", phi))
    return Resistance(phi * found.moment, found.moment, values, fps)


def nominal_stress(subject: Subject, x: float, sense: int) -> float:
    """fps [MPa]; where the tendon lies in the compressed half, or fse is below 0.5 fpu and the expressions do
    not hold, no more than fse."""
    member = subject.member
    fse = subject.effective(x) if member.bond == "bonded" else subject.fse
    dp = subject.tendon_depth(x, sense)
    if dp <= 0.5 * member.h or not tendon_stress.applies(fse, member.fpu):
        return fse
    width = subject.strips(sense)[0][1]
    rho_p = member.Aps / (width * dp)
    if member.bond == "unbonded":
        slender = subject.span_at(x) / member.h
        return tendon_stress.unbonded(fse, member.fc, rho_p, member.fpy, slender)
    tension = [bar for bar in subject.bars(x) if subject.depth(bar.depth, sense) > 0.5 * member.h]
    area = sum(bar.area for bar in tension)
    d = sum(bar.area * subject.depth(bar.depth, sense) for bar in tension) / area if area else dp
    omega = sum(bar.area * bar.fy for bar in tension) / (width * d * member.fc)
    beta1 = flexure.beta1(member.fc)
    return tendon_stress.bonded(member.fpu, member.fpy, member.fc, beta1, rho_p, d / dp, omega, 0.0, 0.0)
