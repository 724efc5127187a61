"""The paper's members, run once: the published table is met, and its findings hold as statements."""

import os
import re
from itertools import product
from math import pi
from types import SimpleNamespace

import numpy as np
import pytest

from examples.build import PAPER, PUBLISHED, ROOT
from examples.paper.table_1 import EXACT, SPREAD
from examples.paper.waves import amplitude, ideal_specimens, points
from ptbatch.analysis import analyse
from ptbatch.batch import run_workbook
from ptbatch.cli import exit_code
from ptbatch.compare.columns import COLUMNS, FIGURES
from ptbatch.compare.comparison import compare_workbooks
from ptbatch.compare.entry import Query
from ptbatch.compare.published import read_published
from ptbatch.compare.results import read_results
from ptbatch.geometry.profile import ideal_profile
from ptbatch.losses import analytic_losses
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.stored import read_stored

REPORT = "docs/verification.md"
CURVE = ("deflection [mm]", "load [kN]")
CRACKS = ("x [mm]", "crack_from [mm]", "crack_to [mm]")
OURS = re.compile(r" \S+ (\| \S+) \| \S+ \|(?= [^|]*\| (?:pass|not reproducible|FAIL) )")


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """The results of `examples/paper.xlsx`."""
    path = tmp_path_factory.mktemp("paper") / "paper.results.xlsx"
    batch = run_workbook(ROOT / PAPER, path, jobs=os.cpu_count() or 1)
    assert batch.counts["ok"] == len(batch.lines)
    return path


@pytest.fixture(scope="module")
def comparison(path):
    """What is known of them against the results; writes the report beside."""
    return compare_workbooks(path, ROOT / PUBLISHED, markdown=path.with_name("verification.md"))


@pytest.fixture(scope="module")
def value(path):
    """value(member, quantity, ...) looks a number up."""
    results = read_results(path)
    return lambda *query, **options: results.look_up(Query(*query, **options)).value


def test_nothing_fails(comparison):
    assert [(line.member, line.what) for line in comparison.lines if line.verdict == "fail"] == []


def test_exit_code(path, capsys):
    assert exit_code(["compare", str(path), str(ROOT / PUBLISHED)]) == 0
    assert "not reproducible" in capsys.readouterr().err


def test_what_is_not_reproducible(comparison):
    """These and no others, and no mark that is no longer needed."""
    marked = [line for line in comparison.lines if line.verdict == "not reproducible"]
    numbers = {(line.member, line.what) for line in marked if line.theirs is not None}
    ends = ("loss_jacking_end", "loss_fixed_end")
    assert numbers == {
        *(("Imaginary beam, 20 el.", f"{end}_{way}") for end in ends for way in ("analytic", "fe")),
        ("Imaginary beam, 20 el.", "stress_fe, jacked, x = 0 mm less x = 15200 mm"),
        *(
            (f"Specimen 2, set {wedge_set} in{way}", "loss_jacking_end_fe")
            for wedge_set in (0.05, 0.125)
            for way in ("", ", waves")
        ),
    }
    figures = {line.member for line in marked if line.theirs is None}
    assert figures == {
        "Specimen 2, friction",
        *(f"{beam}, mu 0.3" for beam in ("A-1", "A-2", "A-3", "A-6", "A-9")),
        *("Slab 4", "Slab 5"),
    }
    assert [line.what for line in comparison.lines if line.verdict == "pass" and line.because] == []


def test_every_number_says_where_it_is_from_and_has_a_tolerance():
    rows = read_published(ROOT / PUBLISHED).rows
    assert {row.kind for row in rows} == {"published", "closed form"}
    for row in rows:
        assert row.source
        assert row.value is None or row.bound != "equal" or row.atol is not None or row.rtol is not None


@pytest.mark.parametrize("case", ["Imaginary beam", "Specimen 1", "Specimen 2"])
def test_rigid_beams_lie_near_the_closed_form(comparison, case):
    """Finite elements / closed form: friction 0.99 to 1.01, set 0.97 to 1.03; the issue's."""
    lines = [line for line in comparison.lines if line.member.startswith(case) and "rigid" in line.member]
    friction = [line.ratio for line in lines if line.what.startswith("stress_fe, jacked")]
    wedge_set = [line.ours for line in lines if line.what.endswith("/ loss_jacking_end_analytic")]
    assert friction and all(0.99 <= ratio <= 1.01 for ratio in friction)
    assert wedge_set and all(0.97 <= ratio <= 1.03 for ratio in wedge_set)


@pytest.mark.parametrize("specimen", ideal_specimens(), ids=lambda row: row["member"])
def test_one_sine_puts_friction_near_the_jack(specimen):
    """Closed form: set losses at the jack of sines of other lengths and phases lie where the notes say, above
    that of even wobble."""
    name, wedge_set = specimen["member"][:10], specimen["set [in]"]
    stress, Ep, mu = 202.0, specimen["Ep [ksi]"], specimen["mu [1/rad]"]
    found = []
    for wave in product((4, 5, 6, 7, 8), (0.0, 0.5 * pi, pi, 1.5 * pi)):
        shape = points(specimen, amplitude(specimen, *wave), *wave)
        profile = ideal_profile(SimpleNamespace(span=(7620.0, 7620.0), profile_points=shape))
        loss = analytic_losses(profile, stress, mu, 0.0, Ep, wedge_set * 25.4, "left", reversal="mirror")
        found.append(100.0 * loss.loss_jacking_end)
    assert (min(found), max(found)) == pytest.approx(SPREAD[name, wedge_set], abs=0.06)
    assert min(found) > EXACT[name, wedge_set][0]


