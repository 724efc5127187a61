"""Results against other results: every number and text of `summary`, member by member."""

from collections import Counter
from collections.abc import Iterator

from ptbatch.compare.entry import FAIL, Entry, Line, Query
from ptbatch.compare.judge import line, weigh
from ptbatch.compare.results import Results, Row, as_value

SKIPPED = ("member", "time", "newton_iterations")  # of the machine and of the way to the answer
ROUND_OFF = 1e-6  # in the unit of a column: differences as small as this are none

Key = tuple[str, int]  # member, and which of the rows of that name


def compare_results(ours: Results, theirs: Results, rtol: float) -> list[Line]:
    """Lines of all values. Members and columns that one side alone has make one failing line each."""
    our_rows, their_rows = _rows(ours), _rows(theirs)
    lines = [_lonely("all members", name, where) for name, where in _one_sided_columns(ours, theirs)]
    for key, row in their_rows.items():
        if key in our_rows:
            lines += _values(key[0], our_rows[key], row, theirs, rtol)
        else:
            lines.append(_lonely(key[0], "row", ours.path.name))
    return lines + [_lonely(key[0], "row", theirs.path.name) for key in our_rows if key not in their_rows]


def _rows(results: Results) -> dict[Key, Row]:
    return {(member, i): row for member, rows in results.summary.rows.items() for i, row in enumerate(rows)}


def _one_sided_columns(ours: Results, theirs: Results) -> Iterator[tuple[str, str]]:
    """Columns that one side alone has, and the file that lacks them."""
    both = [(results.path.name, set(results.summary.headers) - set(SKIPPED)) for results in (ours, theirs)]
    counts = Counter(name for _, names in both for name in names)
    for file, names in both:
        for name in (*theirs.summary.headers, *ours.summary.headers):
            if counts[name] == 1 and name not in names:
                yield name, file


def _values(member: str, ours: Row, theirs: Row, published: Results, rtol: float) -> Iterator[Line]:
    for name, header in published.summary.headers.items():
        if name in SKIPPED or name not in ours:
            continue
        value = as_value(theirs[name])
        of = Query(member, header.name)
        entry = Entry(member, of, value, published.path.name, rtol=rtol, atol=ROUND_OFF)
        yield weigh(entry, as_value(ours[name]), header.unit, rtol)


def _lonely(member: str, what: str, file: str) -> Line:
    entry = Entry(member, Query(member, what), None, file)
    return line(entry, None, "", 0.0, FAIL, f"missing in {file}")
