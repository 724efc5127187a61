"""Specified cover of cast-in-place prestressed concrete."""

WEATHER = ("weather", "XC3", "XC4", "XD1", "XD2", "XD3", "XS1", "XS2", "XS3")
GROUND = ("ground", "XC2")


def specified(exposure: str, slab: bool) -> float:
    """Least cover [mm].

    ACI 318-19 table 20.5.1.3.2: cast against ground 3 in; exposed to weather or in contact with ground 1 in
    (slabs), 1.5 in (others); else 0.75 in (slabs), 1.5 in (primary reinforcement of beams).
    """
    if exposure in GROUND:
        return 76.2
    return (25.4 if exposure in WEATHER else 19.05) if slab else 38.1
