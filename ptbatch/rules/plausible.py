"""Values that no member has are allowed, but are probably in another unit than the header says."""

from collections.abc import Iterator

from ptbatch.rules.fault import Fault, Rule, Values, rule

# What is built: smallest and largest value (N, mm, MPa) and how it is told
BUILT = {
    "span": (500.0, 120e3, "0.5 to 120 m"),
    "b": (50.0, 30e3, "50 mm to 30 m"),
    "h": (50.0, 8e3, "50 mm to 8 m"),
    "fc": (8.0, 200.0, "8 to 200 MPa"),
    "fpu": (600.0, 2600.0, "600 to 2600 MPa"),
    "fy": (150.0, 1100.0, "150 to 1100 MPa"),
    "density": (5e-6, 45e-6, "5 to 45 kN/m3"),
    "set": (0.0, 50.0, "0 to 50 mm"),
    "mu": (0.0, 1.0, "0 to 1"),
}


def _plausible(name: str) -> Rule:
    least, most, told = BUILT[name]

    @rule(name)
    def built(v: Values) -> Iterator[Fault]:
        values = v[name] if isinstance(v[name], tuple) else (v[name],)
        if not all(least <= value <= most for value in values):
            yield Fault(name, v[name], f"far from what is built: {told}", "check the unit in the header")

    return built


WARNINGS: tuple[Rule, ...] = tuple(map(_plausible, BUILT))
"""One a column."""
