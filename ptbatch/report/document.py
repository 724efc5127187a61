"""From results to one HTML file."""

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from ptbatch import __version__
from ptbatch.errors import OutputNameError, WriteError
from ptbatch.report.chapter import Chapter, chapter, lacking
from ptbatch.report.overview import counts, line
from ptbatch.report.source import Source, read_source
from ptbatch.report.words import Words
from ptbatch.workbook.stored import Stored, read_all, read_stored

Progress = Callable[[int, int, str], None]  # done, in total, name of the member

HERE = Path(__file__).parent
SUFFIXES = (".html", ".htm")


@dataclass(frozen=True)
class Reported:
    """The file written, and what it does not have and why."""

    path: Path
    lacking: list[str]


def write_report(
    results: Path,
    members: Sequence[str] = (),
    output: Path | None = None,
    progress: Progress | None = None,
) -> Reported:
    """Write a report on members of a results workbook, on all if none is named.

    output: an .html file, or a folder; `beams.report.html` beside the results if None. progress: called after
    each member. The same results make the same report. Raises ReadError, UnknownMemberError, OutputNameError,
    WriteError.
    """
    path = _target(results, output)
    stored = read_stored(results, list(dict.fromkeys(members))) if members else read_all(results)
    source = read_source(results)
    content = _content(results.name, stored, source)
    content["chapters"] = _chapters(stored, source, progress)  # made when they are written: no two are held
    _write(path, content)
    return Reported(path, [text for one in stored if (text := lacking(one))])


def _target(results: Path, output: Path | None) -> Path:
    stem = results.name.removesuffix(".xlsx").removesuffix(".results")
    usual = f"{stem}.report.html"
    path = results.with_name(usual) if output is None else output / usual if output.is_dir() else output
    if path.suffix.lower() not in SUFFIXES:
        raise OutputNameError(f"{output} is neither a folder nor a file that ends in {', '.join(SUFFIXES)}")
    if not path.parent.is_dir():
        raise WriteError(f"{path} cannot be written: there is no folder {path.parent}")
    return path


def _write(path: Path, content: dict[str, Any]) -> None:
    """Write the page, chapter by chapter, in place of an older one."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        with temporary.open("w", encoding="utf-8", newline="\n") as file:
            file.writelines(_template().generate(content))
        os.replace(temporary, path)
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
    finally:
        temporary.unlink(missing_ok=True)


def _content(name: str, several: Sequence[Stored], source: Source) -> dict[str, Any]:
    """What the template shows before the chapters."""
    lines = [line(stored, f"m{i}") for i, stored in enumerate(several, 1)]
    return {
        "results": name,
        "version": __version__,
        "css": Markup((HERE / "report.css").read_text("utf-8")),
        "about": source.about(),
        "rows": source.run.get("rows"),
        "unit": Words(several[0].system if several else "SI").unit,
        "lines": lines,
        "counts": dict(counts(lines)),
    }


def _chapters(several: Sequence[Stored], source: Source, progress: Progress | None) -> Iterator[Chapter]:
    """One member after the other."""
    for i, stored in enumerate(several, 1):
        yield chapter(stored, f"m{i}", source)
        if progress:
            progress(i, len(several), stored.name)


def _template() -> Any:
    """Everything that goes into the page is escaped, but for what is Markup: style and figures."""
    environment = Environment(
        loader=FileSystemLoader(HERE), autoescape=True, undefined=StrictUndefined, trim_blocks=True,
        lstrip_blocks=True,
    )  # fmt: skip
    return environment.get_template("report.html")
