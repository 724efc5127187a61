"""Members from CSV and Parquet: the same headers, the same validation, places that can be found."""

import codecs
import csv
import io

import pytest

from ptbatch.errors import ReadError
from ptbatch.workbook import source
from ptbatch.workbook.inputs import read_inputs


def text(*rows, separator=",") -> str:
    file = io.StringIO()
    writer = csv.DictWriter(file, list(dict.fromkeys(h for row in rows for h in row)), delimiter=separator)
    writer.writeheader()
    writer.writerows(rows)
    return file.getvalue()


@pytest.fixture
def table(tmp_path):
    """table(text) writes a CSV file and returns its path."""

    def write(content, encoding="utf-8", name="beams.csv"):
        (tmp_path / name).write_bytes(content.encode(encoding))
        return tmp_path / name

    return write


def test_the_same_members_as_from_a_workbook(book, table, beam):
    rows = beam | {"note": "=A1"}, beam | {"member": "B2", "span": "8000; 9000", "dp": "1;2;3;4;5"}
    from_book, from_csv = read_inputs(book(*rows)), read_inputs(table(text(*rows)))
    assert from_csv.all_problems() == from_book.all_problems() == []
    assert [row.member for row in from_csv.rows] == [row.member for row in from_book.rows]
    assert from_csv.extra_headers == ["note"]
    assert [row.extra for row in from_csv.rows] == [("=A1",), (None,)]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_separators_and_the_mark_of_excel(table, beam, encoding, separator):
    beam = {"member": "Tr\u00e4ger", "span [m]": 12} | {
        k: v for k, v in beam.items() if k not in ("member", "span")
    }
    (row,) = read_inputs(table(text(beam, separator=separator), encoding)).rows
    assert (row.name, row.problems, row.member.span) == ("Tr\u00e4ger", [], (12000.0,))


def test_every_fault_has_its_line_and_column(table, beam):
    rows = beam, beam | {"member": "B2", "fc": "12,5", "b": "300 mm"}, beam | {"note": "two\nlines"}, beam
    path = table("Beams of the bridge,,\n\n" + text(*rows))
    inputs = read_inputs(path)
    assert [(row.number, row.name) for row in inputs.rows] == [(4, "B1"), (5, "B2"), (6, "B1"), (8, "B1")]
    problems = inputs.rows[1].problems
    assert [(p.place.cell, p.place.column) for p in problems] == [
        ("line 5, column 3", "b"),
        ("line 5, column 5", "fc"),
    ]
    assert str(problems[1]) == (
        "beams.csv!line 5, column 5  fc = 12,5: a comma is not clear; "
        "use a point for decimals, and no thousands separator"
    )
    assert inputs.rows[3].problems[0].wrong == "the same name stands in line 4, column 1"


def test_a_list_without_quotes_in_a_file_with_semicolons(table, beam):
    headers = ";".join(beam)
    path = table(f"{headers}\nB1;12000;300;600;40;592;300; 500; 300;1395\nB2;;;;;;;;;\n")
    (problem,) = read_inputs(path).rows[0].problems
    assert (problem.place.cell, problem.wrong) == ("line 2, column 10", "10 cells below 8 headers")
    assert "put quotes around" in problem.cure
    assert len(read_inputs(path).rows[1].problems) > 3  # blank cells beyond the headers are no mistake


def test_faults_of_a_header_are_listed_once(table, beam):
    rows = [beam | {"member": f"B{i}", "h [furlong]": 1} for i in range(5)]
    (unit, *missing) = read_inputs(table(text(*rows).replace("h,", "x,", 1))).all_problems()
    assert unit.place.cell == "line 1, column 9"
    assert len(missing) == 1


@pytest.mark.parametrize(
    "content, wrong",
    [
        (b"", "is empty"),
        (b"name,span\nB1,3\n", "no column member"),
        (b"membr,span\nB1,3\n", "did you mean member"),
        (b"member,span\n", "has no rows"),
        (b"member,span\nB1,3\nTr\xe4ger,5\n", "not in UTF-8"),
        (codecs.BOM_UTF16_LE + "member,span\nB1,3\n".encode("utf-16-le"), "not a text in UTF-8"),
        (b"PK\x03\x04\x00\x00member", "not a text in UTF-8"),
        (b'member,span\nB1,"3\n', "check the quotes"),
        (b"member\n" + b"," * 2000 + b"x\n", "more than 1000 cells"),
        (b"member\n" + b"x" * 200_000 + b"\n", "field larger than"),
    ],
)
def test_what_cannot_be_read(tmp_path, content, wrong):
    path = tmp_path / "beams.csv"
    path.write_bytes(content)
    with pytest.raises(ReadError, match=wrong) as raised:
        read_inputs(path)
    assert str(path) in str(raised.value)


def test_blocks_follow_each_other(table, beam, monkeypatch):
    monkeypatch.setattr("ptbatch.workbook.delimited.BLOCK", 3)
    path = table(text(*(beam | {"member": f"B{i % 9}"} for i in range(10))))
    rows = read_inputs(path).rows
    assert [row.name for row in rows] == [f"B{i % 9}" for i in range(10)]
    assert [row.number for row in rows if row.member is None] == [2, 11]
    assert rows[9].number == rows[-1].number == rows[9:][0].number == 11
    with pytest.raises(IndexError):
        rows[10]


def test_too_many_rows(table, beam, monkeypatch):
    monkeypatch.setattr("ptbatch.workbook.inputs.MOST_MEMBERS", 3)
    path = table(text(*(beam | {"member": f"B{i}"} for i in range(4))))
    with pytest.raises(ReadError, match="more than 3 rows; split"):
        read_inputs(path)
    assert source.MOST_MEMBERS == 1_048_575
