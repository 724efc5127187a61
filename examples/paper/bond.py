"""What the paper says of bond and of the correction of the contact force, as statements on Specimen 2."""

from examples.paper.entries import published
from examples.paper.findings import CLEARLY, FRICTION, NONE, PAPER
from examples.paper.members import Row

CASE = "Specimen 2, bond and correction"
GROUTED = "Specimen 2, grouted"
UNIFORM = "0.001 MPa is our zero."


def bond() -> list[Row]:
    """All entries of this module."""
    return [*degrees_of_bond(), *correction()]


def degrees_of_bond() -> list[Row]:
    """No friction, friction and grout, in service: the more bond, the more the stress follows the moments."""
    source = f"{PAPER}: frictionless contact is perfectly unbonded, frictional partially bonded; bond sticks"
    partly = f"{CLEARLY} bond = unbonded with mu above zero is partially bonded: it rubs in service as well."
    more = "Grouted after anchoring, the tendon starts with the 1233 to 1348 MPa of the one with friction;"
    grouted = {"how": "ratio", "against": FRICTION}
    return [
        _spread(NONE, 0.001, "at most", source, UNIFORM),
        _spread(FRICTION, 20, "at least", source, partly),
        published(CASE, GROUTED, "tendon_stress_max", 1.05, source, deflection=76, bound="at least",
                  note=f"{more} in the cracks it ends 5 % and more above it.", **grouted),
        published(CASE, GROUTED, "tendon_stress_min", 0.95, source, deflection=76, bound="at most",
                  note=f"{more} far from them it ends 5 % and more below it.", **grouted),
        published(CASE, GROUTED, "load_peak", 1, source, bound="at least", **grouted),
    ]  # fmt: skip


def correction() -> list[Row]:
    """Stress of a frictionless tendon, which should be one, with either duct."""
    source = f"{PAPER}: without the correction force the contact makes artificial loss or gain of prestress"
    untrue = "0.1 MPa: a hundred times our zero, where the corrected tendon has one stress."
    return [
        _spread("Specimen 2, no friction, polygon", 0.001, "at most", source, UNIFORM),
        *(
            _spread(f"{member}, uncorrected", 0.1, "at least", source, untrue)
            for member in (NONE, "Specimen 2, no friction, polygon")
        ),
    ]


def _spread(member: str, limit: float, bound: str, source: str, note: str) -> Row:
    """Largest less least tendon stress at 76 mm."""
    return published(
        CASE, member, "tendon_stress_max [MPa]", limit, source, deflection=76, how="difference",
        against_quantity="tendon_stress_min", bound=bound, note=f"Largest less least stress. {note}",
    )  # fmt: skip
