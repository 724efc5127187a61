"""What time takes off a tendon's stress: creep and shrinkage of the concrete, relaxation of the steel."""

from typing import NamedTuple


class TimeLoss(NamedTuple):
    """Losses of the tendon's stress by cause [MPa], the formula they come from, and by which document."""

    causes: dict[str, float]
    formula: str
    clause: str

    @property
    def total(self) -> float:
        """All of them [MPa]."""
        return sum(self.causes.values())


def by_time(creep: float, shrinkage: float, relaxation: float, formula: str, clause: str) -> TimeLoss:
    """Losses [MPa] of the three causes."""
    return TimeLoss({"creep": creep, "shrinkage": shrinkage, "relaxation": relaxation}, formula, clause)
