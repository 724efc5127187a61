"""Files: no workbook, damaged, hostile, far too large."""

import zipfile
from pathlib import Path

import pytest
from openpyxl import load_workbook

from ptbatch.errors import ReadError
from ptbatch.workbook import archive, read
from ptbatch.workbook.inputs import read_inputs


def refused(path: Path) -> str:
    with pytest.raises(ReadError) as error:
        read_inputs(path)
    return str(error.value)


def test_missing_file(tmp_path):
    assert "No such file" in refused(tmp_path / "none.xlsx")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "not an Excel workbook"),
        (b"member;span;b\nB1;12000;300\n", "not an Excel workbook"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600), "password-protected or in the old .xls format"),
        (b"PK\x03\x04 cut short", "not an Excel workbook"),
    ],
)
def test_no_workbook(tmp_path, content, message):
    path = tmp_path / "beams.xlsx"
    path.write_bytes(content)
    assert message in refused(path)


def test_zip_of_something_else(tmp_path):
    path = tmp_path / "beams.xlsx"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet")
    assert "not an .xlsx workbook" in refused(path)


def test_damaged_workbook(tmp_path, book, beam):
    path = tmp_path / "damaged.xlsx"
    with zipfile.ZipFile(book(beam)) as old, zipfile.ZipFile(path, "w") as new:
        for name in old.namelist():
            new.writestr(name, b"<broken" if name.endswith("sheet1.xml") else old.read(name))
    assert "damaged" in refused(path)


def test_entity_bomb(tmp_path, book, beam):
    path = tmp_path / "bomb.xlsx"
    bomb = b'<!DOCTYPE a [<!ENTITY b "x"><!ENTITY c "&b;&b;">]><a>&c;</a>'
    with zipfile.ZipFile(book(beam)) as old, zipfile.ZipFile(path, "w") as new:
        for name in old.namelist():
            new.writestr(name, bomb if name.endswith("sheet1.xml") else old.read(name))
    assert "EntitiesForbidden" in refused(path)


def test_too_large(monkeypatch, book, beam):
    path = book(beam)
    monkeypatch.setattr(archive, "MAX_UNPACKED", 1000)
    assert "unpacks to more than" in refused(path)
    monkeypatch.setattr(archive, "MAX_FILE", 1000)
    assert "larger than" in refused(path)


def test_far_cells(tmp_path, book, beam, monkeypatch):
    path = book(beam)
    workbook = load_workbook(path)
    workbook["members"]["XFD1048576"] = 1
    workbook.save(path)
    assert "cell XFD1048576 lies beyond column 1000; clear it" in refused(path)
    monkeypatch.setattr(read, "MAX_ROWS", 1)
    assert "more than 1 rows" in refused(book(beam))
    monkeypatch.setattr(read, "MAX_CELLS", 9)
    assert "formatted far beyond" in refused(book(beam))


def test_size_that_the_file_declares_is_not_believed(tmp_path, book, beam):
    path = tmp_path / "declared.xlsx"
    with zipfile.ZipFile(book(beam)) as old, zipfile.ZipFile(path, "w") as new:
        for name in old.namelist():
            new.writestr(name, old.read(name).replace(b'<dimension ref="A1:H2"', b'<dimension ref="A1:A1"'))
    assert read_inputs(path).rows[0].member.fpj == 1395.0


@pytest.mark.parametrize("content", [[], [{"member": None}]])
def test_empty_workbook(book, content):
    message = refused(book(*content))
    assert "is empty" in message or "has no rows below its headers" in message


def test_no_members_on_the_first_sheet(book):
    workbook = book(beams=[{"membr": "B1", "span": 12000}])
    book_ = load_workbook(workbook)
    del book_["members"]
    book_.save(workbook)
    assert "sheet beams has no column member; did you mean member where it says membr?" in refused(workbook)
