"""The paper's figures, as rows by header: kind, members and the heading that each stands under."""

from examples.paper.findings import BEAMS, COOKE, FRICTION, LOADED, NONE, TAO_AND_DU
from examples.paper.members import Row

HEADERS = ("figure", "kind", "members", "caption", "case")
SETS = ("set 0.05 in", "set 0.125 in")
ALONG = "prestress along {} before and after wedge set, by finite elements and analytic."


def figure_rows() -> list[Row]:
    """Rows of the sheet `figures` of `paper-published.xlsx`."""
    return [*losses(), *specimen_2(), *tested()]


def losses() -> list[Row]:
    """Prestress along the member."""
    one, two = ([f"{name}, {wedge_set}" for wedge_set in SETS] for name in ("Specimen 1", "Specimen 2"))
    waves = [f"Specimen 2, set 0.05 in, {way}" for way in ("waves", "one sine")]
    return [
        _figure(7, "stress", ["Imaginary beam, 20 el."], "Imaginary beam", ALONG.format("the beam")),
        _figure(9, "stress", one, "Specimen 1", ALONG.format("Specimen 1")),
        _figure(10, "stress", two, "Specimen 2", ALONG.format("Specimen 2")),
        _figure(8, "profile", waves, "Specimen 2, wobble as waves", "the ideal profile and that adjusted for "
                "wobble. The one sine is typed in as points, and drawn without the ideal one."),
    ]  # fmt: skip


def specimen_2() -> list[Row]:
    """Specimen 2 with and without friction."""
    what = {
        (11, "redistribution"): "tendon stress along Specimen 2 at the peak and at 76 mm",
        (12, "load-deflection"): "load and deflection of Specimen 2",
        (13, "cracks"): "crack patterns of Specimen 2",
    }
    return [
        _figure(number, kind, [FRICTION, NONE], LOADED, f"{shown}, with and without friction.")
        for (number, kind), shown in what.items()
    ]


def tested() -> list[Row]:
    """Beams and slabs that were tested; the tests are not published as numbers."""
    kind, beams = "load-deflection", [f"{beam}, mu {mu}" for beam in BEAMS for mu in ("0.3", "0")]
    return [
        _figure(14, kind, beams, TAO_AND_DU, "load and deflection of Tao and Du's beams with and without "
                "friction. UNVERIFIED INPUT."),
        _figure(15, kind, ["Slab 4", "Slab 5"], COOKE, "load and deflection of Cooke's slabs. ASSUMED "
                "fc and fpe."),
    ]  # fmt: skip


def _figure(number: int, kind: str, members: list[str], case: str, caption: str) -> Row:
    """A figure of the paper by its number."""
    return {
        "figure": f"fig-{number}",
        "kind": kind,
        "members": "; ".join(members),
        "case": case,
        "caption": f"Fig. {number} of the paper: {caption}",
    }
