"""What the page says, and that it says it of the right things."""

import re
from xml.etree import ElementTree

from ptbatch.report import write_report
from ptbatch.report.document import Reported
from tests.report.conftest import HOSTILE, LONG, SCRIPT


def chapter(page, name) -> str:
    """The chapter of a member, by its name as it stands in the page."""
    return next(part for part in page.split('<section class="member"')[1:] if f">\n<h2>{name} <span" in part)


def test_what_users_type_is_text(page):
    assert SCRIPT not in page and HOSTILE not in page and "<b>12,5" not in page
    assert "<script" not in page and "<img" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page
    assert "<h2>=1+1 <span" in page


def test_it_needs_nothing_else(page):
    assert re.findall(r'(?:src|href)="(?!#)[^"]*"', page) == []
    assert re.findall(r"url\((?!#)", page) == []
    assert "@import" not in page


def test_ids_are_its_own(page):
    ids = re.findall(r'\sid="([^"]*)"', page)
    assert len(ids) == len(set(ids)) > 100
    assert all(re.fullmatch(r"m\d+(-[a-z-]+-\d+)?", one) for one in ids)


def test_every_row_is_there(page, stored):
    assert page.count('<section class="member"') == len(stored)
    overview = page.split("<tbody>")[1].split("</tbody>")[0]
    assert overview.count("<tr>") == len(stored)
    assert all(f'href="#m{i}"' in overview for i in range(1, len(stored) + 1))


def test_a_member_without_peak_has_what_exists(page):
    stuck = chapter(page, "stuck")
    assert "Missing: the tendon under live load, the live load." in stuck
    assert stuck.count("<svg") == 2  # drawing and stress
    assert "Losses: formula" in stuck and "Capacity" not in stuck


def test_an_invalid_row_has_its_faults(page):
    wrong = chapter(page, "wrong")
    assert "Faults in the input" in wrong and "<svg" not in wrong
    assert "&lt;b&gt;12,5&lt;/b&gt;" in wrong and ">Aps [mm2]<" in wrong
    assert wrong.count("<tr>") == 3 and "Not analysed" in wrong


def test_a_member_that_cannot_bear_its_load_says_so(page):
    heavy = chapter(page, "too heavy")
    assert "no live load can be carried" in heavy
    assert "none: see message" in heavy


def test_free_profile_bars_and_loads(page):
    part = re.sub(r"\s+", " ", chapter(page, LONG))
    assert "<dd>2500; 400.0 mm</dd>" in part or "<dd>2500; 400 mm</dd>" in part
    assert "60 kN at x = 2000 mm" in part and "4 kN/m, x = 1000 to 5000 mm" in part
    assert "200 mm² at 450 mm, x = 1000 to 5000 mm" in part


def test_figures_are_xml(page):
    figures = re.findall(r"<svg.*?</svg>", page, re.DOTALL)
    assert len(figures) > 30
    assert all(ElementTree.fromstring(figure).findall(".//text") for figure in figures)


def test_the_same_results_make_the_same_report(results, page, tmp_path):
    first, second = (write_report(results, ["simple"], tmp_path / name) for name in ("a.html", "b.html"))
    assert first.path.read_bytes() == second.path.read_bytes()
    assert first == Reported(tmp_path / "a.html", [])
    every = page.count('<section class="member"')
    assert f"1 of {every}:" in first.path.read_text("utf-8")
