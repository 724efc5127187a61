"""A row that is no sound member, as far as it can be looked at: a drawing may show what is wrong with it."""

from ptbatch.member import Member
from ptbatch.plots.pages import geometry_of
from ptbatch.validation import examine
from ptbatch.workbook.rows import Row


def sketch(row: Row) -> Member | None:
    """The row as a member that breaks rules, to be drawn and nothing else; None if too much is missing."""
    member = object.__new__(Member)  # past the rules
    vars(member).update(examine(row.values)[0])
    try:
        geometry_of(member)
    except (AttributeError, IndexError, TypeError, ValueError):  # whatever a faulty value does to the drawing
        return None
    return member
