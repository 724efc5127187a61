"""The checks of a member by the standard that its row names."""

from collections.abc import Callable, Iterable, Sequence

from ptbatch.design.aci318.checks import checks as aci318
from ptbatch.design.check import FAIL, INFO, PASS, REVIEW, Check
from ptbatch.design.ec2.checks import checks as ec2
from ptbatch.design.sections import Subject, subject
from ptbatch.member import Member
from ptbatch.response import Response

STANDARDS: dict[str, Callable[[Subject], Iterable[Check]]] = {"ACI 318-19": aci318, "EN 1992-1-1": ec2}


def checks(member: Member, response: Response) -> list[Check]:
    """All checks; none where no standard is asked for, or where the member was not anchored."""
    make = STANDARDS.get(member.standard)
    about = make and subject(member, response)
    return list(make(about)) if make and about else []


def outcome(found: Sequence[Check]) -> str:
    """The gravest outcome of all."""
    outcomes = {check.outcome for check in found} - {INFO}
    return next((name for name in (FAIL, REVIEW, PASS) if name in outcomes), INFO)


def governing(found: Sequence[Check]) -> Check | None:
    """The check that is used most."""
    compared = [check for check in found if check.utilisation is not None]
    return max(compared, key=lambda check: check.utilisation or 0.0, default=None)
