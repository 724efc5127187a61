"""What the site fills in beside the elongations: gauge and measured length, and formulas that judge them."""

from collections.abc import Sequence
from typing import Any

from openpyxl.utils import get_column_letter

from ptbatch.workbook.column import System
from ptbatch.workbook.results import ELONGATION
from ptbatch.workbook.stored_values import Formula
from ptbatch.workbook.systems import headers_in

SHEET = "elongation"
FILLED_IN = ("gauge", "measured [mm]", "deviation [%]", "verdict")


def site_headers(system: System) -> list[str]:
    """Headers of the sheet, those to be filled in last."""
    return headers_in((*ELONGATION, *FILLED_IN), system)


def site_columns(columns: Sequence[Sequence[Any]]) -> list[Sequence[Any]]:
    """The columns with room for what is measured, and formulas; `{row}` stands for their row."""
    after, least, most = (f"{_letter(name)}{{row}}" for name in ("after_set [mm]", "least [mm]", "most [mm]"))
    measured = f"{_letter('measured [mm]')}{{row}}"
    deviation = f'=IF({measured}="","",100*({measured}/{after}-1))'
    within = f'IF(AND({measured}>={least},{measured}<={most}),"OK","NG")'
    filled_in = None, None, Formula(deviation, ""), Formula(f'=IF({measured}="","",{within})', "")
    return [*columns, *([value] * len(columns[0]) for value in filled_in)]


def _letter(header: str) -> str:
    return get_column_letter((*ELONGATION, *FILLED_IN).index(header) + 1)
