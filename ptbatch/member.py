"""A member: everything that an analysis needs to know, complete and sound."""

from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any

from ptbatch.along import Bar as Bar
from ptbatch.along import Load as Load
from ptbatch.along import Point as Point
from ptbatch.rules.fault import Fault
from ptbatch.validation import examine, member_warnings


class MemberError(ValueError):
    """Values that make no member; `faults` lists all that is wrong with them."""

    def __init__(self, name: str, faults: list[Fault]) -> None:
        super().__init__("\n".join([f"member {name}:", *(f"  {fault}" for fault in faults)]))
        self.faults = faults


@dataclass(frozen=True, init=False)
class Member:
    """One member. Fields are the columns of the workbook in N, mm, MPa and radians.

    `Member(**values)` takes a number where a list of one is meant, fills in the defaults, and raises
    `MemberError` with every fault if something is wrong. It also takes `k_ec2` [rad/mm] in place of `K`.
    Only fpj, fpe, w_live, P_live and sizes that the shape does not have can be None.
    """

    member: str
    kind: str
    span: tuple[float, ...]
    support_left: str
    support_right: str
    shape: str
    b: float
    h: float
    bw: float | None
    hf: float | None
    b_bottom: float | None
    hf_bottom: float | None
    fc: float
    ft: float
    Ec: float
    concrete_law: str
    crushing_strain: float
    tension_law: str
    tension_end: float
    density: float  # N/mm3
    self_weight: bool
    Aps: float
    fpu: float
    fpy: float
    Ep: float
    tendon_law: str
    epu: float
    profile: str
    dp: tuple[float, ...]  # empty where profile_points gives the tendon
    harp: tuple[float, ...]
    inflection: float
    fpj: float | None
    fpe: float | None
    jack: str
    set: float
    mu: float
    K: float  # 1/mm
    wobble: str
    sheathing: str
    correction: bool
    bond: str
    As: tuple[float, ...]
    ds: tuple[float, ...]
    As_top: tuple[float, ...]
    ds_top: tuple[float, ...]
    fy: float
    Es: float
    hardening: float
    esu: float
    w_dead: float  # N/mm
    live: str
    w_live: float | None  # N/mm
    P_live: float | None  # N
    live_spans: tuple[int, ...]  # 1 = left
    n_strands: int | None
    n_strands_lost: int
    standard: str
    fci: float | None
    long_term_loss: float | None
    RH: float | None  # %
    V_S: float | None
    age_stressing: float  # days
    Av: float | None
    s: float | None
    fyt: float
    service_class: str
    exposure: str
    cover: float | None
    duct: float | None
    bar_diameter: float
    live_frequent: float
    deflection_live: float
    deflection_total: float
    factor_dead: float | None
    factor_live: float | None
    cement: str
    relaxation: str
    design_life: float  # years
    live_sustained: float
    deflection_limit: float
    elements: int
    layers: int
    profile_points: tuple[Point, ...]
    bars: tuple[Bar, ...]
    loads: tuple[Load, ...]

    def __init__(self, **values: Any) -> None:
        complete, faults = examine(values)
        if faults:
            raise MemberError(str(values.get("member")), faults)
        del complete["k_ec2"]
        self.__dict__.update(complete)

    @cached_property
    def support_x(self) -> tuple[float, ...]:
        """x of the ends of all spans [mm], both ends of the member included."""
        return (0.0, *accumulate(self.span))

    @cached_property
    def intact_area(self) -> float:
        """Area of the tendon without the strands that are lost [mm2]."""
        whole = self.n_strands or 1
        return self.Aps * (whole - self.n_strands_lost) / whole

    @cached_property
    def all_bars(self) -> tuple[Bar, ...]:
        """Bars of the columns As and As_top, which run through, and of the sheet `rebar`."""
        own = [*zip(self.As, self.ds, strict=False), *zip(self.As_top, self.ds_top, strict=False)]
        through = (Bar(0.0, self.total_length, depth, area, self.fy) for area, depth in own if area > 0.0)
        return (*through, *self.bars)

    @property
    def supports(self) -> tuple[str, ...]:
        """Kind of every support. Interior ones are rollers; where no end holds the member lengthwise, the
        first of them is a pin."""
        kinds = [self.support_left, *["roller"] * (len(self.span) - 1), self.support_right]
        if not {"pin", "fixed"} & {kinds[0], kinds[-1]} and len(kinds) > 2:
            kinds[1] = "pin"
        return tuple(kinds)

    @property
    def total_length(self) -> float:
        """Sum of the spans [mm]."""
        return self.support_x[-1]

    @property
    def warnings(self) -> list[Fault]:
        """What is allowed but probably not meant."""
        return member_warnings(vars(self))
