"""Results against results of another run. Every number is made up; see made_up."""

import pytest

from ptbatch.compare.comparison import compare_workbooks
from ptbatch.compare.results import read_results
from ptbatch.errors import ReadError
from tests.compare.made_up import summary, write


@pytest.fixture
def failing(results):
    """(member, quantity, because) of what fails against rows of another run."""

    def compare(*theirs, ours=(), **options):
        earlier = results(*theirs, name="earlier.results.xlsx")
        lines = compare_workbooks(results(*ours), earlier, **options).lines
        return [(line.member, line.what, line.because) for line in lines if line.verdict == "fail"]

    return compare


def test_the_same_results_agree(results, failing):
    assert failing() == []
    lines = compare_workbooks(results(), results(name="same.xlsx")).lines
    assert [line.what for line in lines if line.member == "B1"] == [
        *("status", "message", "load_peak", "failure", "loss_fixed_end_fe", "loss_fixed_end_analytic"),
        "camber_anchored",
    ]


def test_time_and_iterations_do_not_count(failing):
    ours = (summary(),)
    assert failing(summary(**{"time [ms]": 1.0, "newton_iterations": 1}), ours=ours) == []


@pytest.mark.parametrize(
    ("theirs", "because"),
    [
        ({"load_peak [kN]": 199.0}, "off by 1 (0.5 %)"),
        ({"failure": "concrete crushing"}, "the results say: bar rupture"),
        ({"status": "warning"}, "the results say: ok"),
        ({"load_peak [kN]": "none"}, "a number in the results, a text in the table: none"),
        ({"message": "slow"}, "the results say: nothing"),
    ],
)
def test_what_differs_fails(failing, theirs, because):
    ((member, _, told),) = failing(summary(**theirs), ours=(summary(),))
    assert (member, told) == ("B1", because)


def test_tolerance(failing):
    theirs, ours = summary(**{"load_peak [kN]": 200.1}), (summary(),)
    assert failing(theirs, ours=ours, rtol=1e-3) == []
    assert len(failing(theirs, ours=ours, rtol=1e-4)) == 1


def test_round_off_is_no_difference(failing):
    assert failing(summary(**{"camber_anchored [mm]": -3e-9}), ours=(summary(),)) == []


def test_rows_of_one_side_alone(failing):
    assert failing(summary(member="B2"), ours=(summary(member="B1"),)) == [
        ("B2", "row", "missing in beams.results.xlsx"),
        ("B1", "row", "missing in earlier.results.xlsx"),
    ]


def test_columns_of_one_side_alone(failing):
    ours = summary(**{"cost [EUR]": 1.0})
    theirs = summary(**{"cost [EUR]": 1.0, "grade": "A"})
    del ours["failure"]
    assert failing(theirs, ours=(ours,)) == [
        ("all members", "failure", "missing in beams.results.xlsx"),
        ("all members", "grade", "missing in beams.results.xlsx"),
    ]


def test_rows_of_the_same_name_are_paired_in_their_order(failing):
    first, second = summary(), summary(**{"load_peak [kN]": 1.0})
    assert failing(first, second, ours=(first, second)) == []
    assert len(failing(first, second, ours=(second, first))) == 2


def test_results_that_were_cut_are_refused(tmp_path, results):
    path = write(tmp_path / "cut.xlsx", summary=[summary()], tendon=[{"member": "B1", "stage": "jacked"}])
    with pytest.raises(ReadError, match="sheet tendon has no column x; compare results as they were written"):
        read_results(path)


def test_more_rows_than_a_table_of_members_may_have(tmp_path, monkeypatch):
    monkeypatch.setattr("ptbatch.workbook.read.MAX_ROWS", 1)
    path = write(tmp_path / "a.xlsx", summary=[summary(), summary(member="B2")])
    other = write(tmp_path / "b.xlsx", summary=[summary(), summary(member="B2")])
    assert not compare_workbooks(path, other).failed
