"""A results workbook of one made-up member, and rows of published tables about it."""

from pathlib import Path

from openpyxl import Workbook

ROW = {"member": "B1", "quantity": "load_peak [kN]", "value": 200, "class": "frozen", "source": "made up"}


def write(path: Path, **sheets) -> Path:
    """Write sheets of rows by header."""
    book = Workbook()
    book.remove(book.active)
    for title, rows in sheets.items():
        page = book.create_sheet(title)
        headers = list(dict.fromkeys(header for row in rows for header in row))
        page.append(headers)
        for row in rows:
            page.append([row.get(header) for header in headers])
    book.save(path)
    return path


def summary(**values) -> dict:
    """A row of the summary."""
    row = {"member": "B1", "status": "ok", "message": None, "load_peak [kN]": 200.0, "failure": "bar rupture"}
    row |= {"loss_fixed_end_fe [%]": 4.0, "loss_fixed_end_analytic [%]": 5.0, "camber_anchored [mm]": 0.0}
    return row | {"newton_iterations": 99, "time [ms]": 12.5} | values


TENDON = [
    {
        "member": "B1",
        "stage": stage,
        "x [mm]": x,
        "stress_fe [MPa]": stress,
        "stress_analytic [MPa]": analytic,
    }
    for stage, x, stress, analytic in (
        ("jacked", 0, 1400.0, 1400.0),
        ("jacked", 1000, 1390.0, 1389.0),
        ("jacked", 2000, 1370.0, 1378.0),
        ("peak", 0, 1500.0, ""),
        ("peak", 2000, 1600.0, ""),
    )
]
CURVES = [
    {
        "member": "B1",
        "step": i,
        "load [kN]": load,
        "deflection [mm]": deflection,
        "event": "" if i else "peak",
    }
    for i, (load, deflection) in enumerate([(0, 0), (100, 10), (80, 9), (200, 30)])
]
CRACKS = [
    {"member": "B1", "stage": "end", "step": 3, "x [mm]": x, "crack_from [mm]": top, "crack_to [mm]": bottom}
    for x, top, bottom in ((500, 400, 500), (500, 0, 50), (900, 200, 500))
]
