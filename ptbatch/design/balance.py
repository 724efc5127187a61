"""What a designer wants to know of a prestress, whatever the code: its mean, what it balances, its bends."""

from collections.abc import Iterator

import numpy as np

from ptbatch.design.check import INFO, Check, Value
from ptbatch.design.subject import Subject
from ptbatch.geometry.profile import ideal_profile
from ptbatch.member import Member
from ptbatch.model.loading import self_weight, sustained, total

NONE = float("nan")
CLAUSE = "for information"


def about_prestress(subject: Subject) -> Iterator[Check]:
    """Mean prestress, the load that it balances in each span, and the least radius of the tendon."""
    member = subject.member
    P, area = subject.fse * member.intact_area, subject.section.area
    values = (Value("P", P / 1e3, "kN"), Value("A", area, "mm2"))
    yield _info("mean prestress", "P / A", values, P / area, "MPa")
    for i, (span, share) in enumerate(zip(member.span, balanced(member), strict=True), 1):
        load = P * share
        dead = total([*self_weight(member), *sustained(member)]) / member.total_length
        sag = share * span**2 / 8.0
        put_in = (Value("P", P / 1e3, "kN"), Value("sag", sag, "mm"), Value("L", span, "mm"))
        of_dead = f"{load / dead:.0%} of all dead load" if dead > 0.0 else ""
        x = member.support_x[i - 1] + 0.5 * span
        yield _info(f"balanced load, span {i}", "8 P sag / L^2", put_in, load, "kN/m", x, of_dead)
    if (radius := least_radius(member)) is not None:
        yield _info("least radius of the tendon", "1 / d2y/dx2", (), radius, "mm")


def balanced(member: Member) -> list[float]:
    """Load that a tendon balances in each span, over its force [1/mm]: of the parabola that has its sag in
    the middle of the span."""
    profile = ideal_profile(member)
    ends = zip(member.support_x, member.support_x[1:], strict=False)
    found = []
    for a, b in ends:
        left, middle, right = profile.depth(np.array([a, 0.5 * (a + b), b]))
        found.append(float(8.0 * (middle - 0.5 * (left + right)) / (b - a) ** 2))
    return found


def least_radius(member: Member) -> float | None:
    """Of all curved pieces of the tendon [mm]; None where it is straight between its kinks."""
    bend = 2.0 * np.abs(ideal_profile(member).coefficients[:, 2])
    return float(1.0 / bend.max()) if bend.max() > 0.0 else None


def _info(
    name: str, formula: str, values: tuple[Value, ...], value: float, unit: str, x: float | None = None,
    reason: str = "",
) -> Check:  # fmt: skip
    return Check(name, CLAUSE, formula, values, value, NONE, unit, None, INFO, x, reason)