PAIR = "Specimen 2, friction", "Specimen 2, no friction"
NEAR = "Specimen 2, friction, to 1 in", "Specimen 2, no friction, to 1 in"
A1, *BEAMS = [(f"{beam}, mu 0.3", f"{beam}, mu 0") for beam in ("A-1", "A-2", "A-3", "A-6", "A-9")]


@pytest.mark.parametrize(
    ("members", "limit", "beyond"),
    [(NEAR, 2.5, 0.0), (PAIR, 2.0, 25.0), (A1, 4.0, 0.0), *((pair, 2.0, 0.0) for pair in BEAMS)],
)
def test_friction_hardly_changes_a_curve(path, members, limit, beyond):
    """Published as a finding; 2 % of the peak load anywhere is the issue's. Specimen 2 passes by it at yield,
    where fine steps find 2.1 %: between steps of 0.6 mm half a step of either curve's bend comes on top. Tao
    and Du's beams: unverified input. Steps eight times as fine find 3.9 % for A-1, where a section cracks
    through at another deflection."""
    with_friction, without = read_stored(path, members)
    deflection, load = (without.curves.numbers(header) for header in CURVE)
    other = np.interp(deflection, *(with_friction.curves.numbers(header) for header in CURVE))
    less = np.abs(other - load)[deflection > beyond]
    peak = read_stored(path, PAIR)[1] if members == NEAR else without
    assert less.max() < limit / 100.0 * peak.value("load_peak [kN]")


def test_fine_steps_find_where_friction_matters_most():
    """Frozen: what the note in the published table says of Specimen 2."""
    rows = {row.name: row.member for row in read_inputs(ROOT / PAPER).only(PAIR).rows}
    deflection = np.linspace(1.0, 76.0, 751)
    with_friction, without = (
        np.interp(deflection, curve.deflection, curve.load)
        for curve in (analyse(rows[name], refine=8).curve for name in PAIR)
    )
    less = without - with_friction
    peak = 196.5e3
    assert 100.0 * np.max(less / without) == pytest.approx(2.7, abs=0.05)
    assert deflection[np.argmax(less / without)] == pytest.approx(10.5, abs=0.3)
    assert 100.0 * less.max() / peak == pytest.approx(2.1, abs=0.05)
    assert deflection[np.argmax(less)] == pytest.approx(15.9, abs=0.2)


def test_friction_clearly_changes_the_stress_along_specimen_2(value):
    """Published as a finding, tens of MPa; 20 MPa is ours. At 76 mm, between the middle of the loaded span
    and the ends."""
    for member, least, most in ((PAIR[0], 20.0, np.inf), (PAIR[1], 0.0, 1e-3)):
        middle, *ends = (value(member, "stress_fe", "end", x) for x in (11430.0, 0.0, 15240.0))
        assert all(least <= abs(middle - end) <= most for end in ends)


def test_crack_patterns_are_alike(path):
    """Published as a finding. Of the cracked area of either member 95 % is cracked in the other one: ours."""
    several = [stored.cracks.stage("end") for stored in read_stored(path, PAIR)]
    first, second = (
        {x: (top, bottom) for x, top, bottom in zip(*map(cracks.numbers, CRACKS), strict=True)}
        for cracks in several
    )
    assert first.keys() == second.keys()
    shared = sum(min(first[x][1], second[x][1]) - max(first[x][0], second[x][0]) for x in first)
    for cracks in (first, second):
        assert shared > 0.95 * sum(bottom - top for top, bottom in cracks.values())


def test_shipped_report_is_current(path, comparison):
    """But for our own numbers, of which the last digits may differ between machines."""
    reports = (ROOT / REPORT).read_text("utf-8"), path.with_name("verification.md").read_text("utf-8")
    shipped, written = ([OURS.sub(r" \1 |", line) for line in text.splitlines() if line] for text in reports)
    assert shipped == written


def test_every_figure_of_the_paper_is_drawn(path, comparison):
    """Those that show results: 7 to 15."""
    names = sorted(f"fig-{number}.png" for number in range(7, 16))
    for folder in (path.parent / "figures", ROOT / "docs/figures"):
        assert sorted(file.name for file in folder.iterdir()) == names
        assert sum(file.stat().st_size for file in folder.iterdir()) < 3e6


def test_readme_explains_every_column():
    readme = (ROOT / "README.md").read_text("utf-8")
    section = readme.partition("## Compare with what is known")[2].partition("\n## ")[0]
    told = {
        name.partition(" ")[0]
        for row in re.findall(r"^\| (.*?) \|", section, re.M)
        for name in row.split(", ")
    }
    assert told - {"column", "---"} == {column.name for column in (*COLUMNS, *FIGURES)}
