"""Figures that a published table names, drawn beside the report."""

from ptbatch.compare.comparison import compare_workbooks
from tests.compare.made_up import ROW, write

NUMBER = ROW | {"member": "simple", "quantity": "status", "value": "ok"}
FIGURES = [
    {"figure": "curves", "kind": "load-deflection", "members": "simple; two spans", "caption": "*Two*."},
    {"figure": "cracks", "kind": "cracks", "members": "simple", "caption": "Cracks.", "case": "By itself"},
]


def compare(results, folder, *figures):
    folder.mkdir()
    known = write(folder / "published.xlsx", published=[NUMBER], figures=figures)
    return compare_workbooks(results, known, folder / "a.comparison.xlsx", markdown=folder / "report.md")


def test_a_report_shows_its_figures(results, tmp_path):
    assert not compare(results, tmp_path / "a", *FIGURES).failed
    report = (tmp_path / "a" / "report.md").read_text("utf-8")
    assert "\n\n![curves](figures/curves.png)\n\n*\\*Two\\*.*\n\n## By itself\n\n![cracks]" in report
    names = sorted(path.name for path in (tmp_path / "a" / "figures").iterdir())
    assert names == ["cracks.png", "curves.png"]


def test_the_same_results_make_the_same_figures(results, tmp_path):
    for name in "ab":
        compare(results, tmp_path / name, *FIGURES)
    first, second = (
        [(tmp_path / name / "figures" / f"{row['figure']}.png").read_bytes() for row in FIGURES]
        for name in "ab"
    )
    assert first == second


def test_what_a_figure_lacks_is_a_failure(results, tmp_path):
    row = FIGURES[0] | {"members": "simple; stuck; outside"}
    comparison = compare(results, tmp_path / "a", row)
    lacking = [line.because for line in comparison.lines if line.verdict == "fail"]
    assert [text.partition(";")[0] for text in lacking] == [
        "stuck lacks the live load",
        "outside lacks the member itself",
    ]
    assert (tmp_path / "a" / "figures" / "curves.png").is_file()
