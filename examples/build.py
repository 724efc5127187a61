"""Build the workbooks that are shipped: `python -m examples.build` after any change of a row or a column.

`examples/beams.xlsx` holds two members of an office and published ones; its notes tell the sources.
`templates/` holds the templates in SI and in US units. The same rows make the same files, byte by byte.

Sources:
  Huang and Kang (2018), Modeling of sliding behavior of unbonded tendons in post-tensioned concrete members,
  ACI Structural Journal 115(4), 1153-1164; it models Specimens 1 and 2 of Burns et al. (1991), beams A of Tao
  and Du (1985) and Slabs 4 and 5 of Cooke et al. (1981). What it does not print is named in the notes.
"""

import re
from itertools import product
from pathlib import Path
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from ptbatch.workbook.column import System
from ptbatch.workbook.columns import MEMBERS, NOTE
from ptbatch.workbook.template import write_template
from ptbatch.workbook.units import parse_header
from ptbatch.workbook.write import Sheet, write_workbook

Row = dict[str, Any]

ROOT = Path(__file__).parent.parent
EXAMPLE = "examples/beams.xlsx"
TEMPLATES: dict[System, str] = {"SI": "templates/members-SI.xlsx", "US": "templates/members-US.xlsx"}
US_UNITS = ("in]", "in2]", "ft]", "ksi]")
CREATED = b"2025-01-01T00:00:00Z"  # of every shipped file


def of_an_office() -> list[Row]:
    """A grouted floor beam and a strip of a flat plate, as they are typed on a working day."""
    beam = {
        "member": "B12, grouted beam",
        "span [mm]": 16000,
        "shape": "tee",
        **{"b [mm]": 1200, "h [mm]": 900, "bw [mm]": 400, "hf [mm]": 150},
        "fc [MPa]": 40,
        "Aps [mm2]": 1960,
        "dp [mm]": "330; 780; 330",
        "fpj [MPa]": 1395,
        "mu [1/rad]": 0.19,
        "k_ec2 [rad/m]": 0.01,
        "bond": "bonded",
        **{"As [mm2]": 1257, "ds [mm]": 840, "As_top [mm2]": 452, "ds_top [mm]": 50},
        "fy [MPa]": 500,
        "w_dead [kN/m]": 20,
        "w_live [kN/m]": 25,
        "note": "Made up. Two ducts of seven 15.7 mm strands, jacked to 0.75 fpu; four bars d20, four d12.",
    }
    strip = {
        "member": "S3, slab strip",
        "kind": "slab",
        "span [mm]": "8000; 9000; 8000",
        **{"b [mm]": 1000, "h [mm]": 200},
        "fc [MPa]": 32,
        "Aps [mm2]": 300,
        "dp [mm]": "100; 160; 40; 160; 40; 160; 100",
        "fpj [MPa]": 1395,
        "jack": "both",
        **{"As [mm2]": 393, "ds [mm]": 170, "As_top [mm2]": 393, "ds_top [mm]": 30},
        "fy [MPa]": 500,
        "w_dead [kN/m]": 1.5,
        "w_live [kN/m]": 3,
        "note": "Made up. A strip of 1 m: two 15.7 mm monostrands, bars d10 at 200 mm in both faces.",
    }
    return [beam, strip]


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
    """Two-span beams in US units, with both wedge sets (1.27 and 3.18 mm in the paper) and with none.

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
    as_waves = {"set [in]": 0.125, "wobble": "sine", "note": f"{source} Wobble as waves, as in the paper."}
    return [
        *(
            {"member": f"{name}, {told}", **beam, "set [in]": wedge_set, "note": source}
            for (name, beam), (told, wedge_set) in product(beams.items(), sets.items())
        ),
        *({"member": f"{name}, wobble as waves", **beam, **as_waves} for name, beam in beams.items()),
    ]


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
    return [
        {"member": f"{name}, mu {mu}", **beam, **dict(zip(headers, values, strict=True))}
        | {"mu [1/rad]": mu, "note": source}
        for (name, values), mu in product(tested.items(), (0.3, 0))
    ]


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


def members() -> Sheet:
    """The sheet of all examples: columns in the order of the template, US units beside those in SI."""
    rows = [*of_an_office(), *imaginary_beam(), *specimens(), *tao_and_du(), *cooke_slabs()]
    order = [column.name for column in (*MEMBERS, NOTE)]
    typed = {header for row in rows for header in row}
    headers = sorted(typed, key=lambda h: (order.index(parse_header(h).name), h.endswith(US_UNITS)))
    return Sheet("members", headers, [[row.get(header) for header in headers] for row in rows])


def build(root: Path = ROOT) -> list[Path]:
    """Write the workbooks below a folder, in place of those that are there, and return their paths."""
    example, *templates = paths = [root / name for name in (EXAMPLE, *TEMPLATES.values())]
    for path in paths:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
    write_workbook(example, [members()])
    for path, system in zip(templates, TEMPLATES, strict=True):
        write_template(path, system)
    for path in paths:
        _date(path)
    return paths


def _date(path: Path) -> None:
    """Give a workbook, and all that is packed in it, a fixed date."""
    with ZipFile(path) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    parts["docProps/core.xml"] = re.sub(rb"\d{4}-\d\d-\d\dT[\d:]+Z", CREATED, parts["docProps/core.xml"])
    with ZipFile(path, "w", ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(ZipInfo(name), content, ZIP_DEFLATED)


if __name__ == "__main__":
    for built in build():
        print(built.relative_to(ROOT))
