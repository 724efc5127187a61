"""The registry of input columns: reading, validation, defaults and the template all derive from it.

A new column is one entry here and, if an analysis needs it, one field of `Member`.
"""

from math import sqrt

from ptbatch.workbook.column import Column, Derived

EXPOSURES = (
    *("interior", "weather", "ground", "X0", "XC1", "XC2", "XC3", "XC4", "XD1", "XD2", "XD3"),
    *("XS1", "XS2", "XS3"),
)
SUPPORTS = ("pin", "roller", "fixed", "free")
NO_BARS = Derived("none", (), tuple)

MEMBERS = (
    Column("member", "unique name", "text", required=True),
    Column("kind", "beam, or slab for a design strip", "choice", default="beam", choices=("beam", "slab")),
    Column(
        "span",
        "length of each span, from the left",
        "list",
        "length",
        required=True,
        us="ft",
    ),
    Column("support_left", "support at the left end", "choice", default="pin", choices=SUPPORTS),
    Column("support_right", "support at the right end", "choice", default="roller", choices=SUPPORTS),
    Column(
        "shape",
        "cross-section",
        "choice",
        default="rectangle",
        choices=("rectangle", "tee", "i", "box"),
    ),
    Column("b", "overall width", quantity="length", required=True),
    Column("h", "overall depth", quantity="length", required=True),
    Column("bw", "tee, i: width of the web; box: sum of its webs", quantity="length"),
    Column("hf", "tee, i, box: thickness of the top flange", quantity="length"),
    Column(
        "b_bottom",
        "i, box: width of the bottom flange",
        quantity="length",
        default=Derived("b for a box", ("shape", "b"), lambda shape, b: b if shape == "box" else None),
    ),
    Column(
        "hf_bottom",
        "i, box: thickness of the bottom flange",
        quantity="length",
        default=Derived("hf for a box", ("shape", "hf"), lambda shape, hf: hf if shape == "box" else None),
    ),
    Column("fc", "cylinder strength of the concrete", quantity="stress", required=True),
    Column(
        "ft",
        "tensile strength of the concrete",
        quantity="stress",
        limit="not negative",
        default=Derived("0.62 sqrt(fc), in MPa", ("fc",), lambda fc: 0.62 * sqrt(fc)),
        source="ACI 318-19, 19.2.3.1",
    ),
    Column(
        "Ec",
        "modulus of the concrete",
        quantity="stress",
        default=Derived("4700 sqrt(fc), in MPa", ("fc",), lambda fc: 4700.0 * sqrt(fc)),
        source="ACI 318-19, 19.2.2.1",
    ),
    Column(
        "concrete_law",
        "compression law; elastic is linear both ways, for verification",
        "choice",
        default="hognestad",
        choices=("hognestad", "parabola-rectangle", "popovics", "elastic"),
        source="Hognestad (1951); EN 1992-1-1, 3.1.7; Popovics (1973)",
    ),
    Column(
        "crushing_strain",
        "end of the concrete law (0.85 fc there for hognestad)",
        limit="fraction",
        default=Derived(
            "0.0038 (0.0035 for parabola-rectangle)",
            ("concrete_law",),
            lambda law: 0.0035 if law == "parabola-rectangle" else 0.0038,
        ),
        source="Hognestad (1951); EN 1992-1-1, Table 3.1",
    ),
    Column(
        "tension_law",
        "after cracking: no stress, linear softening, or tension stiffening",
        "choice",
        default="stiffening",
        choices=("none", "softening", "stiffening"),
    ),
    Column("tension_end", "softening reaches zero at this many cracking strains", default=10.0),
    Column("density", "unit weight, for self-weight", quantity="unit weight", default=24.0),
    Column("self_weight", "self-weight acts from the jacking stage on", "yesno", default=True),
    Column(
        "Aps",
        "tendon area, per member or per strip",
        quantity="area",
        required=True,
    ),
    Column("fpu", "strength of the tendon", quantity="stress", default=1860.0, source="ASTM A416, grade 270"),
    Column(
        "fpy",
        "yield stress of the tendon",
        quantity="stress",
        default=Derived("0.9 fpu", ("fpu",), lambda fpu: 0.9 * fpu),
        source="ASTM A416, low relaxation",
    ),
    Column("Ep", "modulus of the tendon", quantity="stress", default=195000.0, source="EN 1992-1-1, 3.3.6"),
    Column(
        "tendon_law",
        "bilinear: to fpy, then straight to fpu at epu",
        "choice",
        default="ramberg-osgood",
        choices=("ramberg-osgood", "bilinear", "elastic"),
        source="Ramberg and Osgood (1943)",
    ),
    Column(
        "epu",
        "rupture strain of the tendon",
        limit="fraction",
        default=0.035,
        source="ASTM A416, least elongation",
    ),
    Column(
        "profile",
        "shape of the tendon",
        "choice",
        default="parabola",
        choices=("straight", "parabola", "harped"),
    ),
    Column(
        "dp",
        "depths of the tendon below the top fibre; straight: one number; others: left end, then the "
        "low point and the right end of each span. Not needed where the sheet `profile` gives the tendon",
        "list",
        "length",
        required=True,
    ),
    Column(
        "harp",
        "harped: harping points as fractions of the span",
        "list",
        limit="fraction",
        default=Derived("1/3; 2/3", (), lambda: (1 / 3, 2 / 3)),
    ),
    Column(
        "inflection",
        "parabola: inflection point from an interior support, as a fraction of the span",
        limit="fraction",
        default=0.1,
    ),
    Column(
        "fpj",
        "stress at the live end while jacking: give fpj or fpe",
        quantity="stress",
    ),
    Column("fpe", "mean stress wanted after anchoring: give fpj or fpe", quantity="stress"),
    Column("jack", "live end", "choice", default="left", choices=("left", "right", "both")),
    Column(
        "set",
        "wedge set (draw-in) at each live end",
        quantity="length",
        limit="not negative",
        default=6.0,
    ),
    Column(
        "mu",
        "curvature friction",
        quantity="friction",
        limit="not negative",
        default=0.07,
        source="greased and sheathed strand; for grouted ducts 0.15 to 0.25 is usual",
    ),
    Column(
        "k_ec2",
        "wobble as an angle: K = mu k_ec2. Give K or k_ec2, not both",
        quantity="angle per length",
        limit="not negative",
        source="EN 1992-1-1, 5.10.5.2: 0.005 to 0.01 rad/m",
    ),
    Column(
        "K",
        "wobble per length: P = P0 exp(-(mu alpha + K x))",
        quantity="friction per length",
        limit="not negative",
        default=Derived(
            "0.0033 1/m, or mu k_ec2", ("mu", "k_ec2"), lambda mu, k: 3.3e-6 if k is None else mu * k
        ),
        source="greased and sheathed strand; Huang and Kang (2018), eq. (38)",
    ),
    Column(
        "wobble",
        "direct: friction per length at the contact; sine: waves on the profile that turn by K / mu per "
        "length, in place of K",
        "choice",
        default="direct",
        choices=("direct", "sine"),
        source="Huang and Kang (2018)",
    ),
    Column(
        "sheathing",
        "smooth: the duct is the profile itself; polygon: straight segments between the beam nodes, whose "
        "corners turn by less than the profile. Friction counts all of its angle either way",
        "choice",
        default="smooth",
        choices=("smooth", "polygon"),
    ),
    Column(
        "correction",
        "contact force across the tendon rather than the duct; no: the stress strays even without friction",
        "yesno",
        default=True,
    ),
    Column(
        "bond",
        "bonded: grouted after anchoring",
        "choice",
        default="unbonded",
        choices=("unbonded", "bonded"),
    ),
    Column("As", "areas of bonded bars", "list", "area", NO_BARS, limit="not negative"),
    Column(
        "ds", "depths of the bars As below the top fibre", "list", "length", NO_BARS, limit="not negative"
    ),
    Column("As_top", "areas of top bars", "list", "area", NO_BARS, limit="not negative"),
    Column("ds_top", "depths of the bars As_top", "list", "length", NO_BARS, limit="not negative"),
    Column("fy", "yield stress of the bars", quantity="stress", default=420.0, source="ASTM A615, grade 60"),
    Column("Es", "modulus of the bars", quantity="stress", default=200000.0, source="EN 1992-1-1, 3.2.7"),
    Column(
        "hardening",
        "slope after yield as a fraction of Es",
        limit="not negative",
        default=0.01,
    ),
    Column("esu", "rupture strain of the bars", limit="fraction", default=0.05),
    Column(
        "w_dead",
        "sustained load besides self-weight, put on before the live load",
        quantity="line load",
        limit="not negative",
        default=0.0,
    ),
    Column(
        "live",
        "pattern that the last stage scales; loads: rows of that sheet",
        "choice",
        default="uniform",
        choices=("uniform", "midspan", "third-points", "loads"),
    ),
    Column(
        "w_live",
        "live=uniform: service load; load factor 1",
        quantity="line load",
        limit="not negative",
    ),
    Column(
        "P_live",
        "live=midspan, third-points: total service load in a span",
        quantity="force",
        limit="not negative",
    ),
    Column(
        "live_spans",
        "loaded spans, 1 = left",
        "integers",
        default=Derived("all", ("span",), lambda span: tuple(range(1, len(span) + 1))),
    ),
    Column("n_strands", "strands that Aps is made of; needed with n_strands_lost", "integer"),
    Column(
        "n_strands_lost",
        "strands of an existing member that are broken or cut: the member is analysed with the others alone",
        "integer",
        limit="not negative",
        default=0,
    ),
    Column(
        "standard",
        "code that the member is checked by, beside the analysis",
        "choice",
        default="none",
        choices=("none", "ACI 318-19", "EN 1992-1-1"),
    ),
    Column("fci", "strength of the concrete at stressing; blank: transfer is not checked", quantity="stress"),
    Column(
        "long_term_loss",
        "stress that creep, shrinkage and relaxation take off the tendon between the sustained and the live "
        "load, as a lump sum",
        quantity="stress",
        limit="not negative",
    ),
    Column(
        "RH",
        "relative humidity around the member; with it creep, shrinkage and relaxation are computed where "
        "long_term_loss is blank: by the standard EN 1992-1-1, else by Zia et al. (ACI 423.10R)",
        quantity="percent",
        limit="0 to 100",
    ),
    Column("V_S", "volume of the member over its drying surface; blank: of the section", quantity="length"),
    Column(
        "age_stressing",
        "age of the concrete at stressing in days; Zia counts from the end of moist curing",
        default=7.0,
    ),
    Column(
        "Av",
        "area of all legs of one set of stirrups; 0: there are none; blank: where they are needed is told",
        quantity="area",
        limit="not negative",
    ),
    Column("s", "spacing of the stirrups along the member; needed with Av", quantity="length"),
    Column(
        "fyt",
        "yield stress of the stirrups",
        quantity="stress",
        default=Derived("fy", ("fy",), lambda fy: fy),
    ),
    Column(
        "service_class",
        "class that is asked for, ACI 318-19, 24.5.2; `class` for short; any: it is told, not judged",
        "choice",
        default="any",
        choices=("any", "U", "T", "C"),
        also="class",
    ),
    Column(
        "exposure",
        "for the cover: interior, weather or ground (ACI 318-19, 20.5.1.3), X0 to XS3 (EN 1992-1-1, 4.2)",
        "choice",
        default="interior",
        choices=EXPOSURES,
    ),
    Column(
        "cover",
        "clear cover that the tendon has to have; blank: by exposure and standard",
        quantity="length",
        limit="not negative",
    ),
    Column("duct", "outer diameter of the duct or sheathing, for the cover", quantity="length"),
    Column("bar_diameter", "of the bars, for crack widths by EN 1992-1-1", quantity="length", default=16.0),
    Column(
        "live_frequent",
        "share of the live load in the frequent combination, EN 1990, psi1",
        limit="0 to 1",
        default=0.5,
    ),
    Column(
        "deflection_live",
        "span over the deflection by live load that is allowed",
        default=360.0,
        source="ACI 318-19, table 24.2.2: floors",
    ),
    Column(
        "deflection_total",
        "span over the long-term deflection that is allowed: after attachment (ACI), in all (EN)",
        default=Derived(
            "240 (250 by EN 1992-1-1)", ("standard",), lambda code: 250.0 if code == "EN 1992-1-1" else 240.0
        ),
        source="ACI 318-19, table 24.2.2; EN 1992-1-1, 7.4.1 (4)",
    ),
    Column(
        "factor_dead",
        "load factor of dead load; blank: the combinations of the standard. Give factor_live as well",
    ),
    Column("factor_live", "load factor of live load", limit="not negative"),
    Column("cement", "class of the cement, EN 1992-1-1", "choice", default="n", choices=("s", "n", "r")),
    Column("relaxation", "of the strand", "choice", default="low", choices=("low", "normal")),
    Column("design_life", "years of creep and shrinkage, EN 1992-1-1", default=50.0),
    Column(
        "live_sustained", "share of the live load that always acts, for creep", limit="0 to 1", default=0.0
    ),
    Column(
        "deflection_limit",
        "the analysis stops at this deflection at the latest",
        quantity="length",
        default=Derived("longest span / 50", ("span",), lambda span: max(span) / 50.0),
    ),
    Column("elements", "beam elements per span", "integer", default=20),
    Column("layers", "concrete layers of the section", "integer", default=40),
)

NOTE = Column("note", "free text, echoed in the results; any sheet may have it", "text")

BY_NAME = {column.name: column for column in MEMBERS}
