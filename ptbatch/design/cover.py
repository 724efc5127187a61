"""Cover of the tendon."""

from ptbatch.design.check import Check, Value, at_least, unless
from ptbatch.design.sections import Subject
from ptbatch.geometry.profile import ideal_profile

TO_AXIS = "counted to the tendon's axis: give duct"


def cover(subject: Subject, clause: str, required: float) -> Check:
    """Least clear cover of the tendon inside the member, above and below; required [mm] unless the member
    names its own."""
    member = subject.member
    x = subject.moments.x
    depth = ideal_profile(member).depth(x)
    at = int((depth.clip(max=member.h - depth)).argmin())
    clear = float(min(depth[at], member.h - depth[at])) - 0.5 * (member.duct or 0.0)
    wanted = required if member.cover is None else member.cover
    values = (Value("depth", float(depth[at]), "mm"), Value("duct", member.duct or 0.0, "mm"))
    made = at_least("cover", clause, "cover >= required", values, clear, wanted, "mm", float(x[at]))
    return unless(made, "" if member.duct else TO_AXIS)
