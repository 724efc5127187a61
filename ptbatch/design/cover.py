"""Cover of the tendon."""

from dataclasses import replace

from ptbatch.design.check import INFO, PASS, Check, Value, at_least
from ptbatch.design.subject import Subject

TO_AXIS = "counted to the tendon's axis: give duct"


def cover(subject: Subject, clause: str, required: float) -> Check:
    """Least clear cover of the tendon inside the member, above and below; required [mm] unless the member
    names its own. Without the size of the duct it cannot be passed, but told."""
    member = subject.member
    x = subject.moments.x
    depth = subject.profile.depth(x)
    at = int((depth.clip(max=member.h - depth)).argmin())
    clear = float(min(depth[at], member.h - depth[at])) - 0.5 * (member.duct or 0.0)
    wanted = required if member.cover is None else member.cover
    values = (Value("depth", float(depth[at]), "mm"), Value("duct", member.duct or 0.0, "mm"))
    made = at_least("cover", clause, "cover >= required", values, clear, wanted, "mm", float(x[at]))
    if member.duct or made.outcome != PASS:
        return made
    return replace(made, outcome=INFO, utilisation=None, reason=TO_AXIS)
