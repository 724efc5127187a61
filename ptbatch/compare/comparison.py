"""Two workbooks in, a third one out: results, what is published, and how they agree."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from ptbatch.batch import check_target
from ptbatch.compare.entry import FAIL, PASS, Entry, Line
from ptbatch.compare.judge import judge
from ptbatch.compare.markdown import write_markdown
from ptbatch.compare.published import Published, read_published
from ptbatch.compare.regression import compare_results
from ptbatch.compare.report import counts, sheet, table
from ptbatch.compare.results import Results, read_results
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
    if known is None:
        ours, theirs = (read_results(path, others=()) for path in (results, published))
        lines = compare_results(ours, theirs, rtol)
    else:
        lines = against_table(read_results(results), known, rtol)
    if markdown is not None:
        write_markdown(markdown, lines, results, published)
    written = write_workbook(path, [sheet(lines)])
    return Comparison(lines, known.warnings if known else [], path, written, known is None)


def against_table(results: Results, known: Published, rtol: float) -> list[Line]:
    """The lines of a published table, in its order."""
    return [judge(row, results, rtol) if isinstance(row, Entry) else _faulty(*row) for row in known.rows]


def _faulty(member: str, quantity: str, problems: Sequence[Problem]) -> Line:
    """A row of the table that cannot be understood is a failure that says why."""
    because = "; ".join(map(str, problems))
    return Line(member, member, quantity, None, None, "", "", FAIL, because)


def closing_table(comparison: Comparison) -> list[str]:
    """What a terminal is shown: every line of a published table, of a regression those that fail."""
    shown = [line for line in comparison.lines if line.verdict != PASS or not comparison.regression]
    told = ", ".join(f"{count} {verdict}" for verdict, count in comparison.counts.items() if count)
    lines = table(shown) if shown else []
    if comparison.path != comparison.wanted:
        lines.append(f"{comparison.wanted} is in use and could not be replaced")
    return [*lines, f"{told or 'nothing to compare'}; comparison: {comparison.path}"]
