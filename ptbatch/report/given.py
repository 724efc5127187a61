"""What was analysed: the values of a member with their units, as the echo in the results has them."""

from typing import Any, NamedTuple

from ptbatch.along import Bar, Load
from ptbatch.member import Member
from ptbatch.report.words import Words, digits
from ptbatch.workbook.column import LISTS, Column, System
from ptbatch.workbook.columns import BY_NAME
from ptbatch.workbook.units import factor

GROUPS = {
    "Member": ("kind", "span", "support_left", "support_right", "density", "self_weight"),
    "Section": ("shape", "b", "h", "bw", "hf", "b_bottom", "hf_bottom"),
    "Concrete": ("fc", "ft", "Ec", "concrete_law", "crushing_strain", "tension_law", "tension_end"),
    "Tendon": (
        *("Aps", "n_strands", "n_strands_lost", "fpu", "fpy", "Ep", "tendon_law", "epu", "bond", "profile"),
        *("dp", "harp", "inflection"),
    ),
    "Stressing": ("fpj", "fpe", "jack", "set", "mu", "K", "wobble"),
    "Bars": ("As", "ds", "As_top", "ds_top", "fy", "Es", "hardening", "esu"),
    "Loads": ("w_dead", "live", "w_live", "P_live", "live_spans", "deflection_limit"),
    "Time": (
        *("long_term_loss", "RH", "V_S", "age_stressing", "relaxation", "cement", "design_life"),
        "live_sustained",
    ),
    "Checks": (
        *("standard", "fci", "service_class", "exposure", "cover", "duct", "Av", "s", "fyt"),
        *("bar_diameter", "live_frequent", "deflection_live", "deflection_total"),
        *("factor_dead", "factor_live"),
    ),
    "Mesh": ("elements", "layers"),
}
ONLY_WHERE = {"harp": "harped", "inflection": "parabola"}  # columns that one profile alone uses
BY_EN = ("cement", "design_life", "bar_diameter", "live_frequent")
BY_ACI = ("service_class", "deflection_live")
MOST = 9  # rows of an optional sheet
STEEL = ("fy", "Es", "hardening", "esu")


class Given(NamedTuple):
    """A value: its column, the value in words, its unit."""

    name: str
    value: str
    unit: str


def given(member: Member, system: System) -> dict[str, list[Given]]:
    """Values by group; those that this member has no use for are left out."""
    words = Words(system)
    groups = {title: [_given(member, BY_NAME[name], system) for name in names if _used(member, name)]
              for title, names in GROUPS.items()}  # fmt: skip
    points = [f"{words.digits(x, 'mm')}; {words.digits(dp, 'mm')}" for x, dp in member.profile_points]
    groups["Tendon"] += _some([Given("x; dp", point, words.unit("mm")) for point in points], "profile")
    groups["Bars"] += _some([Given("bars", _bar(bar, words), "") for bar in member.bars], "rebar")
    groups["Loads"] += _some([Given(load.case, _load(load, words), "") for load in member.loads], "loads")
    return {title: values for title, values in groups.items() if values}


def _some(rows: list[Given], sheet: str) -> list[Given]:
    """Rows of an optional sheet; of many the first and the last, and where all of them are."""
    if len(rows) <= MOST:
        return rows
    between = Given("...", f"{len(rows) - MOST + 1} more in the sheet {sheet}", "")
    return [*rows[: MOST - 2], between, rows[-1]]


def _used(member: Member, name: str) -> bool:
    if getattr(member, name) in (None, ()):
        return False
    if name in GROUPS["Time"] and member.long_term_loss is None and member.RH is None:
        return False
    if name in GROUPS["Checks"] and member.standard == "none":
        return False
    if name in BY_EN:
        return member.standard == "EN 1992-1-1"
    if name in BY_ACI:
        return member.standard != "EN 1992-1-1"
    if name == "fyt":
        return bool(member.Av)
    if name == "n_strands_lost":
        return member.n_strands_lost > 0
    if name in STEEL:
        return bool(member.all_bars)
    if name in ONLY_WHERE:
        return member.profile == ONLY_WHERE[name] and not member.profile_points
    return not (name == "profile" and member.profile_points)


def _given(member: Member, column: Column, system: System) -> Given:
    unit = column.unit(system)
    value = _value(column, getattr(member, column.name), unit)
    return Given(column.name, value, unit.replace("-", "").replace("2", "²").replace("3", "³"))


def _value(column: Column, value: Any, unit: str) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    numbers = value if column.kind in LISTS else [value]
    return "; ".join(digits(number / factor(column.quantity, unit)) for number in numbers)


def _bar(bar: Bar, words: Words) -> str:
    """`402 mm² at 550 mm, x = 0 to 6000 mm, fy = 420 MPa`."""
    x = f"x = {words.digits(bar.x_start, 'mm')} to {words.size(bar.x_end, 'mm')}"
    place = f"{words.size(bar.depth, 'mm')}, {x}"
    return f"{words.size(bar.area, 'mm2')} at {place}, fy = {words.size(bar.fy, 'MPa')}"


def _load(load: Load, words: Words) -> str:
    """`15 kN at x = 4000 mm`, `5 kN/m, x = 0 to 6000 mm`."""
    if load.type == "point":
        return f"{words.size(load.value / 1e3, 'kN')} at x = {words.size(load.x, 'mm')}"
    x = f"x = {words.digits(load.x, 'mm')} to {words.size(load.x_end, 'mm')}"
    return f"{words.size(load.value, 'kN/m')}, {x}"
