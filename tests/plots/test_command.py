"""ptbatch plot: files, messages and exit codes."""

import subprocess
import sys
from pathlib import Path

import pytest

from ptbatch.cli import FIGURES, exit_code
from ptbatch.plots import draw
from ptbatch.plots.output import target
from ptbatch.plots.pages import HEIGHTS

ROOT = Path(__file__).parents[2]


def plot(*words) -> int:
    return exit_code(["plot", *map(str, words)])


def test_a_page_beside_the_results(results, capsys):
    assert plot(results, "--member", "simple") == 0
    path = results.with_name("beams.simple.png")
    assert capsys.readouterr().err == f"written: {path}\n"
    assert path.read_bytes().startswith(b"\x89PNG")


def test_several_members_in_one_figure(results, tmp_path):
    words = [results, "--member", "simple", "--member", "two spans", "--figure", "load-deflection"]
    assert plot(*words, "-o", tmp_path) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["beams.simple+two_spans.load-deflection.png"]
    assert plot(*words, "-o", tmp_path / "a.svg") == 0
    assert (tmp_path / "a.svg").read_bytes().startswith(b"<?xml")


def test_several_pages(results, tmp_path, capsys):
    words = [results, "--member", "simple", "--member", "US tee", "-o"]
    assert plot(*words, tmp_path / "a.png") == 2
    assert "2 members make as many pages" in capsys.readouterr().err
    assert plot(*words, tmp_path / "a.pdf") == 0
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


def test_the_same_results_make_the_same_file(results, tmp_path):
    first, second = (
        draw(results, ["simple"], "cracks", tmp_path / name).written[0] for name in ("a.pdf", "b.pdf")
    )
    assert first.read_bytes() == second.read_bytes()


def test_unknown_member(results, capsys):
    assert plot(results, "--member", "Simple") == 2
    assert "--member: there is no member Simple; did you mean simple?" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words", [[], ["--member", "simple", "--figure", "moon"], ["--member", "simple", "-o", "a.gif"]]
)
def test_usage(results, words):
    assert plot(results, *words) == 2


def test_what_is_missing_is_said(results, tmp_path, capsys):
    assert plot(results, "--member", "stuck", "-o", tmp_path / "a.png") == 3
    told, written = capsys.readouterr().err.splitlines()
    assert told.startswith("stuck lacks the tendon under live load, the live load; not converged: ")
    assert written.startswith("written: ")
    assert plot(results, "--member", "outside", "-o", tmp_path / "b.png") == 4
    told = "nothing to draw: outside lacks the member itself; invalid: dp [mm] in members!"
    assert told in capsys.readouterr().err
    both = ["--member", "outside", "--member", "simple", "--figure", "stress", "-o", tmp_path / "c.png"]
    assert plot(results, *both) == 3
    assert not (tmp_path / "b.png").exists()
    assert (tmp_path / "c.png").exists()


def test_nothing_to_read_or_write(source, results, tmp_path, capsys):
    assert plot(source, "--member", "simple") == 4
    assert "no sheet summary; --geometry draws an input workbook" in capsys.readouterr().err
    assert plot(tmp_path / "none.xlsx", "--member", "simple") == 4
    assert plot(results, "--member", "simple", "-o", tmp_path / "none" / "a.png") == 4


def test_geometry_of_an_input(source, tmp_path, capsys):
    assert plot(source, "--geometry", "--member", "US tee", "-o", tmp_path) == 0
    assert (tmp_path / "beams.US_tee.geometry.png").exists()
    assert plot(source, "--geometry", "--member", "US tea") == 2
    assert plot(source, "--geometry", "--figure", "stress", "--member", "simple") == 2


def test_letters_that_the_font_has_not_are_no_message(book, beam, tmp_path, capsys, recwarn):
    path = book(beam | {"member": "名前"})
    assert plot(path, "--member", "名前", "--geometry", "-o", tmp_path / "a.pdf") == 0
    assert capsys.readouterr().err == f"written: {tmp_path / 'a.pdf'}\n"
    assert not recwarn.list


def test_geometry_shows_a_tendon_outside_the_section(source, tmp_path, capsys):
    assert plot(source, "--geometry", "--member", "outside", "-o", tmp_path / "a.png") == 3
    assert "the tendon at 650 mm lies outside the section" in capsys.readouterr().err
    assert (tmp_path / "a.png").exists()


def test_geometry_of_a_row_that_cannot_be_drawn(book, beam, tmp_path):
    path = book(beam | {"b": None}, beam | {"member": "B2", "shape": "box"})
    assert plot(path, "--geometry", "--member", "B1", "--member", "B2") == 4


@pytest.mark.parametrize(
    ("names", "figure", "name"),
    [
        (["A/B: 1"], "all", "beams.A_B_1.png"),
        (["..."], "stress", "beams.member.stress.png"),
        (["Träger 1", "B"], "cracks", "beams.Träger_1+B.cracks.png"),
        (["x" * 200], "all", f"beams.{'x' * 80}.png"),
    ],
)
def test_names_of_files(tmp_path, names, figure, name):
    assert target(tmp_path / "beams.results.xlsx", names, figure, None) == tmp_path / name


def test_kinds_of_the_command_line_are_those_of_the_pages():
    assert FIGURES == (*HEIGHTS, "all")


def last_line(code) -> str:
    """What a program of its own prints last."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    return done.stdout.splitlines()[-1]


@pytest.mark.parametrize("words", [["plot", "-h"], ["report", "-h"], ["check", "examples/beams.xlsx"]])
def test_matplotlib_is_for_drawing_alone(words):
    code = f"""
import sys
from ptbatch.cli import exit_code
exit_code({words!r})
print([name for name in ("matplotlib", "numba") if name in sys.modules])
"""
    assert last_line(code) == "[]"


def test_drawing_leaves_no_global_state(results, tmp_path):
    code = f"""
import sys
from pathlib import Path
from matplotlib import rcParams
from ptbatch.plots import draw
names = set(rcParams) - {{"backend"}}  # to look it up is to load one
before = [rcParams[name] for name in names]
draw(Path({str(results)!r}), ["simple"], "stress", Path({str(tmp_path / "a.png")!r}))
same = [rcParams[name] for name in names] == before
print(same, [name for name in ("matplotlib.pyplot", "numba") if name in sys.modules])
"""
    assert last_line(code) == "True []"
