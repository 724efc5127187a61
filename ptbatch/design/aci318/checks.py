"""The checks of ACI 318-19 that are made of a member."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ptbatch.design.aci318 import flexure, stress_limits
from ptbatch.design.aci318.cover import specified
from ptbatch.design.aci318.service_checks import at_transfer, deflections, in_service
from ptbatch.design.aci318.shear_checks import shear_checks
from ptbatch.design.aci318.strength import resistance
from ptbatch.design.bending import bending, two_views
from ptbatch.design.check import FAIL, INFO, REVIEW, Check, Value, at_least, at_most
from ptbatch.design.cover import cover
from ptbatch.design.flexure import compressed
from ptbatch.design.subject import SAGGING, Subject
from ptbatch.response import ANCHORED, JACKED

COMBINATIONS = ((1.4, 0.0), (1.2, 0.0), (1.2, 1.6))  # table 5.3.1, prestress by 5.3.11


def checks(subject: Subject) -> Iterator[Check]:
    """Every check, in the order of construction."""
    combinations = subject.combinations(COMBINATIONS)
    yield from _stressing(subject)
    yield from at_transfer(subject)
    yield from in_service(subject)
    yield from _least_steel(subject)
    chapter = "7.5.1.1" if subject.member.kind == "slab" else "9.5.1.1"
    yield from bending(subject, f"ACI 318-19 {chapter}, 22.3", "Mu <= phi Mn", combinations, resistance)
    yield from shear_checks(subject, combinations)
    yield from _least_strength(subject)
    yield from deflections(subject)
    yield cover(
        subject, "ACI 318-19 20.5.1.3", specified(subject.member.exposure, subject.member.kind == "slab")
    )
    yield from two_views(subject, "ACI 318-19 22.3", resistance, combinations)


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


def _least_steel(subject: Subject) -> Iterator[Check]:
    """Bonded steel of a member with unbonded tendons, in the middle of its longest span."""
    member = subject.member
    if member.bond != "unbonded":
        return
    x = subject.middle
    section = subject.section
    tension, _ = compressed(subject.strips(-SAGGING), member.h - section.centroid)
    provided = sum(bar.area for bar in subject.bars(x) if bar.depth > section.centroid)
    clause = "ACI 318-19 7.6.2.3" if member.kind == "slab" else "ACI 318-19 9.6.2.3"
    values = (Value("Act", tension, "mm2"), Value("As", provided, "mm2"))
    required = flexure.least_bonded_steel(tension)
    yield at_least("least bonded steel", clause, "As >= 0.004 Act", values, provided, required, "mm2", x)


def _least_strength(subject: Subject) -> Iterator[Check]:
    """Strength beyond cracking, where the longest span bends most; asked for where the tendon is bonded."""
    member, section = subject.member, subject.section
    x = subject.middle
    P, S = subject.effective(x) * member.intact_area, section.inertia / (section.h - section.centroid)
    e = float(subject.profile.depth(np.array([x]))[0]) - section.centroid
    fr = flexure.modulus_of_rupture(member.fc)
    cracking = (fr + P / section.area) * S + P * e
    values = (
        Value("fr", fr, "MPa"),
        Value("P", P / 1e3, "kN"),
        Value("e", e, "mm"),
        Value("Mcr", cracking / 1e6, "kN m"),
    )
    strength = resistance(subject, x, SAGGING).design
    clause = "ACI 318-19 7.6.2.1" if member.kind == "slab" else "ACI 318-19 9.6.2.1"
    numbers = strength / 1e6, 1.2 * cracking / 1e6, "kN m"
    made = at_least("strength beyond cracking", clause, "phi Mn >= 1.2 Mcr", values, *numbers, x)
    if member.bond == "unbonded":
        yield replace(made, outcome=INFO, utilisation=None, reason="asked for with bonded tendons only")
    else:
        more = "allowed where phi Mn is twice Mu and phi Vn twice Vu (9.6.2.2)"
        yield replace(made, outcome=REVIEW, reason=more) if made.outcome == FAIL else made
