"""The member's loads as point and line loads along x: self-weight, sustained, and the live pattern at its
service value."""

from ptbatch.geometry.section import gross_section
from ptbatch.member import Load, Member

UNIT_LINE, UNIT_POINT = 1.0, 1000.0  # N/mm, N: the size of a pattern that was given no service value


def self_weight(member: Member) -> list[Load]:
    """Own weight along the whole member."""
    value = member.density * gross_section(member).area if member.self_weight else 0.0
    return [Load("dead", "uniform", 0.0, member.total_length, value)] if value else []


def sustained(member: Member) -> list[Load]:
    """w_dead and the dead rows of the load table."""
    uniform = [Load("dead", "uniform", 0.0, member.total_length, member.w_dead)] if member.w_dead else []
    return uniform + [load for load in member.loads if load.case == "dead"]


def live(member: Member) -> list[Load]:
    """The live pattern; of unit size where no service value was given."""
    if member.live == "loads":
        return [load for load in member.loads if load.case == "live"]
    spans = [(member.support_x[i - 1], member.span[i - 1]) for i in member.live_spans]
    if member.live == "uniform":
        w = member.w_live or UNIT_LINE
        return [Load("live", "uniform", x, x + span, w) for x, span in spans]
    P = member.P_live or UNIT_POINT
    shares = {"midspan": (1 / 2,), "third-points": (1 / 3, 2 / 3)}[member.live]
    places = [x + share * span for x, span in spans for share in shares]
    return [Load("live", "point", x, x, P / len(shares)) for x in places]


def has_service_value(member: Member) -> bool:
    """Whether load factor 1 means anything."""
    return member.live == "loads" or bool(member.w_live if member.live == "uniform" else member.P_live)


def total(loads: list[Load]) -> float:
    """Sum of downward loads in N."""
    return sum(load.value * (1.0 if load.type == "point" else load.x_end - load.x) for load in loads)


def by_span(member: Member, loads: list[Load]) -> list[list[Load]]:
    """Loads of each span, cut at its supports; a point load on a support counts with the span left of it."""
    ends = list(zip(member.support_x, member.support_x[1:], strict=False))
    parts: list[list[Load]] = [[] for _ in ends]
    for load in loads:
        for part, (a, b) in zip(parts, ends, strict=True):
            if load.type == "point":
                if a < load.x <= b or load.x == a == 0.0:
                    part.append(load)
            elif min(load.x_end, b) > max(load.x, a):
                part.append(load._replace(x=max(load.x, a), x_end=min(load.x_end, b)))
    return parts
