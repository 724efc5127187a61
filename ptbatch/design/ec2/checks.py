"""The checks of EN 1992-1-1 that are made of a member; fpy stands for fp0.1k, fc for fck, fy for fyk."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from ptbatch.design.bending import Resistance, bending, two_views
from ptbatch.design.check import FAIL, REVIEW, Check, Value, at_least, at_most, unless
from ptbatch.design.ec2 import flexure, stress_limits
from ptbatch.design.flexure import Steel, constant, elastic_plastic, strength
from ptbatch.design.sections import NO_TIME, SAGGING, Subject
from ptbatch.design.stresses import fibres
from ptbatch.geometry.section import gross_section
from ptbatch.response import ANCHORED, JACKED

COMBINATIONS = ((1.35, 0.0), (1.35, 1.5))  # EN 1990 eq. (6.10), gamma_P = 1.0 by EN 1992-1-1, 2.4.2.2
GAMMA_S = 1.15


def checks(subject: Subject) -> Iterator[Check]:
    """Every check, in the order of construction."""
    yield from _stressing(subject)
    yield from _service(subject)
    yield from _least_steel(subject)
    yield from bending(subject, "EN 1992-1-1 6.1", "MEd <= MRd", COMBINATIONS, resistance)
    yield from two_views(subject, "EN 1992-1-1 6.1", resistance)


def _stressing(subject: Subject) -> Iterator[Check]:
    member, tendon = subject.member, subject.response.tendon
    steel = Value("fpk", member.fpu, "MPa"), Value("fp0.1k", member.fpy, "MPa")
    jack, limit = max(tendon[JACKED].anchor_stress), stress_limits.jacking(member.fpu, member.fpy)
    formula = "sigma,p,max <= min(0.8 fpk, 0.9 fp0.1k)"
    yield at_most("stress at the jack", "EN 1992-1-1 5.10.2.1", formula, steel, jack, limit, "MPa")
    most, limit = tendon[ANCHORED].most, stress_limits.after_transfer(member.fpu, member.fpy)
    formula = "sigma,pm0 <= min(0.75 fpk, 0.85 fp0.1k)"
    yield at_most("stress after transfer", "EN 1992-1-1 5.10.3", formula, steel, most, limit, "MPa")


def _service(subject: Subject) -> Iterator[Check]:
    """Stresses after all losses, of the uncracked concrete and of the tendon."""
    member, moments = subject.member, subject.moments
    dead = moments.dead + moments.secondary
    strength = (Value("fck", member.fc, "MPa"),)
    parts = (("quasi-permanent", member.live_sustained, 0.45, "3"), ("characteristic", 1.0, 0.60, "2"))
    doubt = "" if subject.timely else NO_TIME
    for name, share, factor, number in parts:
        stress, x = fibres(subject, dead + share * moments.live, subject.time_loss).compression
        clause, formula = f"EN 1992-1-1 7.2 ({number})", f"sigma,c <= {factor:.2f} fck"
        limit = factor * member.fc
        made = at_most(f"compression, {name}", clause, formula, strength, stress, limit, "MPa", x)
        more = "creep is not linear any more" if factor < 0.5 else "longitudinal cracks in XD, XF, XS"
        yield replace(made, outcome=REVIEW, reason=more) if made.outcome == FAIL else unless(made, doubt)
    most, limit = subject.response.tendon[ANCHORED].most - subject.time_loss, 0.75 * member.fpu
    formula, steel = "sigma,p <= 0.75 fpk", (Value("fpk", member.fpu, "MPa"),)
    yield at_most("tendon after losses", "EN 1992-1-1 7.2 (5)", formula, steel, most, limit, "MPa")


def _least_steel(subject: Subject) -> Iterator[Check]:
    """Bars in the middle of the longest span; a bonded tendon counts with its area."""
    member = subject.member
    longest = max(range(len(member.span)), key=lambda i: member.span[i])
    x = member.support_x[longest] + 0.5 * member.span[longest]
    bars = [bar for bar in subject.bars(x) if bar.depth > gross_section(member).centroid]
    provided = sum(bar.area for bar in bars) + (member.Aps if member.bond == "bonded" else 0.0)
    d = max([bar.depth for bar in bars], default=subject.tendon_depth(x, SAGGING))
    bt = member.b if member.shape == "rectangle" else member.bw or member.b
    required = flexure.least_reinforcement(member.fc, member.fy, bt, d)
    values = (Value("bt", bt, "mm"), Value("d", d, "mm"), Value("fctm", flexure.fctm(member.fc), "MPa"))
    formula = "As >= max(0.26 fctm / fyk, 0.0013) bt d"
    clause = "EN 1992-1-1 9.3.1.1" if member.kind == "slab" else "EN 1992-1-1 9.2.1.1"
    yield at_least("least reinforcement", clause, formula, values, provided, required, "mm2", x)


def resistance(subject: Subject, x: float, sense: int) -> Resistance:
    """MRd at a place, and the resistance without partial factors."""
    design, values, stress = _moment(subject, x, sense, 1.5, GAMMA_S)
    nominal, _, mean_stress = _moment(subject, x, sense, 1.0, 1.0)
    return Resistance(design, nominal, values + (Value("sigma,p", stress, "MPa"),), mean_stress)


def _moment(
    subject: Subject, x: float, sense: int, gamma_c: float, gamma_s: float
) -> tuple[float, tuple[Value, ...], float]:
    """Resistance [N mm], its numbers, and the stress of the tendon [MPa]."""
    member = subject.member
    tendon, dp = _tendon(subject, x, sense, gamma_s), subject.tendon_depth(x, sense)
    steel = [Steel(dp, member.Aps, tendon)]
    steel += [
        Steel(subject.depth(bar.depth, sense), bar.area, elastic_plastic(member.Es, bar.fy / gamma_s))
        for bar in subject.bars(x)
    ]
    block = flexure.block(member.fc, gamma_c)
    found = strength(subject.strips(sense), block, steel)
    if found is None:
        return 0.0, (), tendon(0.0)
    return found.moment, (Value("x", found.c, "mm"),), tendon(block.strain * (dp - found.c) / found.c)


def _tendon(subject: Subject, x: float, sense: int, gamma_s: float) -> Callable[[float], float]:
    """Stress of the tendon by the strain that the section adds: none of it reaches an unbonded one."""
    member, most = subject.member, subject.member.fpy / gamma_s
    if member.bond == "unbonded":
        deep = subject.tendon_depth(x, sense) > 0.5 * member.h
        return constant(min(flexure.unbonded_stress(subject.fse) if deep else subject.fse, most))
    effective = subject.effective(x)
    return lambda strain: float(np.clip(effective + member.Ep * strain, -most, most))
