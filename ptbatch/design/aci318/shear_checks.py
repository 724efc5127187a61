"""The checks of one-way shear."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from ptbatch.design.aci318 import shear
from ptbatch.design.check import Check, Value, at_least, at_most, unless
from ptbatch.design.shear import Section, if_told, sections, web
from ptbatch.design.subject import HOGGING, SAGGING, Combination, Subject

PER = 1000.0  # mm, spacing for which least stirrups are told where there are none


def shear_checks(subject: Subject, combinations: Sequence[Combination]) -> Iterator[Check]:
    """The section that is used most by one-way shear, half a depth from the supports and further; stirrups
    where they are needed."""
    found = [
        _shear_at(subject, section) for section in sections(subject, combinations, 0.5 * subject.member.h)
    ]
    if not found:
        return
    member = subject.member
    clause = "ACI 318-19 7.5.1.1, 22.5" if member.kind == "slab" else "ACI 318-19 9.5.1.1, 22.5"
    worst = max(found, key=lambda one: one.used)
    numbers = worst.section.V / 1e3, worst.strength / 1e3, "kN"
    made = at_most(
        "shear", clause, f"Vu <= phi (Vc + Vs); {worst.formula}", worst.values, *numbers, worst.section.x
    )
    yield unless(if_told(subject, made), subject.doubt)
    largest = max(found, key=lambda one: one.section.V / one.most)
    most = Value("bw", web(subject), "mm"), Value("Vc", largest.Vc / 1e3, "kN")
    numbers = largest.section.V / 1e3, largest.most / 1e3, "kN"
    name, formula = "shear, size of the section", "Vu <= phi (Vc + 8 sqrt(fc') bw d)"
    yield at_most(name, "ACI 318-19 22.5.1.2", formula, most, *numbers, largest.section.x)
    share, clause = (1.0, "ACI 318-19 7.6.3.1") if member.kind == "slab" else (0.5, "ACI 318-19 9.6.3.4")
    needed = [one for one in found if one.section.V > share * shear.PHI * one.Vc]
    if needed:
        yield if_told(
            subject, _least_stirrups(subject, max(needed, key=lambda one: one.least), clause, share)
        )


def _least_stirrups(subject: Subject, one: "Sheared", clause: str, share: float) -> Check:
    member = subject.member
    spacing = member.s or PER
    values = (
        Value("Vu", one.section.V / 1e3, "kN"),
        Value("Vc", one.Vc / 1e3, "kN"),
        Value("s", spacing, "mm"),
    )
    formula = f"Av >= Av,min where Vu > {share:g} phi Vc"
    required = one.least * spacing
    return at_least(
        "least stirrups", clause, formula, values, member.Av or 0.0, required, "mm2", one.section.x
    )


class Sheared(NamedTuple):
    """A section in shear: phi Vn, Vc, the largest that the section can bear, least Av / s; N, mm."""

    section: Section
    strength: float
    Vc: float
    most: float
    least: float
    formula: str
    values: tuple[Value, ...]

    @property
    def used(self) -> float:
        """Demand over strength."""
        return self.section.V / self.strength


def _shear_at(subject: Subject, at: Section) -> Sheared:
    member, sense = subject.member, SAGGING if at.M >= 0.0 else HOGGING
    dp, bw = subject.tendon_depth(at.x, sense), web(subject)
    tension = [bar for bar in subject.bars(at.x) if subject.depth(bar.depth, sense) > 0.5 * member.h]
    As = sum(bar.area for bar in tension)
    fse = subject.effective(at.x) if member.bond == "bonded" else subject.fse
    lever = [(member.intact_area, dp), *((bar.area, subject.depth(bar.depth, sense)) for bar in tension)]
    d = max(sum(a * y for a, y in lever) / sum(a for a, _ in lever), 0.8 * member.h)
    good = shear.well_prestressed(member.intact_area, fse, member.fpu, As, member.fy)
    if good:
        ratio = at.V * dp / abs(at.M) if at.M else 1.0
        Vc, formula = shear.approximate(member.fc, bw, d, ratio), "Vc by table 22.5.6.2"
        told: tuple[Value, ...] = (Value("Vu dp / Mu", min(ratio, 1.0)),)
    else:
        Vc, told = _detailed(subject, at, sense, bw, max(dp, 0.8 * member.h))
        formula = "Vc = min(Vci, Vcw), 22.5.6.3"
    Vs = shear.stirrups(member.Av, member.s, member.fyt, d) if member.s and member.Av else 0.0
    counted = min(Vs, shear.largest(member.fc, bw, d))
    values = (Value("bw", bw, "mm"), Value("d", d, "mm"), *told, Value("Vc", Vc / 1e3, "kN"))
    values += (Value("Vs", counted / 1e3, "kN"), Value("phi", shear.PHI))
    most = shear.PHI * (Vc + shear.largest(member.fc, bw, d))
    least = shear.least_stirrups(
        member.fc, bw, d, member.fyt, (member.intact_area, member.fpu) if good else None
    )
    return Sheared(at, shear.PHI * (Vc + counted), Vc, most, least, formula, values)


def _detailed(
    subject: Subject, at: Section, sense: int, bw: float, dp: float
) -> tuple[float, tuple[Value, ...]]:
    """Vc of a section with less prestress, from cracks in flexure and in the web."""
    member, section = subject.member, subject.section
    P = subject.effective(at.x) * member.intact_area
    profile = subject.profile
    e = sense * (float(profile.depth(np.array([at.x]))[0]) - section.centroid)
    yt = section.h - section.centroid if sense == SAGGING else section.centroid
    fpe, fd = P / section.area + P * e * yt / section.inertia, sense * at.M_dead * yt / section.inertia
    M_cre = section.inertia / yt * (6.0 * shear.root(member.fc) + fpe - fd)
    Vci = shear.flexure_shear(
        member.fc, bw, dp, at.V_dead, at.V - at.V_dead, M_cre, sense * (at.M - at.M_dead)
    )
    Vp = P * at.sign * subject.slope(at.x)
    Vcw = shear.web_shear(member.fc, bw, dp, P / section.area, Vp)
    told = Value("Vci", Vci / 1e3, "kN"), Value("Vcw", Vcw / 1e3, "kN")
    return min(Vci, Vcw), tuple(value for value in told if np.isfinite(value.value))
