"""Figures beside a report, as links in it."""

from collections.abc import Iterable
from pathlib import Path

FOLDER = "figures"


def image_links(names: Iterable[str], report: Path) -> list[str]:
    """Markdown images of the figures by these names that lie in the folder `figures` beside the report."""
    files = {name: f"{FOLDER}/{name}.png" for name in names}
    return [f"![{name}]({file})" for name, file in files.items() if (report.parent / file).is_file()]
