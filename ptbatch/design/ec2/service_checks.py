"""The checks of stresses and deflections in service."""

from collections.abc import Iterator
from dataclasses import replace

from ptbatch.design.check import FAIL, REVIEW, Check, Value, at_most, unless
from ptbatch.design.deflections import elastic, worst
from ptbatch.design.ec2 import flexure
from ptbatch.design.ec2.crack_checks import tension
from ptbatch.design.longterm.ec2 import creep_coefficient, modulus
from ptbatch.design.stresses import enveloped
from ptbatch.design.subject import NO_TIME, Subject
from ptbatch.design.time_losses import YEAR, volume_to_surface
from ptbatch.response import ANCHORED

DRY = 50.0  # %, relative humidity where none is given


def in_service(subject: Subject) -> Iterator[Check]:
    """Stresses after all losses, of the uncracked concrete and of the tendon."""
    member, moments = subject.member, subject.moments
    dead = moments.dead + moments.secondary
    strength = (Value("fck", member.fc, "MPa"),)
    parts = (("quasi-permanent", member.live_sustained, 0.45, "3"), ("characteristic", 1.0, 0.60, "2"))
    doubt = "" if subject.timely else NO_TIME
    for name, share, factor, number in parts:
        stress, x = enveloped(subject, dead, share, subject.time_loss).compression
        clause, formula = f"EN 1992-1-1 7.2 ({number})", f"sigma,c <= {factor:.2f} fck"
        limit = factor * member.fc
        made = at_most(f"compression, {name}", clause, formula, strength, stress, limit, "MPa", x)
        more = "creep is not linear any more" if factor < 0.5 else "longitudinal cracks in XD, XF, XS"
        yield replace(made, outcome=REVIEW, reason=more) if made.outcome == FAIL else unless(made, doubt)
    most, limit = subject.response.tendon[ANCHORED].most - subject.time_loss, 0.75 * member.fpu
    formula, steel = "sigma,p <= 0.75 fpk", (Value("fpk", member.fpu, "MPa"),)
    yield at_most("tendon after losses", "EN 1992-1-1 7.2 (5)", formula, steel, most, limit, "MPa")


def deflections(subject: Subject) -> Iterator[Check]:
    """Quasi-permanent load with creep, of the uncracked section."""
    member = subject.member
    modulus_, phi = modulus(member.fc), _creep(subject)
    found = elastic(subject, modulus_ / (1.0 + phi))
    size, x, span = worst(subject, found.x, found.dead + member.live_sustained * found.live + found.prestress)
    values = (Value("L", span, "mm"), Value("phi", phi), Value("Ecm", modulus_, "MPa"))
    formula = f"delta (Ecm / (1 + phi)) <= L / {member.deflection_total:g}"
    limit = span / member.deflection_total
    made = at_most(
        "deflection, quasi-permanent", "EN 1992-1-1 7.4.1 (4)", formula, values, size, limit, "mm", x
    )
    stress = tension(subject, 1.0, 1.0).stress
    doubts = [] if subject.timely else [NO_TIME]
    doubts += [] if member.RH is not None else [f"creep for RH {DRY:g} %: give RH"]
    doubts += ["cracked under the characteristic load"] if stress > flexure.fctm(member.fc) else []
    yield unless(made, "; ".join(doubts))


def _creep(subject: Subject) -> float:
    """phi at the end of the design life."""
    member = subject.member
    h0 = 2.0 * (member.V_S or volume_to_surface(member))
    t = member.age_stressing + member.design_life * YEAR
    RH = DRY if member.RH is None else member.RH
    return creep_coefficient(t, member.age_stressing, RH, h0, member.fc, member.cement)
