"""Parquet: members from it, long tables to it."""

from decimal import Decimal

import pytest
from openpyxl import load_workbook

from ptbatch.batch import run_workbook
from ptbatch.cli import exit_code
from ptbatch.errors import ReadError
from ptbatch.workbook import arrow
from ptbatch.workbook.filed import LONG_TABLES
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.parquet import REASONS
from ptbatch.workbook.stored import read_stored

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")


@pytest.fixture
def table(tmp_path):
    """table(row, ...) writes a Parquet file from rows by header and returns its path."""

    def write(*rows, **options):
        headers = list(dict.fromkeys(header for row in rows for header in row))
        columns = {header: [row.get(header) for row in rows] for header in headers}
        pq.write_table(pa.table(columns), tmp_path / "beams.parquet", **options)
        return tmp_path / "beams.parquet"

    return write


def read(folder, name) -> list[dict]:
    return pq.read_table(folder / f"{name}.parquet").to_pylist()


def test_the_same_members_as_from_a_workbook(book, table, beam):
    typed = beam | {"dp": [300.0, 500.0, 300.0], "fc": Decimal(40), "self_weight": False}
    (row,) = read_inputs(table(typed)).rows
    assert row.problems == []
    assert row.member == read_inputs(book(beam | {"self_weight": "no"})).rows[0].member


def test_every_fault_has_its_row_and_column(table, beam):
    path = table(beam | {"fc": "40"}, beam | {"member": "B2", "fc": "12,5"}, {"member": ""}, row_group_size=1)
    inputs = read_inputs(path)
    assert [p.place.cell for p in inputs.all_problems()] == ["row 2, column 5"]
    assert inputs.rows[1].problems[0].place.sheet == "beams.parquet"
    missing = read_inputs(table({k: v for k, v in beam.items() if k != "fc"})).all_problems()
    assert (missing[0].place.cell, missing[0].wrong) == ("column 8", "there is no such column")


@pytest.mark.parametrize("content", [b"", b"PAR1 and nothing else PAR1", b"member,span\n"])
def test_what_cannot_be_read(tmp_path, content):
    path = tmp_path / "beams.parquet"
    path.write_bytes(content)
    with pytest.raises(ReadError, match="not a Parquet file or damaged"):
        read_inputs(path)


def test_huge_row_groups_are_refused(table, beam, monkeypatch):
    monkeypatch.setattr("ptbatch.workbook.columnar.MAX_UNPACKED", 10)
    with pytest.raises(ReadError, match="smaller ones"):
        read_inputs(table(beam))


def test_long_tables_go_to_files(book, beam, engine, tmp_path):
    rebar = [{"member": "B1", "depth": 550, "area": 400}]
    rows = beam, beam | {"member": "B2", "fc": "x"}, beam | {"member": "stuck"}
    source, folder = book(*rows, rebar=rebar), tmp_path / "files"
    batch = run_workbook(source, parquet=folder)
    assert load_workbook(batch.path).sheetnames == ["summary", "problems", "run", "legend"]
    assert dict(load_workbook(batch.path)["run"].values)[LONG_TABLES] == "files"
    assert sorted(path.name for path in folder.iterdir()) == [
        f"{name}.parquet" for name in ("cracks", "curves", "members", "rebar", "summary", "tendon")
    ]
    assert [row["member"] for row in read(folder, "curves")] == ["B1", "B1", "stuck", "stuck"]
    assert read(folder, "curves")[0]["load [kN]"] == 2.0
    good, bad, stuck = read(folder, "summary")
    assert (good["load_peak [kN]"], good["status"], good[REASONS]) == (1.25, "ok", "")
    assert (bad["load_peak [kN]"], bad["status"]) == (None, "invalid")
    assert "load_peak [kN]: not reached: no equilibrium" in stuck[REASONS]
    assert good["failure"] == "1.25"  # a column of texts


