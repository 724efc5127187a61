"""What time takes off a tendon's stress: creep and shrinkage of the concrete, relaxation of the steel."""

from typing import NamedTuple


class TimeLoss(NamedTuple):
    """Losses of the tendon's stress by cause [MPa], the formula they come from, and by which document; what
    the concrete does by itself: phi, the strain of creep over the elastic one, and eps_cs, the free
    shrinkage. A lump sum tells nothing of them."""

    causes: dict[str, float]
    formula: str
    clause: str
    phi: float = 0.0
    eps_cs: float = 0.0

    @property
    def total(self) -> float:
        """All of them [MPa]."""
        return sum(self.causes.values())


def by_time(
    creep: float, shrinkage: float, relaxation: float, formula: str, clause: str, phi: float, eps_cs: float
) -> TimeLoss:
    """Losses [MPa] of the three causes; phi and eps_cs as in `TimeLoss`."""
    causes = {"creep": creep, "shrinkage": shrinkage, "relaxation": relaxation}
    return TimeLoss(causes, formula, clause, phi, eps_cs)
