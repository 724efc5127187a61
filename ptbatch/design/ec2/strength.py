"""Bending resistance of a section of a member."""

from collections.abc import Callable

from ptbatch.design.bending import Resistance
from ptbatch.design.check import Value
from ptbatch.design.ec2 import flexure
from ptbatch.design.flexure import Steel, constant, elastic_plastic, strength
from ptbatch.design.subject import Subject

GAMMA_S = 1.15
STRENGTHS = 12.0, 90.0  # MPa, fck of table 3.1
BEYOND = "fck is not within the 12 to 90 MPa of table 3.1"


def resistance(subject: Subject, x: float, sense: int) -> Resistance:
    """MRd at a place, and the resistance without partial factors."""
    design, values, stress = _moment(subject, x, sense, 1.5, GAMMA_S)
    nominal, _, mean_stress = _moment(subject, x, sense, 1.0, 1.0)
    doubt = "" if STRENGTHS[0] <= subject.member.fc <= STRENGTHS[1] else BEYOND
    return Resistance(design, nominal, values + (Value("sigma,p", stress, "MPa"),), mean_stress, doubt)


def _moment(
    subject: Subject, x: float, sense: int, gamma_c: float, gamma_s: float
) -> tuple[float, tuple[Value, ...], float]:
    """Resistance [N mm], its numbers, and the stress of the tendon [MPa]."""
    member = subject.member
    tendon, dp = _tendon(subject, x, sense, gamma_s), subject.tendon_depth(x, sense)
    steel = [Steel(dp, member.intact_area, tendon)]
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
    return lambda strain: min(max(effective + member.Ep * strain, -most), most)
