"""The shipped workbooks: built by the script, clean, and with the published answers."""

import os
import re

import pytest
from openpyxl import load_workbook

from examples.build import EXAMPLE, PAPER, PUBLISHED, ROOT, TEMPLATES, build
from ptbatch.batch import run_workbook
from ptbatch.workbook.inputs import read_inputs

INPUTS = (EXAMPLE, PAPER, *TEMPLATES.values())
SHIPPED = (*INPUTS, PUBLISHED)


def content(path) -> dict[str, list]:
    """All rows of all sheets."""
    return {sheet.title: list(sheet.values) for sheet in load_workbook(path)}


def test_shipped_workbooks_are_those_that_the_script_builds(tmp_path):
    build(tmp_path)
    for path in SHIPPED:
        assert content(ROOT / path) == content(tmp_path / path), path


def test_building_twice_gives_the_same_bytes(tmp_path):
    first, second = ([path.read_bytes() for path in build(tmp_path / name)] for name in "ab")
    assert first == second


@pytest.mark.parametrize("path", INPUTS)
def test_shipped_workbooks_are_clean(path):
    inputs = read_inputs(ROOT / path)
    assert inputs.all_problems() == []
    assert all(row.member for row in inputs.rows)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """The summary of the example, by member."""
    path = tmp_path_factory.mktemp("results") / "beams.results.xlsx"
    batch = run_workbook(ROOT / EXAMPLE, path, jobs=os.cpu_count() or 1)
    return {line[0]: dict(zip(batch.headers, line, strict=True)) for line in batch.lines}


def test_every_row_passes(results):
    failed = {name: row["message"] for name, row in results.items() if row["status"] not in ("ok", "warning")}
    assert failed == {}


@pytest.mark.parametrize(
    ("member", "jacking_end", "fixed_end"),
    [  # published: Huang and Kang (2018), Table 1, the analytical columns
        ("Specimen 1, set 0.05 in", 5.5, 8.2),
        ("Specimen 1, set 0.125 in", 9.5, 8.2),
        ("Specimen 2, set 0.05 in", 6.3, 11.5),
        ("Specimen 2, set 0.125 in", 10.5, 11.5),
        ("Specimen 1, set 0.05 in, waves", 5.5, 8.2),
        ("Specimen 2, set 0.05 in, waves", 6.3, 11.5),
        ("Specimen 1, set 0.125 in, waves", 9.5, 8.2),
        ("Specimen 2, set 0.125 in, waves", 10.5, 11.5),
        ("Specimen 1, no set", 0.0, 8.2),
        ("Specimen 2, no set", 0.0, 11.5),
    ],
)
def test_losses_of_the_specimens(results, member, jacking_end, fixed_end):
    row = results[member]
    assert row["loss_jacking_end_analytic [%]"] == pytest.approx(jacking_end, abs=0.2)
    assert row["loss_fixed_end_analytic [%]"] == pytest.approx(fixed_end, abs=0.2)
    assert row["loss_jacking_end_fe [%]"] == pytest.approx(jacking_end, abs=0.5)
    assert row["loss_fixed_end_fe [%]"] == pytest.approx(fixed_end, abs=0.5)


def test_meshes_of_the_imaginary_beam_agree(results):
    rows = [results[f"Imaginary beam, {n} el."] for n in (20, 40, 60)]
    friction = [row["loss_fixed_end_fe [%]"] for row in rows]
    wedge_set = [row["loss_jacking_end_fe [%]"] for row in rows]
    assert max(friction) - min(friction) < 0.05
    assert max(wedge_set) - min(wedge_set) < 0.1
    assert rows[0]["loss_fixed_end_analytic [%]"] == pytest.approx(4.30, abs=0.005)  # closed form


@pytest.mark.parametrize("beam", ["A-1", "A-2", "A-3", "A-6", "A-9"])
def test_friction_hardly_matters_in_a_single_span(results, beam):
    """Published as a finding by Huang and Kang (2018); 2 % is ours."""
    with_friction, without = (results[f"{beam}, mu {mu}"]["load_peak [kN]"] for mu in ("0.3", "0"))
    assert with_friction == pytest.approx(without, rel=0.02)


def test_code_in_the_readme_runs(capsys):
    code = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), re.DOTALL)
    exec(compile(code[1], "README.md", "exec"), {})
    assert "ok" in capsys.readouterr().out
