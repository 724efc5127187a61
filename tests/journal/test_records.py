"""Records on disk: whatever a killed run leaves behind, the sound ones are found again."""

import pytest

from ptbatch.errors import WriteError
from ptbatch.journal.records import MAGIC, Records

KEYS = [bytes([i]) * 16 for i in range(4)]
CONTENTS = [b"first", b"", b"a third one" * 50, b"last"]


def write(path, first=0, end=4):
    records = Records(path)
    for key, content in zip(KEYS[first:end], CONTENTS[first:end], strict=True):
        records.add(key, content)
    records.close()


def read(path) -> dict:
    records = Records(path)
    found = {key: records[key] for key in KEYS if key in records}
    records.close()
    return found


def test_records_come_back(tmp_path):
    write(tmp_path / "j")
    assert read(tmp_path / "j") == dict(zip(KEYS, CONTENTS, strict=True))


@pytest.mark.parametrize("left", range(0, 60, 7))
def test_a_torn_record_is_cut_off_and_written_again(tmp_path, left):
    """The last record is 24 + 550 bytes long; what is left of it may be any part."""
    path = tmp_path / "j"
    write(path, 0, 2)
    sound = path.stat().st_size
    write(path, 2, 3)
    with path.open("r+b") as file:
        file.truncate(sound + left)
    assert list(read(path)) == KEYS[:2]
    assert path.stat().st_size == sound
    write(path)
    assert read(path) == dict(zip(KEYS, CONTENTS, strict=True))


def test_a_changed_byte_is_noticed(tmp_path):
    path = tmp_path / "j"
    write(path)
    content = bytearray(path.read_bytes())
    content[-2] ^= 1
    path.write_bytes(content)
    assert list(read(path)) == KEYS[:3]


@pytest.mark.parametrize("left", range(len(MAGIC)))
def test_killed_before_the_first_record(tmp_path, left):
    path = tmp_path / "j"
    path.write_bytes(MAGIC[:left])
    assert read(path) == {}
    write(path)
    assert len(read(path)) == 4


def test_the_last_record_of_a_key_counts(tmp_path):
    records = Records(tmp_path / "j")
    records.add(KEYS[0], b"old")
    records.add(KEYS[0], b"new")
    assert (records[KEYS[0]], len(records)) == (b"new", 1)
    records.add(KEYS[1], b"more")
    assert records[KEYS[1]] == b"more"
    records.close()
    assert read(tmp_path / "j") == {KEYS[0]: b"new", KEYS[1]: b"more"}


def test_a_foreign_file_is_left_alone(tmp_path):
    (tmp_path / "j").write_text("something else, and longer than the mark")
    with pytest.raises(WriteError, match="is no journal"):
        Records(tmp_path / "j")
    assert (tmp_path / "j").read_text().startswith("something else")


def test_one_run_at_a_time(tmp_path):
    records = Records(tmp_path / "j")
    with pytest.raises(WriteError, match="another run"):
        Records(tmp_path / "j")
    records.close()
    Records(tmp_path / "j").close()
