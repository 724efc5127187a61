"""A comparison as a report in Markdown: case by case our number, theirs, the verdict and where it is from."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from ptbatch.compare.entry import FAIL, Line
from ptbatch.compare.figures import image_links
from ptbatch.compare.report import counts, number
from ptbatch.errors import WriteError

_HEAD = ("quantity", "ours", "theirs", "ratio", "tolerance", "verdict", "class")
_RULE = ("---", "--:", "--:", "--:", "---", "---", "---")


def write_markdown(path: Path, lines: Sequence[Line], results: Path, published: Path) -> None:
    """Write the report; its numbers to seven digits, no date and no machine. Raises WriteError."""
    text = "\n".join(_report(lines, path, f"ptbatch compare {results.name} {published.name}"))
    try:
        path.write_text(text + "\n", encoding="utf-8")
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error


def _report(lines: Sequence[Line], path: Path, command: str) -> Iterator[str]:
    told = ", ".join(f"{count} {verdict}" for verdict, count in counts(lines).items())
    yield from ("# Verification", "")
    yield f"Written by `{command} --markdown {path.name}`. {len(lines)} entries: {told}."
    yield "Tolerances: the larger of the two where there are two. The ratio is ours over theirs."
    for case in dict.fromkeys(line.case for line in lines):
        yield from _case(case, [line for line in lines if line.case == case], path)


def _case(case: str, lines: Sequence[Line], path: Path) -> Iterator[str]:
    """Heading, table, remarks, sources, figures."""
    yield from ("", f"## {case}", "")
    numbers = _numbers(lines)
    several = len({line.member for line in lines}) > 1
    head, rule = (("member", *_HEAD), ("---", *_RULE)) if several else (_HEAD, _RULE)
    yield from (_row((*head, "source")), _row((*rule, "--:")))
    for line in lines:
        yield _row(((line.member,) if several else ()) + (*_cells(line), str(numbers[line.source])))
    yield from _remarks(lines)
    yield from ("", *(f"{i}. {_text(source)}" for source, i in numbers.items()))
    figures = dict.fromkeys(name for line in lines for name in line.figures)
    for link in image_links(figures, path):
        yield from ("", link)


def _numbers(lines: Sequence[Line]) -> dict[str, int]:
    """Number of each source of a case."""
    return {source: i for i, source in enumerate(dict.fromkeys(line.source for line in lines), 1)}


def _cells(line: Line) -> tuple[str, ...]:
    what = f"{line.what} [{line.unit}]" if line.unit else line.what
    ratio = "-" if line.ratio is None else f"{line.ratio:.4f}"
    verdict = f"**{line.verdict}**" if line.verdict == FAIL else line.verdict
    return what, number(line.ours), number(line.theirs), ratio, line.tolerance, verdict, line.kind


def _remarks(lines: Sequence[Line]) -> Iterator[str]:
    """Reasons and notes, each once with the quantities that it is about."""
    about: dict[str, list[str]] = {}
    for line in lines:
        because = f"{line.verdict}, because {line.because}" if line.because else ""
        for text in (because, line.note):
            if text:
                about.setdefault(text, []).append(line.what)
    if about:
        yield ""
    for text, whats in about.items():
        yield f"- {', '.join(dict.fromkeys(whats))}: {_text(text)}"


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(_text(cell) for cell in cells)} |"


def _text(text: str) -> str:
    """Text that ends no cell and opens no markup."""
    for sign in "\\|<`_[":
        text = text.replace(sign, f"\\{sign}")
    return " ".join(text.split())
