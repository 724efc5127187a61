"""The columns of a published table: sheet `published`, one row an expected number, and sheet `figures`."""

from ptbatch.response import ANCHORED, END, JACKED, PEAK, SET
from ptbatch.workbook.column import Column
from ptbatch.workbook.columns import NOTE

COLUMNS = (
    Column("case", "heading under which the report puts the entry; blank: the member", "text"),
    Column("member", "name in the results", "text", required=True),
    Column("quantity", "a header of summary, tendon or curves, or a measure of the cracks, with the unit of "
           "the value", "text", required=True),
    Column("stage", "tendon, cracks: stage", "choice", choices=(JACKED, SET, ANCHORED, PEAK, END)),
    Column("x", "tendon: place, interpolated", quantity="length", limit="not negative"),
    Column("deflection", "curves: where the deflection first reaches this", quantity="length", limit="any"),
    Column("as", "value, or the ratio to or difference from another one", "choice", default="value",
           choices=("value", "ratio", "difference")),
    Column("against", "ratio, difference: the other member; blank: the same", "text"),
    Column("against_quantity", "the other quantity; blank: the same", "text"),
    Column("against_x", "the other place; blank: the same", quantity="length", limit="not negative"),
    Column("share_of", "difference: in % of this quantity of the other member", "text"),
    Column("bound", "equal within the tolerance, or no less or no more than the value", "choice",
           default="equal", choices=("equal", "at-least", "at-most")),
    Column("value", "expected number or text; blank where the source prints none", "text"),
    Column("rtol", "tolerance as a share of the value; the larger of rtol and atol counts",
           quantity="share", limit="not negative"),
    Column("atol", "tolerance in the unit of the value", limit="not negative"),
    Column("class", "what the number is", "choice", required=True,
           choices=("published", "closed-form", "frozen")),
    Column("source", "where it is printed, or how it is derived", "text", required=True),
    Column("not_reproducible", "why the number cannot be met, with evidence", "text"),
    NOTE,
)  # fmt: skip

FIGURES = (
    Column("figure", "name of its file, in the folder figures beside the report", "text", required=True),
    Column("kind", "one of those that `ptbatch plot` draws", "choice", required=True,
           choices=("stress", "redistribution", "load-deflection", "cracks", "profile")),
    Column("members", "names in the results, separated by ;", "text", required=True),
    Column("caption", "what it shows", "text", required=True),
    Column("case", "heading under which the report puts it; blank: the first member", "text"),
    NOTE,
)  # fmt: skip
