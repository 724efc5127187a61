"""Workbooks of light rows: members of 8 elements and 10 layers, no two alike."""

from pathlib import Path

from openpyxl import Workbook

LIGHT = {
    "span": 8000, "b": 300, "h": 500, "fc": 35, "Aps": 400, "dp": "250; 420; 250", "fpj": 1395,
    "As": 400, "ds": 460, "w_dead": 5, "elements": 8, "layers": 10,
}  # fmt: skip


def write_rows(path: Path, rows: int) -> None:
    """A workbook of that many rows."""
    book = Workbook(write_only=True)
    sheet = book.create_sheet("members")
    sheet.append(["member", *LIGHT, "w_live"])
    for row in range(rows):
        sheet.append([f"R{row:05d}", *LIGHT.values(), round(10.0 + 7.0 * row / rows, 4)])
    book.save(path)
