"""Rows of a published table, and the order of its columns."""

from collections.abc import Sequence
from typing import Any

from examples.paper.members import Row

HEADERS = (
    *("case", "member", "quantity", "stage", "x [mm]", "x [ft]", "deflection [mm]"),
    *("as", "against", "against_quantity", "against_x [mm]", "share_of", "bound"),
    *("value", "rtol [%]", "atol", "class", "source", "not_reproducible", "note"),
)
ARGUMENTS = {"how": "as", "x_ft": "x [ft]"}  # columns whose names are no names in Python
MIRROR = "area between the curves = Ep set, the jacked curve mirrored (what the analytic column is)"
COULOMB = "area between the curves = Ep set, friction of the lowered force (what the finite elements do)"
EQ_38 = "eq. (38) by arc length and exact angle"


def published(case: str, member: str, quantity: str, value: float | None, source: str, **others: Any) -> Row:
    """A printed number."""
    return _entry(case, member, quantity, value, "published", source, others)


def closed_form(case: str, member: str, quantity: str, value: float, source: str, **others: Any) -> Row:
    """A derived number."""
    return _entry(case, member, quantity, value, "closed form", source, others)


def _entry(
    case: str, member: str, quantity: str, value: float | None, kind: str, source: str, others: Row
) -> Row:
    """others: columns by name without unit; `how` is the column `as`, `x_ft` is `x [ft]`."""
    row = {"case": case, "member": member, "quantity": quantity, "value": value, "class": kind}
    return row | {"source": source} | {_header(name): other for name, other in others.items()}


def _header(name: str) -> str:
    if name in ARGUMENTS:
        return ARGUMENTS[name]
    return next(header for header in HEADERS if header.partition(" ")[0] == name)


def stations(
    case: str,
    member: str,
    quantity: str,
    stage: str,
    x: Sequence[float],
    values: Sequence[float],
    source: str,
    **others: Any,
) -> list[Row]:
    """Stresses along a tendon in closed form, one row a station [mm]."""
    return [
        closed_form(case, member, quantity, value, source, stage=stage, x=place, **others)
        for place, value in zip(x, values, strict=True)
    ]


def losses_along(case: str, member: str, x: Sequence[float], losses: Sequence[float]) -> list[Row]:
    """Friction losses of the finite elements between the left anchor and stations [mm], to 1 % of them."""
    return [
        closed_form(
            case, member, "stress_fe [MPa]", loss, f"{EQ_38}: friction loss up to the station",
            stage="jacked", x=0, how="difference", against_x=place, rtol=1,
            note="Finite elements / closed form between 0.99 and 1.01, at the default mesh.",
        )
        for place, loss in zip(x, losses, strict=True)
    ]  # fmt: skip


def set_loss_ratio(case: str, member: str) -> Row:
    """Set loss at the jack, finite elements / the textbook construction."""
    return closed_form(
        case, member, "loss_jacking_end_fe", 1, MIRROR, how="ratio", atol=0.03,
        against_quantity="loss_jacking_end_analytic",
        note="Finite elements / closed form between 0.97 and 1.03, at the default mesh. They follow friction "
        "of the lowered force, which loses up to 3 % less than the mirrored curve.",
    )  # fmt: skip
