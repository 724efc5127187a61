"""Members that speed and iterations are told of, by name."""

from ptbatch.member import Member

FINE = 60  # elements of the finer of the two reference meshes
FOLLOWED = 100.0  # mm of deflection up to which OpenSees follows the reference beam: just short of yield

# The beam that OpenSees was timed with: 15 m, friction, 20 fibre beam elements of 2 sections and 40 layers
REFERENCE = dict(
    span=15000, b=300, h=750, fc=40, Aps=987, dp=(375, 650, 375), fpj=1395, set=6, mu=0.2, K=3.3e-6,
    As=603, ds=700, w_dead=5, w_live=10, elements=20, layers=40,
)  # fmt: skip

NAMED = {
    "15 m beam": REFERENCE,
    "60 elements": REFERENCE | dict(elements=FINE),
    "bonded": REFERENCE | dict(bond="bonded"),
    "two jacks": REFERENCE | dict(jack="both"),
    "two spans": REFERENCE
    | dict(
        span=(15000, 12000), dp=(375, 650, 100, 600, 375), As_top=603, ds_top=50, jack="both",
    ),
    "four spans, no bars": REFERENCE
    | dict(
        span=(12000, 15000, 15000, 12000), dp=(375, 650, 100, 650, 100, 650, 100, 650, 375), As=0, ds=0,
        jack="both",
    ),
    "slab strip": dict(
        kind="slab", span=8000, b=1000, h=220, fc=35, Aps=400, dp=(110, 180, 110), fpj=1395, set=6, mu=0.07,
        K=3.3e-6, As=350, ds=190, w_dead=1.5, w_live=3,
    ),
}  # fmt: skip


def named() -> dict[str, Member]:
    """The members by their names."""
    return {name: Member(member=name, **values) for name, values in NAMED.items()}
