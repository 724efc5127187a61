"""ptbatch report: files, messages and exit codes."""

from ptbatch.cli import exit_code


def report(*words) -> int:
    return exit_code(["report", *map(str, words)])


def test_beside_the_results(results, capsys):
    assert report(results, "--member", "simple") == 0
    assert capsys.readouterr().err == f"written: {results.with_name('beams.report.html')}\n"


def test_into_a_folder(results, tmp_path):
    assert report(results, "--member", "simple", "-o", tmp_path) == 0
    assert [path.name for path in tmp_path.iterdir()] == ["beams.report.html"]


def test_what_is_missing_is_said(results, tmp_path, capsys):
    words = ["--member", "stuck", "--member", "wrong", "-o", tmp_path / "a.html"]
    assert report(results, *words) == 3
    stuck, wrong, written = capsys.readouterr().err.splitlines()
    assert stuck.startswith("stuck lacks the tendon under live load, the live load; not converged: ")
    assert wrong.startswith("wrong lacks the member itself; invalid: ")
    assert written == f"written: {tmp_path / 'a.html'}"


def test_unknown_member(results, capsys):
    assert report(results, "--member", "Simple") == 2
    assert "--member: there is no member Simple; did you mean simple?" in capsys.readouterr().err


def test_a_name_that_is_no_page(results, tmp_path):
    assert report(results, "-o", tmp_path / "a.docx") == 2


def test_nothing_to_read_or_write(results, tmp_path, capsys):
    assert report(tmp_path / "none.xlsx") == 4
    assert report(results.with_name("beams.xlsx")) == 4
    assert "these are no results" in capsys.readouterr().err
    assert report(results, "-o", tmp_path / "none" / "a.html") == 4
