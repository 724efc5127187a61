"""Flexural strength of a section of a member."""

from ptbatch.design.aci318 import flexure, tendon_stress
from ptbatch.design.bending import Resistance
from ptbatch.design.check import Value
from ptbatch.design.flexure import Steel, constant, elastic_plastic, strength
from ptbatch.design.subject import Subject

TOO_LITTLE = "fse is below 0.5 fpu: fps by 20.3.2.3 and 20.3.2.4 does not hold, it is taken as fse"


def resistance(subject: Subject, x: float, sense: int) -> Resistance:
    """phi Mn and Mn at a place."""
    member = subject.member
    fps = nominal_stress(subject, x, sense)
    fse = subject.effective(x) if member.bond == "bonded" else subject.fse
    doubt = "" if tendon_stress.applies(fse, member.fpu) else TOO_LITTLE
    steel = [Steel(subject.tendon_depth(x, sense), member.intact_area, constant(fps))]
    steel += [
        Steel(subject.depth(bar.depth, sense), bar.area, elastic_plastic(member.Es, bar.fy))
        for bar in subject.bars(x)
    ]
    found = strength(subject.strips(sense), flexure.block(member.fc), steel)
    if found is None:
        return Resistance(0.0, 0.0, (Value("fps", fps, "MPa"),), fps, doubt)
    phi = flexure.phi(found.deepest_strain)
    values = (Value("fps", fps, "MPa"), Value("c", found.c, "mm"), Value("phi", phi))
    return Resistance(phi * found.moment, found.moment, values, fps, doubt)


def nominal_stress(subject: Subject, x: float, sense: int) -> float:
    """fps [MPa]; where the tendon lies in the compressed half, or fse is below 0.5 fpu and the expressions do
    not hold, no more than fse."""
    member = subject.member
    fse = subject.effective(x) if member.bond == "bonded" else subject.fse
    dp = subject.tendon_depth(x, sense)
    if dp <= 0.5 * member.h or not tendon_stress.applies(fse, member.fpu):
        return fse
    width = subject.strips(sense)[0][1]
    rho_p = member.intact_area / (width * dp)
    if member.bond == "unbonded":
        slender = subject.span_at(x) / member.h
        return tendon_stress.unbonded(fse, member.fc, rho_p, member.fpy, slender)
    tension = [bar for bar in subject.bars(x) if subject.depth(bar.depth, sense) > 0.5 * member.h]
    area = sum(bar.area for bar in tension)
    d = sum(bar.area * subject.depth(bar.depth, sense) for bar in tension) / area if area else dp
    omega = sum(bar.area * bar.fy for bar in tension) / (width * d * member.fc)
    beta1 = flexure.beta1(member.fc)
    return tendon_stress.bonded(member.fpu, member.fpy, member.fc, beta1, rho_p, d / dp, omega, 0.0, 0.0)
