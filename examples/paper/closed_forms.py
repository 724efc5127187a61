"""Members whose answers are known in closed form, as rows by header: rigid beams, a prism, two sections.

A rigid beam keeps its tendon where it was drawn, so that friction is that of eq. (38) and nothing else.
"""

from math import cos, sin

from examples.paper.members import Row, imaginary_beam, specimens

RIGID: Row = {
    "concrete_law": "elastic",
    "Ec [MPa]": 1e9,
    "tendon_law": "elastic",
    "self_weight": "no",
    "deflection_limit [mm]": 0.01,  # how a rigid beam is loaded is of no interest
}
KINKS, FAN = 45, 0.6  # of the 90-ft tendon: number of its kinks, all that they turn [rad]


def rigid(row: Row, member: str, note: str) -> Row:
    """The same member, of a concrete that does not give."""
    units = {name: value for name, value in row.items() if not name.startswith("deflection_limit")}
    return units | RIGID | {"member": member, "note": note}


def rigid_members_of_the_paper() -> list[Row]:
    """The imaginary beam and both specimens with both sets."""
    beam, *_ = imaginary_beam()
    beams = [row for row in specimens() if row["set [in]"]]
    notes = ("The imaginary beam, made rigid.", "The specimen, made rigid; its profile is reconstructed.")
    straight_pieces = {"sheathing": "polygon"}
    return [
        rigid(beam, "Imaginary beam, rigid", notes[0]),
        rigid(beam | straight_pieces, "Imaginary beam, rigid, polygon", notes[0]),
        *(rigid(row, f"{row['member']}, rigid", notes[1]) for row in beams),
    ]


def parabolas() -> list[Row]:
    """Ahmad's parabola of 20 m: as published, with little friction, with two live ends, and with none."""
    beam = RIGID | {
        "span [mm]": 20000,
        **{"b [mm]": 500, "h [mm]": 1200},
        "fc [MPa]": 40,
        "Aps [mm2]": 2850,
        "dp [mm]": "300; 858; 300",
        "fpj [MPa]": 1239,
        "set [mm]": 5,
    }
    published = {"mu [1/rad]": 0.25, "K [1/m]": 0.0017}
    little = {"mu [1/rad]": 0.1, "K [1/m]": 0.00017}
    none = {"mu [1/rad]": 0, "K [1/m]": 0}
    source = "Ahmad, SAB4323 example 4.3, made rigid; the section is ours."
    weak = "The same with so little friction that the set reaches the far end."
    return [
        {"member": "20 m parabola, rigid", **beam, **published, "note": source},
        {"member": "20 m parabola, set all along", **beam, **little, "note": weak},
        {"member": "20 m parabola, two live ends", **beam, **published, "jack": "both", "note": source},
        {"member": "20 m parabola, both all along", **beam, **little, "jack": "both", "note": weak},
        {"member": "20 m parabola, no friction", **beam, **none, "note": "The same without friction."},
    ]


def tendon_of_90_ft() -> Row:
    """Three times 30 ft with 0.2 rad each."""
    return RIGID | {
        "member": "90-ft tendon, rigid",
        "span [ft]": fan()[-1][0],
        **{"b [in]": 24, "h [in]": 120},
        "fc [ksi]": 5,
        "Aps [in2]": 1.53,
        "Ep [ksi]": 28000,
        "fpj [ksi]": 202.5,
        "set [in]": 0.375,
        "mu [1/rad]": 0.25,
        "K [1/ft]": 0.0002,
        "note": "Profile: made up, 45 equal kinks every 2 ft along the tendon, so that each 30 ft of it "
        "turn by 0.2 rad and it is 90 ft long; see the sheet profile.",
    }


def fan() -> list[tuple[float, float]]:
    """x and depth [ft] of a tendon that turns evenly: equal kinks at the middles of equal lengths."""
    piece = 90.0 / KINKS
    x, depth = [0.0], [1.0]
    for i in range(KINKS + 1):
        slope = FAN * (0.5 - i / KINKS)
        length = piece if 0 < i < KINKS else piece / 2.0
        x.append(x[-1] + length * cos(slope))
        depth.append(depth[-1] + length * sin(slope))
    return list(zip(x, depth, strict=True))


def fan_x(along: float) -> float:
    """x [ft] at a length [ft] along that tendon."""
    piece = 90.0 / KINKS
    ends = [0.0, *(piece * (i + 0.5) for i in range(KINKS)), 90.0]
    i = next(i for i, end in enumerate(ends[1:]) if along <= end)
    (x, _), (x_next, _) = fan()[i : i + 2]
    return x + (x_next - x) * (along - ends[i]) / (ends[i + 1] - ends[i])


def prism() -> Row:
    """code_aster SSNP108: a centric cable in a prism, jacked until the gauge reads 200 kN."""
    return {
        "member": "SSNP108 prism",
        "span [mm]": 2000,
        **{"b [mm]": 1000, "h [mm]": 1200},
        "fc [MPa]": 30,
        "Ec [MPa]": 30000,
        "concrete_law": "elastic",
        "self_weight": "no",
        "Aps [mm2]": 150,
        "Ep [MPa]": 210000,
        "tendon_law": "elastic",
        "profile": "straight",
        "dp [mm]": 600,
        "fpj [MPa]": 200e3 / 150,
        **{"set [mm]": 0, "mu [1/rad]": 0, "K [1/m]": 0},
        "deflection_limit [mm]": 0.1,
        "note": "code_aster SSNP108: prism of 1.2 m2, its section made up; 200 kN at the gauge.",
    }


def elastic_beam() -> Row:
    """A straight eccentric tendon of small force in an elastic beam."""
    return {
        "member": "Elastic beam, eccentric tendon",
        "span [mm]": 10000,
        **{"b [mm]": 300, "h [mm]": 400},
        "fc [MPa]": 30,
        "Ec [MPa]": 30000,
        "concrete_law": "elastic",
        "self_weight": "no",
        "layers": 100,
        "Aps [mm2]": 1000,
        "tendon_law": "elastic",
        "profile": "straight",
        "dp [mm]": 300,
        "fpj [MPa]": 10,
        **{"set [mm]": 0, "mu [1/rad]": 0, "K [1/m]": 0},
        "live": "midspan",
        "deflection_limit [mm]": 1,
        "note": "Made up: P = 10 kN at e = 100 mm.",
    }


def sections() -> list[Row]:
    """A section 300 x 600 of which the strength is known, grouted and unbonded."""
    beam = {
        "span [mm]": 8000,
        **{"b [mm]": 300, "h [mm]": 600},
        "fc [MPa]": 26.67,
        "concrete_law": "parabola-rectangle",
        "tension_law": "none",
        "self_weight": "no",
        "Aps [mm2]": 1000,
        "tendon_law": "bilinear",
        **{"fpy [MPa]": 1391.2, "fpu [MPa]": 1391.4},  # all but level
        "profile": "straight",
        "dp [mm]": 500,
        "fpe [MPa]": 1100,
        **{"set [mm]": 0, "mu [1/rad]": 0, "K [1/m]": 0},
        "note": "Section strengths: structuralcodes 0.7.2.",
    }
    cases = [("bonded", "third-points"), ("unbonded", "third-points"), ("unbonded", "midspan")]
    return [
        {"member": f"300 x 600, {bond}, {live}", **beam, "bond": bond, "live": live} for bond, live in cases
    ]


def closed_forms() -> list[Row]:
    """All members of this module."""
    return [
        *rigid_members_of_the_paper(),
        *parabolas(),
        tendon_of_90_ft(),
        prism(),
        elastic_beam(),
        *sections(),
    ]
