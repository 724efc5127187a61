"""Rows of the template: one member of each kind, typed as an office would in SI and in US units."""

from typing import Any, NamedTuple

from ptbatch.workbook.column import System

Pair = tuple[Any, Any]  # the same value, more or less, in the SI and in the US unit of the column
Values = dict[str, Pair | str]


class Starter(NamedTuple):
    """A row by column; a text stands for both systems."""

    sheet: str
    values: Values

    def of(self, column: str, system: System) -> Any:
        """Value of a column, None where it is left blank."""
        value = self.values.get(column)
        return value[system == "US"] if isinstance(value, tuple) else value


_STRAND: Values = {"fpj": (1395, 202.5)}
_C40: Values = {"fc": (40, 6)}

_SIMPLE: Values = {
    **{"member": "Simple beam", "span": (12000, 40), "b": (300, 12), "h": (600, 24), **_C40, **_STRAND},
    **{"Aps": (592, 0.918), "dp": ("300; 500; 300", "12; 20; 12")},
    **{"As": (603, 0.93), "ds": (550, 22), "w_dead": (5, 0.35), "w_live": (10, 0.7)},
    "note": "Unbonded parabola, jacked at its left end. What is left blank has its default.",
}
_STRIP: Values = {
    **{"member": "Slab strip", "kind": "slab", "span": ("8000; 9000; 8000", "26; 30; 26")},
    **{"b": (1000, 12), "h": (200, 8), "fc": (32, 5), "Aps": (300, 0.153), **_STRAND, "jack": "both"},
    "dp": ("100; 160; 40; 160; 40; 160; 100", "4; 6.75; 1.25; 6.75; 1.25; 6.75; 4"),
    **{"As": (393, 0.2), "ds": (170, 6.75), "w_dead": (1.5, 0.02), "w_live": (3, 0.04)},
    "note": "Three spans, jacked at both ends. Its bars over the columns are in the sheet rebar.",
}
_GROUTED: Values = {
    **{"member": "Grouted beam", "span": (15000, 50), "b": (400, 16), "h": (800, 32), **_C40, **_STRAND},
    **{"Aps": (1500, 2.3), "mu": (0.19, 0.19), "k_ec2": (0.01, 0.003), "bond": "bonded"},
    **{"As": (1018, 1.58), "ds": (740, 29), "w_dead": (15, 1), "w_live": (20, 1.4)},
    "note": "Bonded. Its tendon is in the sheet profile, point by point, in place of dp.",
}
_HARPED: Values = {
    **{"member": "Harped, two spans", "span": ("12000; 12000", "40; 40"), "support_right": "roller"},
    **{"b": (350, 14), "h": (700, 28), **_C40, **_STRAND, "Aps": (888, 1.377), "profile": "harped"},
    **{"dp": ("350; 600; 120; 600; 350", "14; 24; 5; 24; 14"), "harp": ("1/3; 2/3", "1/3; 2/3")},
    **{"As": (804, 1.24), "ds": (640, 25.5), "As_top": (804, 1.24), "ds_top": (60, 2.5)},
    **{"w_dead": (5, 0.35), "live": "loads"},
    "note": "Straight between its harping points. Its live loads are in the sheet loads.",
}
_TEE: Values = {
    **{"member": "Tee", "span": (16000, 52), "shape": "tee", "b": (1200, 48), "h": (900, 36)},
    **{"bw": (400, 16), "hf": (150, 6), **_C40, "Aps": (1680, 2.604), **_STRAND},
    **{"dp": ("330; 780; 330", "13; 31; 13"), "As": (1257, 1.76), "ds": (840, 33.5)},
    **{"w_dead": (20, 1.4), "w_live": (25, 1.7)},
    "note": "b and h are the overall width and depth; bw and hf the web and the flange.",
}


def _profile(x: Pair, dp: Pair, note: str = "") -> Starter:
    return Starter("profile", {"member": "Grouted beam", "x": x, "dp": dp, "note": note or (None, None)})


def _bars(start: Pair, end: Pair, note: str = "") -> Starter:
    place: Values = {"member": "Slab strip", "x_start": start, "x_end": end, "depth": (30, 1.25)}
    return Starter("rebar", place | {"area": (565, 0.31), "note": note or (None, None)})


def _live(x: Pair, note: str = "") -> Starter:
    load: Values = {"member": "Harped, two spans", "case": "live", "type": "point", "x": x}
    return Starter("loads", load | {"value": (60, 13), "note": note or (None, None)})


STARTERS = (
    *(Starter("members", row) for row in (_SIMPLE, _STRIP, _GROUTED, _HARPED, _TEE)),
    _profile((0, 0), (400, 16), "From the left end to the right one; up to the next support it is a spline."),
    _profile((3750, 150), (610, 24.5)),
    _profile((7500, 300), (680, 27)),
    _profile((11250, 450), (610, 24.5)),
    _profile((15000, 600), (400, 16)),
    _bars((6500, 258), (9500, 366), "Top bars over the second support, besides As and As_top."),
    _bars((15500, 618), (18500, 726), "Over the third one."),
    _live((4000, 160), "Service value; the analysis scales all live loads together."),
    _live((8000, 320)),
    _live((16000, 640)),
    _live((20000, 800)),
    Starter("settings", {"name": "units", "value": ("SI", "US"), "note": "Of headers that name no unit."}),
    Starter(
        "settings",
        {
            "name": ("density [kN/m3]", "density [pcf]"),
            "value": (25, 150),
            "note": "A column of the sheet members: what its blank cells hold in this workbook.",
        },
    ),
)
