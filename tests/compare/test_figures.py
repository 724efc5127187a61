"""The sheet `figures` of a published table: what is wrong with its rows, and figures that cannot be drawn."""

import pytest

from ptbatch.compare.comparison import compare_workbooks
from ptbatch.compare.figures import Figure
from ptbatch.compare.published import read_published
from ptbatch.errors import ReadError

FIGURE = {"figure": "fig-1", "kind": "stress", "members": "B1; B2", "caption": "All *of* it."}


@pytest.fixture
def failing(results, published):
    """(member, figure, because) of the failures that rows of figures make."""

    def compare(*rows, **options):
        table = published({}, figures=[FIGURE | row for row in rows])
        lines = compare_workbooks(results(), table, **options).lines
        return [(line.member, line.what, line.because) for line in lines if line.verdict == "fail"]

    return compare


def test_a_sound_row(published):
    known = read_published(published({}, figures=[FIGURE, FIGURE | {"figure": "b", "case": "One"}]))
    assert known.figures == [
        Figure("fig-1", "stress", ("B1", "B2"), "All *of* it.", "B1"),
        Figure("b", "stress", ("B1", "B2"), "All *of* it.", "One"),
    ]


@pytest.mark.parametrize(
    ("row", "because"),
    [  # figure, kind, members, caption are A to D
        ({"figure": None}, "figures!A2  figure: missing; give figure: name of its file"),
        ({"figure": "../fig"}, "figures!A2  figure = ../fig: is no name for a file"),
        ({"kind": "curve"}, "figures!B2  kind = curve: is not one of the choices"),
        ({"kind": "all"}, "figures!B2  kind = all: is not one of the choices"),
        ({"members": None}, "figures!C2  members: missing"),
        ({"members": "B1;"}, "figures!C2  members = B1;: a name is missing; give a name on either side of"),
        ({"caption": None}, "figures!D2  caption: missing; give caption: what it shows"),
    ],
)
def test_a_faulty_row_fails_with_its_cell(failing, row, because):
    ((_, what, told),) = failing(row)
    assert what.startswith("figure") and because in told


def test_a_name_given_twice(failing):
    ((_, what, told),) = failing({}, {"figure": "FIG-1"})
    assert what == "figure FIG-1" and "figures!A3  figure = FIG-1: this name is given twice" in told


def test_faulty_headers_are_refused(published):
    with pytest.raises(ReadError) as error:
        read_published(published({}, figures=[{"figure": "fig-1", "kinds": "stress"}]))
    assert all(name in str(error.value) for name in ("kind: there is no such column", "members", "caption"))


def test_a_sheet_without_its_key_is_refused(published):
    with pytest.raises(ReadError, match="sheet figures has no column figure"):
        read_published(published({}, figures=[{"kind": "stress"}]))


def test_a_stranger_in_a_figure(failing, tmp_path):
    told = failing({"members": "B3"}, markdown=tmp_path / "report.md")
    assert told == [("B3", "figure fig-1", "the results have no member B3; choose one of B1, B2")]


def test_nothing_to_draw(failing, tmp_path):
    """The made-up results lack the members themselves."""
    ((member, _, told),) = failing({}, markdown=tmp_path / "report.md")
    assert member == "B1, B2" and told.startswith("nothing to draw: B1 lacks the member itself; ok")
    assert "![" not in (tmp_path / "report.md").read_text("utf-8")


def test_figures_are_drawn_for_a_report_alone(failing, tmp_path):
    assert failing({}) == []
    assert not (tmp_path / "figures").exists()
