"""The report as a browser shows and prints it."""

import json
import re
from html import unescape
from pathlib import Path

import pytest

from tests.report.browser import browse, needed

SCRIPT = (Path(__file__).parent / "measure.js").read_text("utf-8")
POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy"[^>]*>')

pytestmark = needed


@pytest.fixture(scope="module")
def measured(page, tmp_path_factory):
    """What the script finds on a copy of the page that lets it run."""
    folder = tmp_path_factory.mktemp("measured")
    copy = folder / "report.html"
    text, count = POLICY.subn(lambda _: f'<script id="measure">{SCRIPT}</script>', page)
    assert count == 1
    copy.write_text(text, "utf-8")
    found = re.search('<pre id="measured">(.*?)</pre>', browse(copy, folder / "profile", "--dump-dom").stdout)
    assert found, "the script did not run to its end"
    return json.loads(unescape(found[1]))


def test_every_figure_is_drawn(measured, page):
    assert measured["figures"] == page.count("<figure>") > 30
    assert measured["undrawn"] == []
    assert measured["cut"] == []


@pytest.mark.parametrize("what", ["errors", "overflowing", "spilling", "dangling", "repeated", "foreign"])
def test_nothing_goes_wrong(measured, what):
    assert measured[what] == []


def test_the_page_itself_says_nothing(reported, tmp_path):
    """No error on the console, of a script or of something that was to be fetched."""
    assert "CONSOLE" not in browse(reported.path, tmp_path / "profile", "--dump-dom").stderr


def test_it_prints(reported, stored, tmp_path):
    """One page for the overview, three at most for a member."""
    paper = tmp_path / "report.pdf"
    browse(reported.path, tmp_path / "profile", f"--print-to-pdf={paper}")
    pages = len(re.findall(rb"/Type /Page\b(?!s)", paper.read_bytes()))
    assert len(stored) < pages <= 1 + 3 * len(stored)
