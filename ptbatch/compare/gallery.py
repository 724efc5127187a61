"""Drawing the figures of a published table beside a report."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from ptbatch.compare.entry import FAIL, Line
from ptbatch.compare.figures import Figure
from ptbatch.compare.results import Results
from ptbatch.errors import NothingToDrawError, WriteError
from ptbatch.validation import likely

FOLDER = "figures"


class Picture(NamedTuple):
    """A figure that was drawn: its path relative to the report."""

    figure: Figure
    file: str


def draw_figures(
    figures: Sequence[Figure], results: Results, report: Path
) -> tuple[list[Picture], list[Line]]:
    """Draw figures of results into the folder `figures` beside a report.

    Returns the pictures, and a failing line for whatever a figure lacks. Raises ReadError, WriteError.
    """
    if not figures:
        return [], []
    from ptbatch.plots import draw_stored
    from ptbatch.workbook.stored import read_stored

    known = results.summary.rows
    names = dict.fromkeys(name for figure in figures for name in figure.members if name in known)
    stored = {result.name: result for result in read_stored(results.path, list(names))}
    pictures, lines = [], []
    for figure in figures:
        lacking = list(_strangers(figure, known))
        several = [stored[name] for name in figure.members if name in stored]
        file = f"{FOLDER}/{figure.name}.png"
        try:
            if several:
                lacking += draw_stored(several, figure.kind, _in_folder(report.parent / file)).lacking
                pictures.append(Picture(figure, file))
        except NothingToDrawError as error:
            lacking.append(str(error))
        lines += [_lacking(figure, because) for because in lacking]
    return pictures, lines


def _strangers(figure: Figure, known: Iterable[str]) -> Iterator[str]:
    for name in figure.members:
        if name not in known:
            yield f"the results have no member {name}; {likely(name, known)}"


def _in_folder(path: Path) -> Path:
    """The path, whose folder is there from now on."""
    try:
        path.parent.mkdir(exist_ok=True)
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
    return path


def _lacking(figure: Figure, because: str) -> Line:
    members = ", ".join(figure.members)
    return Line(figure.case, members, f"figure {figure.name}", None, None, "", "", FAIL, because)
