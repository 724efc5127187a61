"""The checks of shear."""

from collections.abc import Iterator, Sequence

from ptbatch.design.check import Check, Value, at_least, at_most, unless
from ptbatch.design.ec2 import shear
from ptbatch.design.shear import Section, if_told, sections, web
from ptbatch.design.subject import HOGGING, SAGGING, Combination, Subject

PER = 1000.0  # mm, spacing for which least stirrups are told where there are none


def shear_checks(subject: Subject, combinations: Sequence[Combination]) -> Iterator[Check]:
    """The section that is used most by shear, 0.8 h from the supports and further, and the
    least stirrups of a beam. The vertical part of the prestress counts with VEd."""
    member, gross = subject.member, subject.section
    bw = web(subject)
    worst: tuple[float, Section, float, tuple[Value, ...], str] | None = None
    for at in sections(subject, combinations, 0.8 * member.h):
        sense = SAGGING if at.M >= 0.0 else HOGGING
        P = subject.effective(at.x) * member.intact_area
        bars = [bar for bar in subject.bars(at.x) if subject.depth(bar.depth, sense) > 0.5 * member.h]
        Asl = sum(bar.area for bar in bars)
        d = max([subject.depth(bar.depth, sense) for bar in bars], default=subject.tendon_depth(at.x, sense))
        if member.bond == "bonded":
            Asl, d = Asl + member.intact_area, max(d, subject.tendon_depth(at.x, sense))
        d = max(d, 0.5 * member.h)
        Vp = P * at.sign * subject.slope(at.x)
        alone = shear.without_stirrups(member.fc, bw, d, Asl / (bw * d), P / gross.area)
        strength, formula = alone, "VEd <= VRd,c (6.2)"
        if member.s and member.Av:
            given = member.Av / member.s, member.fyt, P / gross.area
            tied = shear.with_stirrups(member.fc, bw, 0.9 * d, *given)
            if tied > alone:
                strength, formula = tied, "VEd <= min(VRd,s, VRd,max) (6.8), (6.9)"
        V = abs(at.V - Vp)
        if worst is None or V / strength > worst[0]:
            put_in = [
                ("bw", bw, "mm"),
                ("d", d, "mm"),
                ("Asl", Asl, "mm2"),
                ("sigma,cp", P / gross.area, "MPa"),
            ]
            put_in += [("V", at.V / 1e3, "kN"), ("Vp", Vp / 1e3, "kN"), ("VRd,c", alone / 1e3, "kN")]
            values = tuple(Value(*one) for one in put_in)
            worst = V / strength, at._replace(V=V), strength, values, formula
    if worst is None:
        return
    _, at, strength, values, formula = worst
    numbers = at.V / 1e3, strength / 1e3, "kN"
    made = at_most("shear", "EN 1992-1-1 6.2", formula, values, *numbers, at.x)
    yield unless(if_told(subject, made), subject.doubt)
    if member.kind == "beam":
        spacing = member.s or PER
        least = shear.least_stirrups(member.fc, bw, member.fyt) * spacing
        told = Value("bw", bw, "mm"), Value("fywk", member.fyt, "MPa"), Value("s", spacing, "mm")
        formula, clause = "Asw >= 0.08 sqrt(fck) / fyk bw s", "EN 1992-1-1 9.2.2 (5)"
        made = at_least("least stirrups", clause, formula, told, member.Av or 0.0, least, "mm2")
        yield if_told(subject, made)
