"""Parameters of the material laws from a member's columns."""

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
from ptbatch.roots import root

CONCRETE_LAWS = {
    "hognestad": HOGNESTAD,
    "parabola-rectangle": PARABOLA_RECTANGLE,
    "popovics": POPOVICS,
    "elastic": ELASTIC,
}
TENSION_LAWS = {"none": NO_TENSION, "softening": SOFTENING, "stiffening": STIFFENING}
TENDON_LAWS = {"ramberg-osgood": RAMBERG_OSGOOD, "bilinear": BILINEAR, "elastic": ELASTIC_TENDON}


def concrete(member: Member) -> Concrete:
    """Concrete of a member; the tension branch runs to ft with Ec."""
    eps_c, exponent = _peak(member)
    eps_cr = member.ft / member.Ec
    tension_law = TENSION_LAWS[member.tension_law] if member.ft > 0.0 else NO_TENSION
    return Concrete(
        CONCRETE_LAWS[member.concrete_law],
        member.fc,
        member.Ec,
        exponent * member.fc / eps_c if member.concrete_law == "parabola-rectangle" else member.Ec,
        eps_c,
        exponent,
        member.crushing_strain,
        tension_law,
        member.ft,
        eps_cr,
        member.tension_end * eps_cr,
    )


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

        R = root(miss, 1.0, 400.0) if miss(1.0) < 0.0 < miss(400.0) else 100.0
    return Strand(
        member.Aps,
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
    return 100.0 * member.Ep * member.Aps / element
