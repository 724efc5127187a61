"""Build the workbooks that are shipped, and the page of all columns in the documentation: `python -m
examples.build` after any change of a row or a column.

`examples/beams.xlsx` holds two members of an office and published ones; its notes tell the sources.
`examples/paper.xlsx` holds the members of the paper's studies and those with closed forms,
`examples/paper-published.xlsx` what is known of them. `examples/office-SI.xlsx` and `office-US.xlsx` are
worked out in `docs/office-example.md`. `templates/` holds the templates in SI and in US units.
The same rows make the same files, byte by byte.
"""

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from examples import office
from examples.columns_page import PAGE, columns_page
from examples.paper import (
    FIGURE_HEADERS,
    PUBLISHED_HEADERS,
    figure_rows,
    paper_members,
    profile_rows,
    published_rows,
)
from examples.paper.members import Row, cooke_slabs, imaginary_beam, specimens, tao_and_du
from ptbatch.workbook.column import System
from ptbatch.workbook.columns import MEMBERS, NOTE
from ptbatch.workbook.template import write_template
from ptbatch.workbook.units import parse_header
from ptbatch.workbook.write import Sheet, write_workbook

ROOT = Path(__file__).parent.parent
EXAMPLE = "examples/beams.xlsx"
OFFICE = {"SI": "examples/office-SI.xlsx", "US": "examples/office-US.xlsx"}
PAPER, PUBLISHED = "examples/paper.xlsx", "examples/paper-published.xlsx"
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


def beams() -> list[Row]:
    """Rows of the main example."""
    return [*of_an_office(), *imaginary_beam(), *specimens(), *tao_and_du(), *cooke_slabs()]


def members(rows: list[Row]) -> Sheet:
    """The sheet of members: columns in the order of the template, US units beside those in SI."""
    order = [column.name for column in (*MEMBERS, NOTE)]
    typed = {header for row in rows for header in row}
    headers = sorted(typed, key=lambda h: (order.index(parse_header(h).name), h.endswith(US_UNITS)))
    return sheet("members", headers, rows)


def sheet(name: str, headers: Sequence[str], rows: Iterable[Row]) -> Sheet:
    """A sheet from rows by header."""
    return Sheet(name, headers, [[row.get(header) for header in headers] for row in rows])


def build(root: Path = ROOT) -> list[Path]:
    """Write workbooks and page below a folder, in place of those that are there, and return their paths."""
    names = (EXAMPLE, PAPER, PUBLISHED, *OFFICE.values(), *TEMPLATES.values())
    example, paper, published, in_si, in_us, *templates = paths = [root / name for name in names]
    for path in paths:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
    write_workbook(example, [members(beams())])
    write_workbook(in_si, [members(office.si())])
    write_workbook(in_us, [members(office.us())])
    points = list(profile_rows())
    headers = list(dict.fromkeys(header for row in points for header in row))
    write_workbook(paper, [members(paper_members()), sheet("profile", headers, points)])
    known = sheet("published", PUBLISHED_HEADERS, published_rows())
    write_workbook(published, [known, sheet("figures", FIGURE_HEADERS, figure_rows())])
    for path, system in zip(templates, TEMPLATES, strict=True):
        write_template(path, system)
    for path in paths:
        _date(path)
    page = root / PAGE
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(columns_page(), "utf-8")
    return [*paths, page]


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
