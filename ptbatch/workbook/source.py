"""A table of members wherever it comes from: its headers, and its rows some at a time."""

from collections.abc import Iterator
from dataclasses import dataclass

from ptbatch.errors import ReadError
from ptbatch.validation import closest
from ptbatch.workbook.columns import BY_NAME
from ptbatch.workbook.lazy import Blocks
from ptbatch.workbook.read import LAST_ROW, Block, RawSheet
from ptbatch.workbook.table import find_header
from ptbatch.workbook.units import parse_header

MOST_MEMBERS = LAST_ROW - 1  # the summary has a line for each of them
BLOCK = 1_000  # rows read at a time


@dataclass(frozen=True)
class Source:
    """A table. head: the sheet down to its headers, and perhaps beyond; blocks: the rows below them."""

    head: RawSheet
    header_row: int
    blocks: Blocks


def sheet_source(raw: RawSheet) -> Source:
    """A sheet that was read as a whole. Raises ReadError where it is no table of members."""
    header = find_header(raw, "member")
    if header is None:
        raise ReadError(no_header(raw))
    rows = {number: cells for number, cells in raw.rows.items() if number > header}

    def blocks() -> Iterator[Block]:
        yield rows

    return Source(raw, header, blocks)


def no_header(raw: RawSheet) -> str:
    """Why a sheet is no table of members."""
    if not raw.rows:
        return f"sheet {raw.name} is empty; `ptbatch template FILE` writes a workbook to start from"
    names = [parse_header(str(value)).name for value in next(iter(raw.rows.values())).values()]
    known = {name.casefold() for name in BY_NAME}
    strange = [name for name in names if name.casefold() not in known]
    close = next((name for name in strange if closest(name, ["member"])), None)
    cure = (
        f"did you mean member where it says {close}?" if close else "put the members on a sheet named members"
    )
    return f"sheet {raw.name} has no column member; {cure}"
