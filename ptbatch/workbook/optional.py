"""Columns of the optional sheets, which are joined to the members by name, and of the settings."""

from ptbatch.workbook.column import Column

MEMBER = Column("member", "name in the sheet members", "text", required=True)

PROFILE = (
    MEMBER,
    Column("x", "from the left end", quantity="length", limit="not negative", required=True),
    Column("dp", "depth of the tendon below the top fibre", quantity="length", required=True),
)

REBAR = (
    MEMBER,
    Column("x_start", "left end of the bars", quantity="length", limit="not negative", default=0.0),
    Column("x_end", "right end of the bars", quantity="length"),
    Column("depth", "depth below the top fibre", quantity="length", required=True),
    Column("area", "area of the bars", quantity="area", required=True),
    Column("fy", "yield stress", quantity="stress"),
)

LOADS = (
    MEMBER,
    Column("case", "dead or live", "choice", required=True, choices=("dead", "live")),
    Column("type", "point or uniform", "choice", required=True, choices=("point", "uniform")),
    Column("x", "place of a point load, left end of a uniform one", quantity="length", limit="not negative"),
    Column("x_end", "right end of a uniform load", quantity="length"),
    Column("value", "load, down positive", quantity="force or line load", limit="any", required=True),
)

SETTINGS = (
    Column("name", "a column of the sheet members, or units", "text", required=True),
    Column("value", "its default in this workbook; SI or US for units", "text", required=True),
)

MAIN = "members"  # the sheet that they are joined to
OPTIONAL_SHEETS = {"profile": PROFILE, "rebar": REBAR, "loads": LOADS}
