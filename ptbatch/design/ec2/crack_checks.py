"""The checks of decompression and crack width."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ptbatch.design.check import PASS, REVIEW, Check, Value, at_most, review, unless
from ptbatch.design.ec2 import cracks, flexure
from ptbatch.design.ec2.cover import exposure_class
from ptbatch.design.flexure import compressed
from ptbatch.design.longterm.ec2 import modulus
from ptbatch.design.stresses import enveloped
from ptbatch.design.subject import HOGGING, NO_TIME, SAGGING, Subject


def cracking(subject: Subject) -> Iterator[Check]:
    """Decompression and crack width, with the least prestress that is to be expected (5.10.9)."""
    member = subject.member
    exposure = exposure_class(member.exposure)
    limit, least = cracks.widest(member.bond, exposure), cracks.LEAST_PRESTRESS[member.bond]
    shares = {"quasi-permanent": member.live_sustained, "frequent": member.live_frequent}
    decompressed = ""
    if member.bond == "bonded" and exposure not in cracks.MILD:
        decompressed = "quasi-permanent" if exposure in cracks.OTHER else "frequent"
    doubt = "" if subject.timely else NO_TIME
    if decompressed:
        stress, x, *_ = tension(subject, shares[decompressed], least)
        name, formula = f"decompression, {decompressed}", "no tension at the face"
        values = (Value("rinf", least), Value("sigma,c", stress, "MPa"))
        numbers = Check(name, "EN 1992-1-1 table 7.1N", formula, values, stress, 0.0, "MPa", None, PASS, x)
        more = "tendon and duct have to lie 25 mm within compressed concrete (7.3.1 (5))"
        yield replace(numbers, outcome=REVIEW, reason=more) if stress > 0.0 else unless(numbers, doubt)
    if limit is None:
        return
    under = "quasi-permanent" if member.bond == "unbonded" else "frequent"
    found = tension(subject, shares[under], least)
    stress, x = found.stress, found.x
    strength = flexure.fctm(member.fc)
    name, clause = f"crack width, {under}", "EN 1992-1-1 7.3.4"
    told = Value("sigma,ct", stress, "MPa"), Value("fctm", strength, "MPa")
    if stress <= strength:
        made = at_most(name, "EN 1992-1-1 7.3.1", "uncracked: sigma,ct <= fctm", told, 0.0, limit, "mm", x)
        yield unless(made, doubt)
        return
    yield _crack_width(subject, name, clause, found, least, limit, told)


class Tension(NamedTuple):
    """Largest tension of the uncracked concrete [MPa], where, the sense of bending that has that face in
    tension, and the external moment of that sense [N mm]."""

    stress: float
    x: float
    sense: int
    moment: float


def tension(subject: Subject, share: float, least: float) -> Tension:
    """Under a share of the live load, on the spans where it counts."""
    moments = subject.moments
    outer = moments.dead + least * moments.secondary
    found = enveloped(subject, outer, share, subject.time_loss, least)
    i = int(np.maximum(found.top, found.bottom).argmax())
    sense = SAGGING if found.bottom[i] >= found.top[i] else HOGGING
    return Tension(*found.tension, sense, sense * float(found.moments[i]))


def _crack_width(
    subject: Subject, name: str, clause: str, tense: Tension, least: float, limit: float,
    told: tuple[Value, ...],
) -> Check:  # fmt: skip
    member, x, sense = subject.member, tense.x, tense.sense
    bars = [(bar.area, subject.depth(bar.depth, sense)) for bar in subject.bars(x)]
    d = max((depth for _, depth in bars), default=0.0)
    if d <= 0.5 * member.h:
        return review(name, clause, "cracked, and without bars in the tension zone", told, x)
    P, dp, Ecm = (
        least * subject.effective(x) * member.intact_area,
        subject.tendon_depth(x, sense),
        modulus(member.fc),
    )
    stiff = member.Ep * member.intact_area if member.bond == "bonded" else 0.0
    found = cracks.cracked(subject.strips(sense), bars, Ecm, member.Es, (dp, stiff), P, tense.moment)
    if found is None:
        return review(name, clause, "the cracked section has no equilibrium with elastic materials", told, x)
    height = min(2.5 * (member.h - d), (member.h - found.x) / 3.0, 0.5 * member.h)
    tension = subject.strips(-sense)
    effective, _ = compressed(tension, height)
    inside = sum(area for area, depth in bars if depth >= member.h - height)
    rho = inside / effective
    if rho == 0.0:
        return review(name, clause, "no bar lies in the tension zone that crack widths count", told, x)
    cover = max(member.h - d - 0.5 * member.bar_diameter, 0.0)
    wk = cracks.width(
        found.bar_stress, member.Es, Ecm, flexure.fctm(member.fc), rho, cover, member.bar_diameter
    )
    values = (*told, Value("x", found.x, "mm"), Value("sigma,s", found.bar_stress, "MPa"))
    values += (Value("rho,p,eff", rho), Value("c", cover, "mm"), Value("diameter", member.bar_diameter, "mm"))
    formula = "wk = sr,max (eps,sm - eps,cm) <= wmax"
    made = at_most(name, clause, formula, values, wk, limit, "mm", x)
    return unless(made, "" if subject.timely else NO_TIME)
