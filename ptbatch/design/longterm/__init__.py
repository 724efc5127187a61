"""What time takes off a tendon's stress: creep and shrinkage of the concrete, relaxation of the steel."""

from typing import NamedTuple


class TimeLoss(NamedTuple):
    """Losses of the tendon's stress [MPa], the formula they come from, and by which document."""

    creep: float
    shrinkage: float
    relaxation: float
    formula: str
    clause: str

    @property
    def total(self) -> float:
        """All of them [MPa]."""
        return self.creep + self.shrinkage + self.relaxation
