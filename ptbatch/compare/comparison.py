"""Two workbooks in, a third one out: results, what is published, and how they agree."""

from dataclasses import dataclass
from pathlib import Path

from ptbatch.batch import check_target
from ptbatch.compare.entry import FAIL, PASS, Entry, Line
from ptbatch.compare.figures import Figure
from ptbatch.compare.gallery import Picture, draw_figures
from ptbatch.compare.judge import judge
from ptbatch.compare.markdown import write_markdown
from ptbatch.compare.published import Published, read_published
from ptbatch.compare.regression import compare_results
from ptbatch.compare.report import counts, sheet, table
from ptbatch.compare.results import Results, read_results
from ptbatch.compare.table import Faulty
from ptbatch.workbook.problems import Problem
from ptbatch.workbook.write import write_workbook

RTOL = 1e-6


@dataclass(frozen=True)
class Comparison:
    """What a comparison gave: its lines, warnings about the published table, the file wanted and the one
    written. regression: against other results."""

    lines: list[Line]
    warnings: list[Problem]
    wanted: Path
    path: Path
    regression: bool

    @property
    def counts(self) -> dict[str, int]:
        """How many lines of each verdict."""
        return counts(self.lines)

    @property
    def failed(self) -> bool:
        """Whether a line fails; one that is not reproducible does not."""
        return bool(self.counts[FAIL])


def comparison_path(results: Path) -> Path:
    """`beams.results.xlsx` gives `beams.results.comparison.xlsx`, beside it."""
    return results.with_name(f"{results.stem}.comparison.xlsx")


def compare_workbooks(
    results: Path,
    published: Path,
    output: Path | None = None,
    rtol: float = RTOL,
    markdown: Path | None = None,
) -> Comparison:
    """Compare a results workbook with a published table or with other results, and write how they agree.

    rtol: tolerance of numbers that come without one, as a share of them. Raises ReadError, WriteError.
    """
    path = output or comparison_path(results)
    for target in (path, markdown):
        for source in (results, published):
            if target is not None:
                check_target(target, source)
    known = read_published(published)
    pictures: list[Picture] = []
    if known is None:
        ours, theirs = (read_results(path, others=()) for path in (results, published))
        lines = compare_results(ours, theirs, rtol)
    else:
        ours = read_results(results)
        lines = against_table(ours, known, rtol)
        if markdown is not None:
            sound = [row for row in known.figures if isinstance(row, Figure)]
            pictures, lacking = draw_figures(sound, ours, markdown)
            lines += lacking
    if markdown is not None:
        write_markdown(markdown, lines, pictures, results, published)
    written = write_workbook(path, [sheet(lines)])
    return Comparison(lines, known.warnings if known else [], path, written, known is None)


def against_table(results: Results, known: Published, rtol: float) -> list[Line]:
    """The lines of a published table, in its order; a row that cannot be understood is a failure that says
    why."""
    lines = [judge(row, results, rtol) if isinstance(row, Entry) else _faulty(row) for row in known.rows]
    return lines + [_faulty(row) for row in known.figures if isinstance(row, Faulty)]


def _faulty(row: Faulty) -> Line:
    because = "; ".join(map(str, row.problems))
    return Line(row.member, row.member, row.what, None, None, "", "", FAIL, because)


def closing_table(comparison: Comparison) -> list[str]:
    """What a terminal is shown: every line of a published table, of a regression those that fail."""
    shown = [line for line in comparison.lines if line.verdict != PASS or not comparison.regression]
    told = ", ".join(f"{count} {verdict}" for verdict, count in comparison.counts.items() if count)
    lines = table(shown) if shown else []
    if comparison.path != comparison.wanted:
        lines.append(f"{comparison.wanted} is in use and could not be replaced")
    return [*lines, f"{told or 'nothing to compare'}; comparison: {comparison.path}"]
