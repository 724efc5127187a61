"""What a figure of a member needs and the results do not have, in words."""

from ptbatch.response import ANCHORED, END, JACKED, PEAK
from ptbatch.workbook.stored import Stored

ON_A_PAGE = ("stress", "redistribution", "load-deflection", "cracks")


def reason(stored: Stored) -> str:
    """Why something is missing: the status of the member and its message."""
    status, message = (str(stored.summary.get(name) or "") for name in ("status", "message"))
    return f"{status}: {message}" if message else status


def missing(stored: Stored, figure: str) -> str:
    """What a figure lacks, `all` standing for the page of a member: '' if nothing does."""
    if stored.member is None:
        return "the member itself"
    if figure == "all":
        return ", ".join(dict.fromkeys(filter(None, (missing(stored, kind) for kind in ON_A_PAGE))))
    stages = {row["stage"] for row in stored.tendon.rows}
    if figure == "stress":
        return " and ".join(f"the tendon {name}" for name in (JACKED, ANCHORED) if name not in stages)
    if figure == "redistribution":
        return "" if {PEAK, END} & stages else "the tendon under live load"
    if figure in ("load-deflection", "cracks"):
        return "" if len(stored.curves) else "the live load"
    return ""


def lack(stored: Stored, what: str) -> str:
    """That something is missing, and why."""
    return f"{stored.name} lacks {what}; {reason(stored)}"
