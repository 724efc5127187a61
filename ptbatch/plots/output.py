"""Where figures are written to, and writing them: files that are whole or not there at all."""

import os
import re
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure

from ptbatch.errors import OutputNameError, WriteError
from ptbatch.plots import style

FORMATS = (".png", ".pdf", ".svg")
LONGEST = 80  # letters of a member's name, or of several, in the name of a file
UNDATED: dict[str, Any] = {  # the same results make the same file
    ".png": {"Software": None},
    ".pdf": {"CreationDate": None, "Producer": None},
    ".svg": {"Date": None},
}


def target(source: Path, names: Sequence[str], figure: str, output: Path | None) -> Path:
    """File for a figure of these members: the one asked for, or `beams.B1.stress.png` in the folder asked
    for, by default that of the workbook.

    Raises OutputNameError if the file is of no known format, WriteError if there is no such folder.
    """
    stem = source.name.removesuffix(".xlsx").removesuffix(".results")
    kind = "" if figure == "all" else f".{figure}"
    usual = f"{stem}.{_plain('+'.join(names))}{kind}.png"
    if output is None:
        return _in_folder(source.with_name(usual))
    if output.is_dir():
        return _in_folder(output / usual)
    if output.suffix.lower() not in FORMATS:
        raise OutputNameError(f"{output} is neither a folder nor a file that ends in {', '.join(FORMATS)}")
    return _in_folder(output)


def _plain(name: str) -> str:
    """A name that every file system takes."""
    return re.sub(r"[^\w.+-]+", "_", name).strip("._")[:LONGEST] or "member"


def _in_folder(path: Path) -> Path:
    if not path.parent.is_dir():
        raise WriteError(f"{path} cannot be written: there is no folder {path.parent}")
    return path


def save(figures: Sequence[Figure], path: Path) -> Path:
    """Write a figure, or several as the pages of a PDF, in place of an older file. Raises WriteError."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        _write(figures, temporary, path.suffix.lower())
        os.replace(temporary, path)
    except OSError as error:
        raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
    finally:
        temporary.unlink(missing_ok=True)
    return path


def _write(figures: Sequence[Figure], path: Path, suffix: str) -> None:
    with rc_context(style.RC), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font")  # a name has it, and it is a box
        if suffix == ".pdf":
            with PdfPages(path, metadata=UNDATED[suffix]) as pages:
                for figure in figures:
                    figure.savefig(pages, format="pdf")
        else:
            (figure,) = figures
            figure.savefig(path, format=suffix[1:], metadata=UNDATED[suffix])
