"""The documentation does what it says: its commands and programs run, its numbers are those of a run, its
links lead somewhere."""

import csv
import re
import shlex
import shutil
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook

from examples.build import OFFICE
from ptbatch.cli import exit_code

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
NUMBERED = ROOT / "docs" / "worked-example.md"


def blocks(page: Path, language: str) -> list[str]:
    """Fenced blocks of a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", page.read_text("utf-8"), re.M | re.S)


def having(language: str) -> list[Path]:
    return [page for page in PAGES if blocks(page, language)]


def name(page: Path) -> str:
    return page.name


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder to work in that is empty but for the README's table of members and the office example."""
    lines = re.findall(r"^\| (.+) \|$", (ROOT / "README.md").read_text("utf-8"), re.M)
    rows = [line.split(" | ") for line in lines if line.count("|") == 11]
    assert [row[0] for row in rows] == ["member", "B1", "B2"]
    book = Workbook()
    book.active.title = "members"
    for row in rows:
        book.active.append([float(cell) if re.fullmatch(r"[\d.]+", cell) else cell for cell in row])
    book.save(tmp_path / "beams.xlsx")
    with (tmp_path / "beams.csv").open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    (tmp_path / "examples").mkdir()
    for workbook in OFFICE.values():
        shutil.copy(ROOT / workbook, tmp_path / workbook)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("page", having("sh"), ids=name)
def test_commands_run(page, folder):
    """One after the other, as somebody would who follows the page."""
    if page.parent.name == "docs":
        (folder / "beams.xlsx").unlink()  # which these pages write themselves
    for line in "".join(blocks(page, "sh")).splitlines():
        program, *words = shlex.split(line, comments=True)
        assert program == "ptbatch"
        assert exit_code(words) == 0, line


@pytest.mark.parametrize("page", having("python"), ids=name)
def test_programs_run(page, folder):
    """The blocks of a page follow each other."""
    (folder / "beams.xlsx").unlink()
    exec("".join(blocks(page, "python")), {"__name__": "docs"})


def test_numbers_of_the_worked_example(folder):
    """Frozen, to the printed digits, by way of the page's own commands. Beyond cracking round-off decides
    about some tenths of a per cent, which differ between kinds of processors; where a flat peak has its
    largest load, it decides about one or two."""
    (folder / "beams.xlsx").unlink()
    for line in "".join(blocks(NUMBERED, "sh")).splitlines():
        assert exit_code(shlex.split(line)[1:]) == 0
    headers, values = load_workbook("beams.results.xlsx")["summary"].iter_rows(values_only=True)
    row = dict(zip(headers, values, strict=True))
    told = re.findall(r"^\| (\w+(?: \[[^\]]+\])?) \| ([^|]+) \|$", NUMBERED.read_text("utf-8"), re.M)
    told = [(header, text.strip()) for header, text in told if header != "column"]
    assert len(told) == 16
    for header, text in told:
        if isinstance(row[header], str):
            assert row[header] == text
            continue
        digit = 10.0 ** -len(text.partition(".")[2])
        loose = 0.03 if header == "deflection_peak [mm]" else 0.01 if re.search("peak|yield", header) else 0.0
        assert row[header] == pytest.approx(float(text), rel=loose, abs=0.51 * digit), header


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_lead_somewhere(page):
    for link in re.findall(r"\]\(([^)]+)\)", page.read_text("utf-8")):
        if "://" not in link:
            assert (page.parent / link.partition("#")[0]).exists(), link


def test_every_page_can_be_found():
    """From the README, or from a page that it names."""
    readme = (ROOT / "README.md").read_text("utf-8")
    assert [page.name for page in PAGES[1:] if f"docs/{page.name}" not in readme] == []
