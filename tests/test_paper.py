"""The paper's members, run once: the published table is met, and its findings hold as statements."""

import os
import re

import pytest

from examples.build import PAPER, PUBLISHED, ROOT
from ptbatch.batch import run_workbook
from ptbatch.cli import exit_code
from ptbatch.compare.columns import COLUMNS
from ptbatch.compare.comparison import compare_workbooks
from ptbatch.compare.entry import Query
from ptbatch.compare.published import read_published
from ptbatch.compare.results import read_results

REPORT = "docs/verification.md"
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


# Just after cracking friction changes the load on Specimen 2 by more than the 2 % that the issue allows.
NOT_MET = [("Specimen 2, friction", "load, at 10 mm / that of Specimen 2, no friction")]


def test_what_fails_is_known(comparison):
    failed = [(line.member, line.what) for line in comparison.lines if line.verdict == "fail"]
    assert failed == NOT_MET


def test_exit_code(path, capsys):
    assert exit_code(["compare", str(path), str(ROOT / PUBLISHED)]) == 1  # 0 once NOT_MET is empty
    assert "not reproducible" in capsys.readouterr().err


def test_what_is_not_reproducible(comparison):
    """These and no others, and no mark that is no longer needed."""
    marked = [line for line in comparison.lines if line.verdict == "not reproducible"]
    numbers = {(line.member, line.what) for line in marked if line.theirs is not None}
    ends = ("loss_jacking_end", "loss_fixed_end")
    assert numbers == {
        *(("Imaginary beam, 20 el.", f"{end}_{way}") for end in ends for way in ("analytic", "fe")),
        ("Imaginary beam, 20 el.", "stress_fe, jacked, x = 0 mm less x = 15200 mm"),
        ("Specimen 2, set 0.05 in", "loss_jacking_end_fe"),
        ("Specimen 2, set 0.125 in", "loss_jacking_end_fe"),
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


PAIR = "Specimen 2, friction", "Specimen 2, no friction"


@pytest.mark.parametrize("deflection", [2.0, 5.0, 20.0, 30.0, 45.0, 60.0, 76.0])
def test_friction_hardly_changes_the_curve_of_specimen_2(value, deflection):
    """Published as a finding; 2 % is the issue's."""
    with_friction, without = (value(member, "load", deflection=deflection) for member in PAIR)
    assert with_friction == pytest.approx(without, rel=0.02)


def test_where_friction_changes_the_curve_of_specimen_2_most(value):
    """Just after cracking; 3 % is ours, the issue's 2 % is not met there."""
    ratios = [
        value(PAIR[0], "load", deflection=d) / value(PAIR[1], "load", deflection=d)
        for d in (6.0, 8.0, 10.0, 12.0, 15.0, 18.0)
    ]
    assert min(ratios) > 0.97 and max(ratios) < 1.02


def test_friction_clearly_changes_the_stress_along_specimen_2(value):
    """Published as a finding, tens of MPa; 20 MPa is ours. At 76 mm as largest less least stress; between the
    middle of the loaded span and the ends at peak, the last stage of which results hold the stress along x.
    """
    most, least = (value(PAIR[0], f"tendon_stress_{way}", deflection=76.0) for way in ("max", "min"))
    assert most - least > 20.0
    at = {x: value(PAIR[0], "stress_fe", "peak", float(x)) for x in (0, 11430, 15240)}
    assert at[11430] - at[0] > 20.0 and at[11430] - at[15240] > 20.0
    most, least = (value(PAIR[1], f"tendon_stress_{way}", deflection=76.0) for way in ("max", "min"))
    assert most - least < 0.1


@pytest.mark.parametrize("beam", ["A-1", "A-2", "A-3", "A-6", "A-9"])
@pytest.mark.parametrize("deflection", [5.0, 10.0, 30.0, 60.0])
def test_friction_hardly_changes_the_curve_of_a_single_span(value, beam, deflection):
    """Published as a finding; 2 % is the issue's. Unverified input."""
    with_friction, without = (value(f"{beam}, mu {mu}", "load", deflection=deflection) for mu in ("0.3", "0"))
    assert with_friction == pytest.approx(without, rel=0.02)


def test_shipped_report_is_current(path, comparison):
    """But for our own numbers, of which the last digits may differ between machines."""
    reports = (ROOT / REPORT).read_text("utf-8"), path.with_name("verification.md").read_text("utf-8")
    shipped, written = (
        [OURS.sub(r" \1 |", line) for line in text.splitlines() if line and not line.startswith("![")]
        for text in reports
    )
    assert shipped == written


def test_readme_explains_every_column():
    readme = (ROOT / "README.md").read_text("utf-8")
    section = readme.partition("## Compare with what is known")[2].partition("\n## ")[0]
    told = {
        name.partition(" ")[0]
        for row in re.findall(r"^\| (.*?) \|", section, re.M)
        for name in row.split(", ")
    }
    assert told - {"column", "---"} == {column.name for column in COLUMNS}
