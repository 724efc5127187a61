"""Parameters of the material laws from a member's columns."""

from itertools import pairwise
from math import inf

from scipy.optimize import brentq

from ptbatch.core.concrete import (
    ELASTIC,
    HOGNESTAD,
    NO_TENSION,
    PARABOLA_RECTANGLE,
    POPOVICS,
    SOFTENING,
    STIFFENING,
    Concrete,
)
from ptbatch.core.steel import Steel
from ptbatch.core.tendon import BILINEAR, ELASTIC_TENDON, RAMBERG_OSGOOD, Strand
from ptbatch.member import Member

CONCRETE_LAWS = {
    "hognestad": HOGNESTAD,
    "parabola-rectangle": PARABOLA_RECTANGLE,
    "popovics": POPOVICS,
    "elastic": ELASTIC,
}
TENSION_LAWS = {"none": NO_TENSION, "softening": SOFTENING, "stiffening": STIFFENING}
# Where the tension branch bends after cracking: share of the way to `tension_end`, share of ft
AFTER_CRACKING = {SOFTENING: ((1.0, 0.0),), STIFFENING: ((1 / 36, 0.77), (1 / 3, 0.45), (1.0, 0.0))}
TENDON_LAWS = {"ramberg-osgood": RAMBERG_OSGOOD, "bilinear": BILINEAR, "elastic": ELASTIC_TENDON}

Parabola = tuple[float, float, float, float]
Line = tuple[float, float, float]


def concrete(member: Member) -> Concrete:
    """Concrete of a member; the tension branch runs to ft with Ec."""
    eps_c, exponent = _peak(member)
    eps_cr = member.ft / member.Ec
    tension_law = TENSION_LAWS[member.tension_law] if member.ft > 0.0 else NO_TENSION
    law = member.concrete_law
    return Concrete(
        CONCRETE_LAWS[law],
        member.fc,
        member.Ec,
        exponent * member.fc / eps_c if law == "parabola-rectangle" else member.Ec,
        eps_c,
        exponent,
        member.crushing_strain,
        tension_law,
        member.ft,
        eps_cr,
        member.tension_end * eps_cr,
        law == "popovics" or (law == "parabola-rectangle" and exponent != 2.0),
        _pressed(member, eps_c),
        _opened(member, tension_law, eps_cr),
    )


def _pressed(member: Member, eps_c: float) -> tuple[Parabola, Parabola, Parabola]:
    """Compression branch as pieces, see `Concrete`.

    Hognestad (1951): parabola to fc, straight to 0.85 fc at the crushing strain. EN 1992-1-1 (3.17) with n =
    2: parabola, then fc. Both hold what they have at the crushing strain.
    """
    fc, end = member.fc, member.crushing_strain
    if member.concrete_law == "elastic":
        straight = (inf, 0.0, member.Ec, 0.0)
        return straight, straight, straight
    rise = (min(eps_c, end), 0.0, 2.0 * fc / eps_c, -fc / eps_c**2)
    if member.concrete_law == "parabola-rectangle" or end <= eps_c:
        top = fc if end >= eps_c else fc * end / eps_c * (2.0 - end / eps_c)
        return rise, (inf, top, 0.0, 0.0), (inf, top, 0.0, 0.0)
    fall = 0.15 * fc / (end - eps_c)
    return rise, (end, fc + fall * eps_c, -fall, 0.0), (inf, 0.85 * fc, 0.0, 0.0)


def _opened(member: Member, tension_law: int, eps_cr: float) -> tuple[Line, Line, Line, Line]:
    """Tension branch as pieces, see `Concrete`.

    `softening`: straight from ft to zero at tension_end. `stiffening`: Nayal and Rasheed (2006) after Gilbert
    and Warner (1978), 0.8 ft just after cracking, 0.45 ft at 4 eps_cr, zero at 10 eps_cr, stretched to
    tension_end; the sudden drop to 0.8 ft is spread over the first quarter of eps_cr, so that stress is a
    function of strain.
    """
    ft, nothing = member.ft, (0.0, 0.0, 0.0)
    if member.concrete_law == "elastic":
        straight = (inf, 0.0, member.Ec)
        return straight, straight, straight, straight
    if tension_law == NO_TENSION:
        return nothing, nothing, nothing, nothing
    wide = (member.tension_end - 1.0) * eps_cr
    after = [(eps_cr + share * wide, level * ft) for share, level in AFTER_CRACKING[tension_law]]
    points = [(0.0, 0.0), (eps_cr, ft), *after]
    lines = [_line(*start, *end) for start, end in pairwise(points)]
    o, p, q, r = (lines + 2 * lines[-1:])[:4]
    return o, p, q, r


def _line(x1: float, y1: float, x2: float, y2: float) -> Line:
    """The straight piece between two points."""
    slope = (y2 - y1) / (x2 - x1)
    return x2, y1 - slope * x1, slope


def _peak(member: Member) -> tuple[float, float]:
    """Strain at fc and exponent of the law.

    hognestad: the parabola starts with Ec, so eps_c = 2 fc / Ec. parabola-rectangle: EN 1992-1-1 table 3.1.
    popovics: Collins and Mitchell (1991), n = 0.8 + fc / 17, eps_c = fc / Ec n / (n - 1).
    """
    if member.concrete_law == "parabola-rectangle":
        if member.fc <= 50.0:
            return 0.002, 2.0
        exponent = 1.4 + 23.4 * (0.9 - min(member.fc, 90.0) / 100.0) ** 4
        return 0.002 + 0.085e-3 * (member.fc - 50.0) ** 0.53, exponent
    if member.concrete_law == "popovics":
        n = 0.8 + member.fc / 17.0
        return member.fc / member.Ec * n / (n - 1.0), n
    return 2.0 * member.fc / member.Ec, 2.0


def steel(member: Member) -> Steel:
    """Bars of a member (their fy stands with each bar)."""
    return Steel(member.Es, member.hardening, member.esu)


def strand(member: Member) -> Strand:
    """Tendon of a member.

    ramberg-osgood: the modified form of Mattock (1979), Ep eps (Q + (1 - Q) / (1 + (Ep eps / 1.04
    fpy)^R)^(1/R)), which starts with Ep, reaches fpu at epu and, by the choice of R, fpy at 1 % strain (ASTM
    A416; at the strain 0.001 beyond fpy / Ep where that is more).
    """
    knee = 1.04 * member.fpy
    Q = (member.fpu - knee) / (member.Ep * member.epu - knee)
    R = 1.0
    if member.tendon_law == "ramberg-osgood":
        Q = max(Q, 0.0)
        elastic = member.Ep * max(0.01, member.fpy / member.Ep + 0.001)

        def miss(R: float) -> float:
            return elastic * (Q + (1.0 - Q) * (1.0 + (elastic / knee) ** R) ** (-1.0 / R)) - member.fpy

        R = float(brentq(miss, 1.0, 400.0)) if miss(1.0) < 0.0 < miss(400.0) else 100.0
    return Strand(
        member.intact_area,
        TENDON_LAWS[member.tendon_law],
        member.Ep,
        member.fpy,
        member.fpu,
        member.epu,
        Q,
        knee,
        R,
    )


def penalty(member: Member, element: float) -> float:
    """Contact stiffness in N/mm: a hundred times that of a tendon element of this length.

    Stiff enough that slip before friction is mobilised and the tendon's stand-off from the duct are microns;
    far from the round-off floor.
    """
    return 100.0 * member.Ep * member.intact_area / element
