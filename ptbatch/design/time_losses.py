"""The long-term loss of a member's tendon, by the document that goes with its standard."""

import numpy as np

from ptbatch.design.longterm import TimeLoss, ec2, zia
from ptbatch.design.subject import Subject
from ptbatch.geometry.section import gross_section
from ptbatch.member import Member
from ptbatch.response import Response

CURED = 3.0  # days of moist curing, at most: drying begins then
CLASSES = {"normal": 1, "low": 2}  # of EN 1992-1-1
YEAR = 365.0


def takes_time(member: Member) -> bool:
    """Whether anything is known of what time takes."""
    return member.long_term_loss is not None or member.RH is not None


def time_loss(anchored: Response) -> TimeLoss | None:
    """What time takes of an anchored tendon: the lump sum given, or creep, shrinkage and relaxation by the
    document that goes with the standard; None where neither that nor RH is given."""
    member, RH = anchored.member, anchored.member.RH
    if member.long_term_loss is not None:
        return TimeLoss({"lump sum": member.long_term_loss}, "as given", "long_term_loss")
    if RH is None:
        return None
    subject = Subject(member, anchored)
    return by_ec2(subject, RH) if subject.member.standard == "EN 1992-1-1" else by_zia(subject, RH)


def volume_to_surface(member: Member) -> float:
    """Area over the outer perimeter, ledges included [mm]."""
    section = gross_section(member)
    ledges = float(np.abs(np.diff(section.width)).sum())
    return section.area / (float(section.width[0] + section.width[-1]) + 2.0 * section.h + ledges)


def compression_at_tendon(subject: Subject) -> float:
    """Of the concrete at the tendon, under prestress, dead load and the sustained share of the live load
    [MPa]: the mean along the member of an unbonded tendon, where a member with a bonded one bends most."""
    member, moments, section = subject.member, subject.moments, subject.section
    x = moments.x
    e, P = subject.eccentricity, (subject.anchored - subject.time_loss) * member.intact_area
    sustained = moments.dead + member.live_sustained * moments.live + moments.secondary
    stress = P / section.area + (P * e - sustained) * e / section.inertia
    if member.bond == "unbonded":
        return float(np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(x)) / (x[-1] - x[0]))
    return float(stress[int(np.abs(moments.dead + moments.live).argmax())])


def by_zia(subject: Subject, RH: float) -> TimeLoss:
    """ACI 423.10R; RH in %."""
    member = subject.member
    stress, V_S = compression_at_tendon(subject), member.V_S or volume_to_surface(member)
    given = V_S, RH, member.age_stressing, member.relaxation
    return zia.losses(stress, subject.fse, member.fpu, member.Ep, member.Ec, *given)


def by_ec2(subject: Subject, RH: float) -> TimeLoss:
    """EN 1992-1-1, 5.10.6; RH in %."""
    member, section = subject.member, subject.section
    fck, t0 = member.fc, member.age_stressing
    t, ts = t0 + member.design_life * YEAR, min(CURED, t0)
    h0 = 2.0 * (member.V_S or volume_to_surface(member))
    phi = ec2.creep_coefficient(t, t0, RH, h0, fck, member.cement)
    dried = [ec2.drying_shrinkage(time, ts, RH, h0, fck, member.cement) for time in (t, t0)]
    own = ec2.autogenous_shrinkage(t, fck) - ec2.autogenous_shrinkage(t0, fck)
    relaxed = ec2.relaxation(subject.fse / member.fpu, ec2.FOR_GOOD, CLASSES[member.relaxation]) * subject.fse
    e = subject.eccentricity
    zcp = float(np.sqrt(np.mean(e**2))) if member.bond == "unbonded" else float(np.abs(e).max())
    steel, concrete = (member.Ep, ec2.modulus(fck), member.intact_area), (section.area, section.inertia, zcp)
    shrinkage = dried[0] - dried[1] + own
    return ec2.losses(compression_at_tendon(subject), *steel, *concrete, phi, shrinkage, relaxed)
