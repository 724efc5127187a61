"""A comparison as a report in Markdown: case by case our number, theirs, the verdict and where it is from,
and the figures."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from ptbatch.compare.entry import FAIL, Line
from ptbatch.compare.gallery import Picture
from ptbatch.compare.report import counts, number
from ptbatch.errors import WriteError

_HEAD = ("quantity", "ours", "theirs", "ratio", "tolerance", "verdict", "class")
_RULE = ("---", "--:", "--:", "--:", "---", "---", "---")


def write_markdown(
    path: Path, lines: Sequence[Line], pictures: Sequence[Picture], results: Path, published: Path
) -> None:
    """Write the report; its numbers to seven digits, no date and no machine. Raises WriteError."""
    command = f"ptbatch compare {results.name} {published.name} --markdown {path.name}"
    try:
        path.write_text("\n".join(_report(lines, pictures, command)) + "\n", encoding="utf-8")
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error


def _report(lines: Sequence[Line], pictures: Sequence[Picture], command: str) -> Iterator[str]:
    told = ", ".join(f"{count} {verdict}" for verdict, count in counts(lines).items())
    yield from ("# Verification", "")
    yield f"Written by `{command}`. {len(lines)} entries: {told}."
    yield "The ratio is ours over theirs; of two tolerances the larger counts."
    cases = [line.case for line in lines] + [picture.figure.case for picture in pictures]
    for case in dict.fromkeys(cases):
        yield from ("", f"## {_text(case)}")
        yield from _table([line for line in lines if line.case == case])
        for figure, file in pictures:
            if figure.case == case:
                yield from ("", f"![{_text(figure.name)}]({file})", "", f"*{_text(figure.caption)}*")


def _table(lines: Sequence[Line]) -> Iterator[str]:
    """Table, then remarks by row."""
    if not lines:
        return
    several = len({line.member for line in lines}) > 1
    yield ""
    yield _row(("row", *(["member"] if several else []), *_HEAD))
    yield _row(("--:", *(["---"] if several else []), *_RULE), plain=True)
    for i, line in enumerate(lines, 1):
        yield _row((str(i), *([line.member] if several else []), *_cells(line)))
    yield ""
    reasons = [f"{line.verdict}, because {line.because}" if line.because else "" for line in lines]
    yield from _remarks("", reasons)
    yield from _remarks("", [line.note for line in lines])
    yield from _remarks("from ", [line.source for line in lines])


def _cells(line: Line) -> tuple[str, ...]:
    what = f"{line.what} [{line.unit}]" if line.unit else line.what
    ratio = "-" if line.ratio is None else f"{line.ratio:.4f}"
    verdict = line.verdict.upper() if line.verdict == FAIL else line.verdict
    return what, number(line.ours), number(line.theirs), ratio, line.tolerance, verdict, line.kind


def _remarks(lead: str, texts: Sequence[str]) -> Iterator[str]:
    """Each text once, with the rows that it is about."""
    about: dict[str, list[int]] = {}
    for i, text in enumerate(texts, 1):
        if text:
            about.setdefault(text, []).append(i)
    for text, rows in about.items():
        yield f"- {_ranges(rows)}: {lead}{_text(text)}"


def _ranges(rows: Sequence[int]) -> str:
    """`1-4, 7` for rising numbers."""
    runs: list[list[int]] = []
    for row in rows:
        if runs and row == runs[-1][-1] + 1:
            runs[-1].append(row)
        else:
            runs.append([row])
    return ", ".join(f"{run[0]}-{run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)


def _row(cells: Sequence[str], plain: bool = False) -> str:
    return f"| {' | '.join(cell if plain else _text(cell) for cell in cells)} |"


def _text(text: str) -> str:
    """Text that ends no cell and opens no markup."""
    for sign in "\\|<`*":
        text = text.replace(sign, f"\\{sign}")
    return " ".join(text.split())
