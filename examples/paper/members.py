"""Members of the paper's numerical studies, as rows by header.

Huang and Kang (2018), Modeling of sliding behavior of unbonded tendons in post-tensioned concrete members,
ACI Structural Journal 115(4), 1153-1164; it models Specimens 1 and 2 of Burns et al. (1991), beams A of Tao
and Du (1985) and Slabs 4 and 5 of Cooke et al. (1981). What it does not print is named in the notes.
"""

from itertools import product
from typing import Any

Row = dict[str, Any]


def imaginary_beam() -> list[Row]:
    """One beam in three meshes, which should agree."""
    beam = {
        "span [mm]": 15200,
        "b [mm]": 254,
        "h [mm]": 1016,
        "fc [MPa]": 27.6,
        "ft [MPa]": 3.3,
        "Aps [mm2]": 987,
        "dp [mm]": "508; 787; 508",
        "fpj [MPa]": 1407,
        "set [mm]": 0.5,
        "mu [1/rad]": 0.3,
        "K [1/m]": 0,
    }
    source = (
        "Huang and Kang (2018), Fig. 6: all published but Ep. Their losses, analytical and FEA: 3.5 and "
        "3.2 % at the jack, 4.2 and 4.9 % at the fixed end. The closed form gives 2.8 and 4.3 %."
    )
    return [
        {"member": f"Imaginary beam, {n} el.", **beam, "elements": n, "note": source} for n in (20, 40, 60)
    ]


def specimens() -> list[Row]:
    """Two-span beams in US units, with both wedge sets (1.27 and 3.18 mm in the paper) and with none; those
    with a set also with wobble as waves.

    Profile: anchored at mid-depth, low points at midspan, strands 3.25 in from the faces. Least bars by ACI:
    0.004 of the area between face and centroid.
    """
    both = {
        "span [ft]": "25; 25",
        "support_left": "roller",
        "support_right": "roller",  # the middle support is the pin
        "b [in]": 12,
        "fc [ksi]": 4.5,
        "Aps [in2]": 0.459,
        "fpu [ksi]": 270,
        "Ep [ksi]": 29000,
        "inflection": 0.15,
        "fpj [ksi]": 202,
        "mu [1/rad]": 0.07,
        "K [1/ft]": 0.001,
        "fy [ksi]": 60,
        "live": "midspan",
        "live_spans": 2,
        "deflection_limit [in]": 3,
    }
    first = both | {
        **{"h [in]": 14, "dp [in]": "7; 10.75; 3.25; 10.75; 7"},
        **{"As [in2]": 0.40, "ds [in]": 12, "As_top [in2]": 0.40, "ds_top [in]": 2},  # two No. 4
    }
    second = both | {
        **{"h [in]": 22, "dp [in]": "11; 18.75; 3.25; 18.75; 11"},
        **{"As [in2]": 0.62, "ds [in]": 20, "As_top [in2]": 0.62, "ds_top [in]": 2},  # two No. 5
    }
    source = (
        "Burns et al. (1991), published in Huang and Kang (2018). Profile: reconstructed from their "
        "analytical losses. ASSUMED: fc; bars, the least that ACI asks for at either face."
    )
    beams = {"Specimen 1": first, "Specimen 2": second}
    sets = {"no set": 0, "set 0.05 in": 0.05, "set 0.125 in": 0.125}
    direct = [
        {"member": f"{name}, {told}", **beam, "set [in]": wedge_set, "note": source}
        for (name, beam), (told, wedge_set) in product(beams.items(), sets.items())
    ]
    wavy = {"wobble": "sine", "note": f"{source} Wobble as waves that turn evenly."}
    waves = [row | wavy | {"member": f"{row['member']}, waves"} for row in direct if row["set [in]"]]
    return direct + waves


def specimen_2_with_every_bond() -> list[Row]:
    """Specimen 2 as the paper loads it, to 76 mm at the middle of the span away from the jack: partially
    bonded, perfectly unbonded and grouted; unbonded also without the correction of the contact force."""
    beam = next(row for row in specimens() if row["member"] == "Specimen 2, set 0.05 in")
    none = {"mu [1/rad]": 0, "K [1/ft]": 0}
    ways: dict[str, Row] = {
        "friction": {},
        "no friction": none,
        "grouted": {"bond": "bonded"},
        "no friction, uncorrected": none | {"correction": "no"},
        "no friction, polygon": none | {"sheathing": "polygon"},
        "no friction, polygon, uncorrected": none | {"sheathing": "polygon", "correction": "no"},
    }
    near = {"deflection_limit [in]": 1}  # whose steps are a third as long, where friction matters most
    ways |= {"friction, to 1 in": near, "no friction, to 1 in": none | near}
    return [beam | values | {"member": f"Specimen 2, {name}"} for name, values in ways.items()]


def tao_and_du() -> list[Row]:
    """Five single-span beams with and without friction, which should hardly matter."""
    beam = {
        "span [mm]": 4200,
        "b [mm]": 160,
        "h [mm]": 279,
        "fpu [MPa]": 1790,
        "fpy [MPa]": 1465,
        "Ep [MPa]": 205000,
        "profile": "straight",
        "dp [mm]": 220,
        "set [mm]": 0,
        "K [1/m]": 0,
        "ds [mm]": 250,
        "live": "third-points",
    }
    # name: Aps, As, fy, fc, fpe
    tested = {
        "A-1": (58.8, 157, 267, 30.6, 960),
        "A-2": (98.0, 157, 430, 30.6, 904),
        "A-3": (156.8, 236, 430, 30.6, 820),
        "A-6": (156.8, 462, 400, 30.6, 854),
        "A-9": (156.8, 804, 395, 33.1, 920),
    }
    headers = ("Aps [mm2]", "As [mm2]", "fy [MPa]", "fc [MPa]", "fpe [MPa]")
    source = (
        "Tao and Du (1985), published in Huang and Kang (2018). UNVERIFIED INPUT: Aps, As, fy, fc, fpe, "
        "wire, as they are in wide circulation. No set: fpe is the stress after it."
    )
    rows = [
        {"member": f"{name}, mu {mu}", **beam, **dict(zip(headers, values, strict=True))}
        | {"mu [1/rad]": mu, "note": source}
        for (name, values), mu in product(tested.items(), (0.3, 0))
    ]
    near = {"deflection_limit [mm]": 35}  # whose steps are 0.4 as long, where one crack opens after the other
    return rows + [row | near | {"member": f"{row['member']}, to 35 mm"} for row in rows[:2]]


def cooke_slabs() -> list[Row]:
    """Two one-way slabs without bars."""
    slab = {
        "kind": "slab",
        "span [mm]": 3530,
        "h [mm]": 180,
        "fc [MPa]": 35,
        "Aps [mm2]": 296.1,
        "profile": "straight",
        "dp [mm]": 120,
        "fpe [MPa]": 1100,
        "set [mm]": 0,
        "mu [1/rad]": 0,
        "K [1/m]": 0,
        "live": "third-points",
    }
    source = (
        "Cooke et al. (1981), published in Huang and Kang (2018). ASSUMED: fc, fpe, 98.7 mm2 a strand. "
        "Span: their 11 ft 7 in; dp: their eccentricity of 120 mm, which would lie outside the slab."
    )
    widths = {"Slab 4": 353, "Slab 5": 705}
    return [{"member": name, **slab, "b [mm]": b, "note": source} for name, b in widths.items()]
