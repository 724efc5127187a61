"""From a workbook and the names of members to figures on disk."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from matplotlib.figure import Figure

from ptbatch.errors import NothingToDrawError, OutputNameError
from ptbatch.plots.missing import lack, missing
from ptbatch.plots.output import save, target
from ptbatch.plots.pages import figure_of, geometry_of, page_of
from ptbatch.plots.sketch import sketch
from ptbatch.workbook.inputs import read_inputs
from ptbatch.workbook.stored import Stored, read_stored


@dataclass(frozen=True)
class Drawn:
    """The files written, and what could not be drawn in them and why."""

    written: list[Path]
    lacking: list[str]


def draw(results: Path, members: Sequence[str], figure: str = "all", output: Path | None = None) -> Drawn:
    """Draw members from a results workbook.

    figure: `stress`, `redistribution`, `load-deflection`, `cracks` or `profile` of all members in one file,
    or `all`: a page of each, in files of their own or in one PDF. output: a .png, .pdf or .svg file, or a
    folder; beside the results if None. Raises ReadError, UnknownMemberError, OutputNameError, WriteError, and
    NothingToDrawError where no member has anything that the figure shows.
    """
    several = read_stored(results, list(dict.fromkeys(members)))
    if figure != "all":
        path = target(results, [stored.name for stored in several], figure, output)
        return draw_stored(several, figure, path)
    lacking = _lacking(several, figure)
    if all(stored.member is None for stored in several):
        raise NothingToDrawError("nothing to draw: " + "; ".join(lacking))
    pages = [(stored.name, lambda stored=stored: page_of(stored)) for stored in several if stored.member]
    return Drawn(_save_pages(results, pages, figure, output), lacking)


def draw_stored(several: Sequence[Stored], figure: str, path: Path) -> Drawn:
    """Draw one kind of figure of members, as `draw` does, from results read before. Raises WriteError,
    NothingToDrawError."""
    lacking = _lacking(several, figure)
    if all(missing(stored, figure) for stored in several):
        raise NothingToDrawError("nothing to draw: " + "; ".join(lacking))
    return Drawn([save([figure_of(several, figure)], path)], lacking)


def _lacking(several: Sequence[Stored], figure: str) -> list[str]:
    return [lack(stored, what) for stored in several if (what := missing(stored, figure))]


def draw_geometry(workbook: Path, members: Sequence[str], output: Path | None = None) -> Drawn:
    """Draw elevation and section of members from an input workbook, before any analysis; of an invalid row
    too if its values allow it.

    Raises what `draw` raises.
    """
    inputs = read_inputs(workbook)
    rows = inputs.only(members).rows
    lacking = [f"{row.name} is invalid: {text}" for row in rows if not row.member for text in row.problems]
    sketches = [(row.name, row.member or sketch(row)) for row in rows]
    pages = [
        (name, lambda member=member: geometry_of(member, inputs.system))
        for name, member in sketches
        if member
    ]
    if not pages:
        raise NothingToDrawError("nothing to draw: " + "; ".join(lacking))
    return Drawn(_save_pages(workbook, pages, "geometry", output), lacking)


def _save_pages(
    source: Path, pages: Sequence[tuple[str, Callable[[], Figure]]], figure: str, output: Path | None
) -> list[Path]:
    """Save each page to a file of its own, or all of them to the PDF asked for."""
    paths = [target(source, [name], figure, output) for name, _ in pages]
    if len(set(paths)) == len(paths):
        return [save([make()], path) for (_, make), path in zip(pages, paths, strict=True)]
    if output is None or output.is_dir():
        raise OutputNameError(
            "the names of these members make the same file name; draw them one by one with -o"
        )
    if output.suffix.lower() != ".pdf":
        raise OutputNameError(f"{len(pages)} members make as many pages; give a folder, or a file .pdf")
    return [save([make() for _, make in pages], paths[0])]
