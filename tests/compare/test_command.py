"""`ptbatch compare`: exit codes, what goes where, and that the inputs stay as they are."""

import json

import pytest

from ptbatch.cli import exit_code
from tests.compare.made_up import summary


@pytest.fixture
def compare(results, published, capsys):
    """Exit code, stdout and stderr of a comparison with rows."""

    def run(*rows, options=()):
        code = exit_code(["compare", str(results()), str(published(*rows)), *options])
        return code, *capsys.readouterr()

    return run


def test_all_pass(compare, tmp_path):
    code, out, err = compare({}, {"value": 1, "not_reproducible": "a misprint"})
    assert (code, out) == (0, "")
    assert err.splitlines()[0].split() == ["verdict", "member", "quantity", "ours", "theirs", "tolerance"]
    last = f"1 pass, 1 not reproducible; comparison: {tmp_path / 'beams.results.comparison.xlsx'}"
    assert err.splitlines()[-1] == last


def test_one_fails(compare):
    code, _, err = compare({}, {"value": 1})
    assert code == 1
    assert "off by 199" in err


def test_a_faulty_row_is_a_failure(compare):
    code, _, err = compare({}, {"source": None})
    assert code == 1
    assert "published!E3  source: missing" in err


def test_regression_shows_what_fails(results, capsys):
    ours, same = results(), results(name="same.xlsx")
    assert exit_code(["compare", str(ours), str(same)]) == 0
    assert capsys.readouterr().err.startswith("14 pass; comparison:")
    other = results(summary(), summary(member="B3"), name="other.xlsx")
    assert exit_code(["compare", str(ours), str(other)]) == 1
    assert "FAIL     B3      row" in capsys.readouterr().err
    assert (
        exit_code(["compare", str(ours), str(results(summary(**{"load_peak [kN]": 201}), name="c.xlsx"))])
        == 1
    )
    options = ["--rtol", "0.01"]
    near = results(summary(**{"load_peak [kN]": 201}), name="near.xlsx")
    assert exit_code(["compare", str(results(summary())), str(near), *options]) == 0


def test_json(compare):
    code, out, _ = compare({}, {"value": 1}, options=["--json"])
    assert code == 1
    assert [record["verdict"] for record in json.loads(out)] == ["pass", "fail"]


def test_output_and_markdown(compare, tmp_path):
    paths = tmp_path / "out.xlsx", tmp_path / "out.md"
    options = ["-o", str(paths[0]), "--markdown", str(paths[1])]
    assert compare({}, options=options)[0] == 0
    assert all(path.is_file() for path in paths)
    assert not (tmp_path / "beams.results.comparison.xlsx").exists()


def test_inputs_are_never_touched(results, published, capsys):
    paths = results(), published({})
    before = [path.read_bytes() for path in paths]
    for path in paths:
        assert exit_code(["compare", *map(str, paths), "-o", str(path)]) == 4
        assert exit_code(["compare", *map(str, paths), "--markdown", str(path)]) == 4
        assert "is the input, which is never touched" in capsys.readouterr().err
    assert [path.read_bytes() for path in paths] == before


def test_unreadable(results, published, book, beam, tmp_path, capsys):
    assert exit_code(["compare", str(tmp_path / "none.xlsx"), str(published({}))]) == 4
    assert exit_code(["compare", str(results()), __file__]) == 4
    assert exit_code(["compare", str(book(beam)), str(published({}))]) == 4
    assert "no sheet summary; give a results workbook, as `ptbatch run` writes it" in capsys.readouterr().err


@pytest.mark.parametrize("options", [[], ["a.xlsx"], ["a.xlsx", "b.xlsx", "--rtol", "-1"]])
def test_usage(options, capsys):
    assert exit_code(["compare", *options]) == 2
    assert capsys.readouterr().err


def test_help_names_the_exit_codes(capsys):
    assert exit_code(["compare", "--help"]) == 0
    out = capsys.readouterr().out
    assert "RESULTS PUBLISHED" in out and "1   a check or a comparison failed" in out
