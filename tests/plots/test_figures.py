"""What the figures show, number by number; of their look only that they can be drawn."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from numpy.testing import assert_array_equal
from openpyxl import load_workbook

from ptbatch.plots.curve import marks
from ptbatch.plots.pages import HEIGHTS, figure_of, geometry_of, page_of
from ptbatch.plots.stress import ANALYTIC, FE
from ptbatch.workbook.stored import Table


def drawn(figure: Figure, gid: str) -> list:
    """All lines and line collections of that name."""
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def column(results, sheet, member, stage, header) -> np.ndarray:
    """Numbers of a sheet, read without the program."""
    headers, *rows = load_workbook(results)[sheet].values
    at = [headers.index(name) for name in ("member", "stage", header)]
    return np.array([row[at[2]] for row in rows if (row[at[0]], row[at[1]]) == (member, stage)])


@pytest.mark.parametrize("member", ["simple", "US tee", "two spans", "stuck"])
@pytest.mark.parametrize("stage", ["jacked", "anchored"])
def test_stress_is_that_of_the_sheet(results, stored, member, stage):
    figure = figure_of([stored[member]], "stress")
    for gid, header in ((stage, "stress_fe [MPa]"), (f"{stage} analytic", "stress_analytic [MPa]")):
        (line,) = drawn(figure, gid)
        assert_array_equal(line.get_xdata(), column(results, "tendon", member, stage, "x [mm]") / 1e3)
        assert_array_equal(line.get_ydata(), column(results, "tendon", member, stage, header))


def test_round_off_does_not_fill_the_axis(stored):
    """A frictionless tendon is drawn as what it is, a level line."""
    simple = stored["simple"]
    rows = [row | {FE: 1100.0 + 1e-9 * i, ANALYTIC: 1100.0} for i, row in enumerate(simple.tendon.rows)]
    level = replace(simple, tendon=Table(rows))
    low, high = figure_of([level], "stress").axes[0].get_ylim()
    assert low < 1080.0 < 1120.0 < high


def test_redistribution_lays_members_over_each_other(results, stored):
    figure = figure_of([stored["simple"], stored["two spans"]], "redistribution")
    for member in ("simple", "two spans"):
        (line,) = drawn(figure, f"{member} peak")
        assert_array_equal(line.get_ydata(), column(results, "tendon", member, "peak", "stress_fe [MPa]"))
    assert len(figure.axes) == 1


def test_load_deflection_curve_and_its_events(stored):
    simple = stored["simple"]
    figure = figure_of([simple], "load-deflection")
    (line,) = drawn(figure, "simple")
    load, deflection = (simple.curves.numbers(name) for name in ("load [kN]", "deflection [mm]"))
    assert set(line.get_ydata()[:-1]) <= set(load)
    assert line.get_ydata()[-1] == simple.value("failure_load [kN]")
    by_name = {mark.name: mark for mark in marks(simple)}
    assert list(by_name) == ["cracking", "yield", "peak", "concrete crushing"]
    assert by_name["peak"].load == simple.value("load_peak [kN]")
    for name in ("cracking", "yield"):
        assert by_name[name].load == simple.value(f"load_{name} [kN]")
        assert np.interp(by_name[name].deflection, deflection, load) == pytest.approx(by_name[name].load)


def test_a_curve_on_another_one_is_dashed(stored):
    """So that both can be seen; the axis begins where the curves do."""
    figure = figure_of([stored["simple"], stored["two spans"]], "load-deflection")
    below, above = (drawn(figure, name)[0] for name in ("simple", "two spans"))
    assert (below.get_linestyle(), above.get_linestyle()) == ("-", "--")
    assert figure.axes[0].get_xlim()[0] == pytest.approx(0.0, abs=1e-9)


def test_failure_has_a_place_and_a_load(stored):
    summary = stored["simple"].summary
    assert 2000.0 < summary["failure_x [mm]"] < 4000.0
    assert 0.0 < summary["failure_load [kN]"] <= summary["load_peak [kN]"]
    assert stored["US tee"].summary["failure_x [mm]"] == "no material reached its limit"
    assert stored["stuck"].summary["failure_x [mm]"] == "not converged: see message"


def test_cracks_are_those_of_the_sheet(results, stored):
    figure = figure_of([stored["simple"]], "cracks")
    (lines,) = drawn(figure, "peak")
    x, top, bottom = np.array([[*a, b[1]] for a, b in lines.get_segments()]).T
    for values, header in ((1e3 * x, "x [mm]"), (top, "crack_from [mm]"), (bottom, "crack_to [mm]")):
        assert values == pytest.approx(column(results, "cracks", "simple", "peak", header))
    assert bottom == pytest.approx(500.0)


def test_end_is_told_only_where_it_is_not_the_peak(stored):
    for name in ("simple", "US tee", "two spans"):
        result = stored[name]
        last = result.curves.rows[-1]["step"]
        peak = next(row["step"] for row in result.cracks.rows if row["stage"] == "peak")
        assert bool(len(result.tendon.stage("end"))) == (peak != last)


@pytest.mark.parametrize("kind", HEIGHTS)
def test_every_figure_of_every_member(stored, kind):
    figure_of(list(stored.values()), kind).draw_without_rendering()
    for result in stored.values():
        figure_of([result], kind).draw_without_rendering()


@pytest.mark.filterwarnings("error")
def test_every_page(stored):
    for result in stored.values():
        page_of(result).draw_without_rendering()


def test_page_says_what_is_missing(stored):
    texts = [
        text.get_text().replace("\n", " ")
        for text in page_of(stored["stuck"]).findobj()
        if hasattr(text, "get_text")
    ]
    assert any("stuck lacks the live load; not converged: live load" in text for text in texts)


@pytest.mark.parametrize("member", ["simple", "US tee", "two spans"])
def test_geometry_has_the_tendon_at_its_depths(stored, member):
    result = stored[member].member
    figure = geometry_of(result)
    line, *dots = drawn(figure, "tendon")
    assert (line.get_ydata().min(), line.get_ydata().max()) == pytest.approx((min(result.dp), max(result.dp)))
    assert [dot.get_ydata()[0] for dot in dots] == pytest.approx([min(result.dp), max(result.dp)])
