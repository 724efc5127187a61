"""A report and figures on results in US units speak of no other."""

import re

import pytest
from openpyxl import Workbook

from ptbatch.batch import run_workbook
from ptbatch.plots.pages import geometry_of, page_of
from ptbatch.report import write_report
from ptbatch.workbook.stored import read_all
from tests.plots.conftest import SMALL
from tests.report.conftest import LONG, SHEETS, sheet

SI = re.compile(r"(?<![\w.])(MPa|mm²?|m|kN|kN/m³?|1/m)(?![\w/])")


@pytest.fixture(scope="module")
def us(tmp_path_factory):
    """Results of a member with everything on it."""
    path = tmp_path_factory.mktemp("us") / "beams.xlsx"
    book = Workbook()
    book.remove(book.active)
    row = SMALL | {"member": LONG, "live": "loads", "dp [mm]": None, "standard": "ACI 318-19"}
    for name, rows in {"members": [row], **SHEETS}.items():
        sheet(book, name, rows)
    book.save(path)
    return run_workbook(path, units="US").path


def test_the_report_is_in_us_units(us, tmp_path):
    page = write_report(us, (), tmp_path / "us.html").path.read_text("utf-8")
    body = re.sub(r"<style.*?</style>|<[^>]*>", " ", page, flags=re.S)
    assert SI.findall(body) == []
    for unit in ("ksi", "in²", "kip", "kip ft", "ksi ft", "kip/ft", "pcf", "1/ft"):
        assert f" {unit}" in body or f"[{unit}]" in body


def test_the_checks_have_a_section(us, tmp_path):
    (stored,) = read_all(us)
    page = write_report(us, (), tmp_path / "us.html").path.read_text("utf-8")
    assert "Checks by the standard" in page
    assert len(stored.checks) > page.count("ACI 318-19 ") > 3  # and some for information
    assert "Mu &lt;= phi Mn" in page and "give RH, or long_term_loss" in page


def test_figures_are_in_us_units(us):
    (stored,) = read_all(us)
    texts = []
    for figure in (page_of(stored), geometry_of(stored.member, "US")):
        figure.draw_without_rendering()
        texts += [item.get_text() for item in figure.findobj(lambda artist: hasattr(artist, "get_text"))]
    assert [text for text in texts if SI.search(text)] == []
    assert {"x [ft]", "depth [in]", "Section [in]", "tendon stress [ksi]", "live load [kip]"} <= set(texts)


def test_ticks_are_round_and_true(us):
    """Closed form: the axis is drawn in mm and told in inches."""
    (stored,) = read_all(us)
    elevation = geometry_of(stored.member, "US").axes[0]
    places = elevation.get_yticks()
    told = [float(tick.get_text()) for tick in elevation.get_yticklabels()]
    assert len(told) >= 4
    assert places == pytest.approx([25.4 * tick for tick in told], abs=1e-9)
    assert max(told) * 25.4 <= stored.member.h * (1.0 + 1e-9)
