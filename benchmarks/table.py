"""A titled table that prints as text and as Markdown."""

from dataclasses import dataclass, field


@dataclass
class Table:
    """Title, headers, rows of text, and a note below."""

    title: str
    headers: list[str]
    rows: list[list[str]] = field(default_factory=list)
    note: str = ""

    def add(self, *values: object) -> None:
        """A row; numbers are rounded to what is worth telling."""
        self.rows.append([_text(value) for value in values])

    def text(self) -> str:
        """For a terminal."""
        lines = [self.headers, *self.rows]
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        body = [
            "  ".join(
                cell.ljust(w) if i == 0 else cell.rjust(w)
                for i, (cell, w) in enumerate(zip(row, widths, strict=True))
            )
            for row in lines
        ]
        return "\n".join([self.title, *(line.rstrip() for line in body), *([self.note] if self.note else [])])

    def markdown(self) -> str:
        """For a document."""
        head = ["| " + " | ".join(self.headers) + " |", "|---" + "|---:" * (len(self.headers) - 1) + "|"]
        body = ["| " + " | ".join(row) + " |" for row in self.rows]
        return "\n".join([f"## {self.title}", "", *head, *body, *(["", self.note] if self.note else [])])


def _text(value: object) -> str:
    if not isinstance(value, float):
        return str(value)
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.1f}" if abs(value) >= 10 else f"{value:.2f}"