def test_files_of_an_earlier_run_do_not_stay(book, beam, engine, tmp_path):
    folder = tmp_path / "files"
    run_workbook(book(beam, rebar=[{"member": "B1", "depth": 550, "area": 400}]), parquet=folder)
    assert len(read(folder, "rebar")) == 1
    run_workbook(book(beam), parquet=folder)
    assert not (folder / "rebar.parquet").exists()


def test_members_in_files_can_be_run_again(book, beam, engine, tmp_path):
    source = book(beam | {"As": "100; 200", "ds": "500; 550", "elements": 8})
    run_workbook(source, parquet=tmp_path / "files")
    again = read_inputs(tmp_path / "files" / "members.parquet")
    assert again.all_problems() == []
    assert again.rows[0].member == read_inputs(source).rows[0].member


def test_results_are_read_back_from_files(book, beam, engine, tmp_path):
    source = book(*(beam | {"member": name} for name in ("B1", "B2", "B3")))
    in_book, to_files = tmp_path / "a.xlsx", tmp_path / "b.xlsx"
    run_workbook(source, in_book)
    run_workbook(source, to_files, parquet=tmp_path / "files")
    ours, theirs = read_stored(to_files, ["B2"])[0], read_stored(in_book, ["B2"])[0]
    assert ours.member == theirs.member is not None
    assert ours.tendon == theirs.tendon
    assert (ours.curves, ours.cracks) == (theirs.curves, theirs.cracks)
    (tmp_path / "files").rename(tmp_path / "elsewhere")
    with pytest.raises(ReadError, match="which is not there"):
        read_stored(to_files, ["B2"])


def test_many_members_make_files_by_themselves(book, beam, engine, monkeypatch, capsys):
    monkeypatch.setattr("ptbatch.batch.MANY", 1)
    path = book(beam, beam | {"member": "B2"})
    assert exit_code(["run", str(path)]) == 0
    assert f"long tables: {path.with_name('beams.results.tables')}" in capsys.readouterr().err
    monkeypatch.setattr("ptbatch.batch.has_arrow", lambda: False)
    assert run_workbook(path).tables is None


def test_a_full_sheet(book, beam, engine, monkeypatch, capsys):
    """The cure keeps what was analysed."""
    path = book(*(beam | {"member": f"B{i}"} for i in range(60)))
    monkeypatch.setattr("ptbatch.workbook.page.LAST_ROW", 81)
    assert exit_code(["run", str(path)]) == 4
    assert "sheet curves has 81 rows, more than Excel takes; let --parquet FOLDER" in capsys.readouterr().err
    folder = str(path.with_name("files"))
    assert exit_code(["run", str(path), "--resume", "--parquet", folder]) == 0
    assert "41 rows from the journal" in capsys.readouterr().err


def test_without_pyarrow(table, book, beam, engine, monkeypatch, capsys):
    path = table(beam)
    monkeypatch.setattr(arrow, "find_spec", lambda name: None)
    assert exit_code(["check", str(path)]) == 4
    assert exit_code(["run", str(book(beam)), "--parquet", str(path.with_name("files"))]) == 4
    assert capsys.readouterr().err.count("pip install 'ptbatch[parquet]'") == 2


@pytest.mark.parametrize("name", ["o.parquet", "o.csv"])
def test_results_are_a_workbook(book, beam, engine, tmp_path, name, capsys):
    assert exit_code(["run", str(book(beam)), "-o", str(tmp_path / name)]) == 4
    assert "--parquet FOLDER" in capsys.readouterr().err


def test_nothing_half_written_is_left(book, beam, engine, tmp_path, monkeypatch):
    monkeypatch.setattr("ptbatch.workbook.write._save", lambda *_: 1 / 0)
    folder = tmp_path / "files"
    assert exit_code(["run", str(book(beam)), "--parquet", str(folder)]) == 70
    assert not [path for path in folder.iterdir() if path.name.startswith(".")]
    monkeypatch.setattr("ptbatch.batch.Pairing.__iter__", lambda self: 1 / 0)
    assert exit_code(["run", str(book(beam)), "--parquet", str(tmp_path / "more")]) == 70
    assert list((tmp_path / "more").iterdir()) == []
