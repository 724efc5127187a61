"""The checks of a member by the standard that its row names."""

from collections.abc import Callable, Iterable, Iterator, Sequence

from ptbatch.design.aci318.checks import checks as aci318
from ptbatch.design.balance import about_prestress
from ptbatch.design.check import FAIL, INFO, PASS, REVIEW, Check, Value
from ptbatch.design.ec2.checks import checks as ec2
from ptbatch.design.subject import Subject
from ptbatch.member import Member
from ptbatch.response import ANCHORED, Response

STANDARDS: dict[str, Callable[[Subject], Iterable[Check]]] = {"ACI 318-19": aci318, "EN 1992-1-1": ec2}


def subject(member: Member, response: Response) -> Subject | None:
    """What there is to check; None where no standard is asked for, the member was not anchored, or time takes
    all of its prestress."""
    if member.standard not in STANDARDS or ANCHORED not in response.tendon:
        return None
    about = Subject(member, response)
    return about if about.fse > 0.0 else None


def checks(about: Subject | None) -> list[Check]:
    """All checks of what there is to check."""
    if about is None:
        return []
    return [*_time(about), *STANDARDS[about.member.standard](about), *about_prestress(about)]


def _time(about: Subject) -> Iterator[Check]:
    """The long-term loss and what it is made of; nothing is compared."""
    loss = about.response.time_loss
    if loss is None:
        return
    values = tuple(Value(name, value, "MPa") for name, value in loss.causes.items())
    values += (Value("fse", about.fse, "MPa"),)
    anchored = about.fse + loss.total
    numbers = loss.total, anchored, "MPa", None, INFO
    yield Check("long-term loss", loss.clause, loss.formula, values, *numbers)


def outcome(found: Sequence[Check]) -> str:
    """The gravest outcome of all."""
    outcomes = {check.outcome for check in found} - {INFO}
    return next((name for name in (FAIL, REVIEW, PASS) if name in outcomes), INFO)


def governing(found: Sequence[Check]) -> Check | None:
    """The check that is used most."""
    compared = [check for check in found if check.utilisation is not None]
    return max(compared, key=lambda check: check.utilisation or 0.0, default=None)
