"""The checks of EN 1992-1-1 that are made of a member; fpy stands for fp0.1k, fc for fck, fy for fyk."""

from collections.abc import Iterator

from ptbatch.design.bending import bending, two_views
from ptbatch.design.check import Check, Value, at_least, at_most
from ptbatch.design.cover import cover
from ptbatch.design.ec2 import flexure, stress_limits
from ptbatch.design.ec2.cover import nominal
from ptbatch.design.ec2.crack_checks import cracking
from ptbatch.design.ec2.service_checks import deflections, in_service
from ptbatch.design.ec2.shear_checks import shear_checks
from ptbatch.design.ec2.strength import resistance
from ptbatch.design.subject import SAGGING, Subject
from ptbatch.response import ANCHORED, JACKED

COMBINATIONS = ((1.35, 0.0), (1.35, 1.5))  # EN 1990 eq. (6.10), gamma_P = 1.0 by EN 1992-1-1, 2.4.2.2


def checks(subject: Subject) -> Iterator[Check]:
    """Every check, in the order of construction."""
    combinations = subject.combinations(COMBINATIONS)
    yield from _stressing(subject)
    yield from in_service(subject)
    yield from _least_steel(subject)
    yield from bending(subject, "EN 1992-1-1 6.1", "MEd <= MRd", combinations, resistance)
    yield from shear_checks(subject, combinations)
    yield from cracking(subject)
    yield from deflections(subject)
    duct = subject.member.duct or 0.0
    yield cover(subject, "EN 1992-1-1 4.4.1", nominal(subject.member.exposure, duct))
    yield from two_views(subject, "EN 1992-1-1 6.1", resistance, combinations)


def _stressing(subject: Subject) -> Iterator[Check]:
    member, tendon = subject.member, subject.response.tendon
    steel = Value("fpk", member.fpu, "MPa"), Value("fp0.1k", member.fpy, "MPa")
    jack, limit = max(tendon[JACKED].anchor_stress), stress_limits.jacking(member.fpu, member.fpy)
    formula = "sigma,p,max <= min(0.8 fpk, 0.9 fp0.1k)"
    yield at_most("stress at the jack", "EN 1992-1-1 5.10.2.1", formula, steel, jack, limit, "MPa")
    most, limit = tendon[ANCHORED].most, stress_limits.after_transfer(member.fpu, member.fpy)
    formula = "sigma,pm0 <= min(0.75 fpk, 0.85 fp0.1k)"
    yield at_most("stress after transfer", "EN 1992-1-1 5.10.3", formula, steel, most, limit, "MPa")


def _least_steel(subject: Subject) -> Iterator[Check]:
    """Bars in the middle of the longest span; a bonded tendon counts with its area."""
    member = subject.member
    x = subject.middle
    bars = [bar for bar in subject.bars(x) if bar.depth > subject.section.centroid]
    provided = sum(bar.area for bar in bars) + (member.intact_area if member.bond == "bonded" else 0.0)
    d = max([bar.depth for bar in bars], default=subject.tendon_depth(x, SAGGING))
    bt = member.b if member.shape == "rectangle" else member.bw or member.b
    required = flexure.least_reinforcement(member.fc, member.fy, bt, d)
    values = (Value("bt", bt, "mm"), Value("d", d, "mm"), Value("fctm", flexure.fctm(member.fc), "MPa"))
    formula = "As >= max(0.26 fctm / fyk, 0.0013) bt d"
    clause = "EN 1992-1-1 9.3.1.1" if member.kind == "slab" else "EN 1992-1-1 9.2.1.1"
    yield at_least("least reinforcement", clause, formula, values, provided, required, "mm2", x)
