"""A seeded population of members across the whole range of the workbook.

Each is drawn the way an engineer sizes a member (span, then depth by slenderness, then prestress by the load
that it balances), so that it stands under its sustained load, and otherwise as wide as the columns allow:
1 to 4 spans of 3 to 40 m, slabs of 120 mm to box girders of 2.5 m, every profile, law, bond, support, live
pattern and jack, friction 0 to 0.3, no bars to heavy ones.
"""

from typing import Any

import numpy as np

from ptbatch.geometry.section import gross_section
from ptbatch.member import Member, MemberError

Values = dict[str, Any]

FREE_POINTS = 9  # of a span of a free profile
CANTILEVER = 14e3  # mm; a longer one does not stand within 2.5 m of depth
HARPS = ((0.5,), (1 / 3, 2 / 3), (0.4, 0.6))


def population(size: int, seed: int = 1) -> list[Member]:
    """The first `size` members of a seed; each has its own stream, so that they do not depend on `size`."""
    return [random_member(seed, number) for number in range(size)]


def random_member(seed: int, number: int) -> Member:
    """Member `number` of a seed: draws again where the values make no member."""
    rng = np.random.default_rng([seed, number])
    for _ in range(100):
        try:
            return Member(**_draw(rng, f"R{seed}-{number:04d}"))
        except MemberError:
            continue
    raise RuntimeError(f"no valid member in 100 draws of {seed}, {number}")


def _draw(rng: np.random.Generator, name: str) -> Values:
    values: Values = {"member": name} | _spans(rng)
    values |= _section(rng, max(values["span"]), len(values["span"]), "free" in _ends(values))
    values |= _concrete(rng)
    values |= _path(rng, values)
    values |= _live(rng, values)
    values["w_dead"] = float(rng.choice([0.0, rng.uniform(0.0, 1.0)])) * _own_weight(values)
    values |= _tendon(rng, values)
    values |= _bars(rng, values)
    return values


def _ends(values: Values) -> tuple[str, str]:
    return values["support_left"], values["support_right"]


def _spans(rng: np.random.Generator) -> Values:
    count = int(rng.choice([1, 2, 3, 4], p=[0.5, 0.2, 0.15, 0.15]))
    typical = float(np.exp(rng.uniform(np.log(3.0), np.log(40.0))))
    span = np.clip(typical * rng.uniform(0.75, 1.25, count), 3.0, 40.0) * 1e3
    pairs = [("pin", "roller"), ("roller", "pin"), ("fixed", "roller"), ("fixed", "fixed"), ("pin", "fixed")]
    if count > 1:
        pairs += [("roller", "roller"), ("free", "roller"), ("pin", "free")]
    else:
        pairs += [("fixed", "free"), ("free", "fixed")]
    odds = np.array([0.55, 0.1] + [0.35 / (len(pairs) - 2)] * (len(pairs) - 2))
    left, right = pairs[int(rng.choice(len(pairs), p=odds))]
    if left == "free" and count > 1:
        span[0] *= 0.35
    if right == "free" and count > 1:
        span[-1] *= 0.35
    if count == 1 and "free" in (left, right):
        span = np.minimum(span, CANTILEVER)
    span = np.maximum(span, 3000.0)
    return {"span": tuple(np.round(span, -1).tolist()), "support_left": left, "support_right": right}


def _section(rng: np.random.Generator, span: float, count: int, cantilever: bool) -> Values:
    slender = rng.uniform(12.0, 22.0 if cantilever and count == 1 else 28.0)
    kind = str(rng.choice(["beam", "slab"]))
    if cantilever and count == 1:
        slender *= 0.35
    if kind == "slab" and span < (5e3 if cantilever and count == 1 else 14e3):
        h = max(float(np.clip(span / slender, 120.0, 500.0)) * rng.uniform(0.8, 1.0), 120.0)
        return {"kind": "slab", "h": round(h, 0), "b": float(rng.choice([300.0, 1000.0, 1500.0]))}
    h = round(float(np.clip(span / slender, 200.0, 2500.0)), -1)
    shape = str(rng.choice(["rectangle", "tee", "i", "box"]))
    if shape == "rectangle" or h < 400.0:
        return {"kind": "beam", "h": h, "b": round(h * rng.uniform(0.35, 1.2), -1)}
    hf = round(float(np.clip(h * rng.uniform(0.1, 0.2), 80.0, 300.0)), 0)
    bw = round(max(h * rng.uniform(0.2, 0.35), 120.0), -1)
    b = round(bw * rng.uniform(1.5, 5.0), -1)
    values = {"kind": "beam", "shape": shape, "h": h, "b": b, "bw": bw, "hf": hf}
    if shape != "tee":
        values |= {"b_bottom": max(bw, round(b * rng.uniform(0.4, 1.0), -1))}
        values |= {"hf_bottom": round(hf * rng.uniform(0.8, 1.5), 0)}
    return values


def _concrete(rng: np.random.Generator) -> Values:
    values: Values = {
        "fc": round(float(rng.uniform(25.0, 60.0)), 1),
        "concrete_law": str(rng.choice(["hognestad", "parabola-rectangle", "popovics"])),
        "tension_law": str(rng.choice(["none", "softening", "stiffening"], p=[0.25, 0.25, 0.5])),
        "self_weight": bool(rng.random() < 0.9),
    }
    if rng.random() < 0.2:
        values["tension_end"] = round(float(rng.uniform(4.0, 30.0)), 1)
    return values


def _own_weight(values: Values) -> float:
    """N/mm."""
    return 24e-6 * _area(values)


def _area(values: Values) -> float:
    return _gross(values).area


def _gross(values: Values) -> Any:
    class _Shape:
        shape = values.get("shape", "rectangle")
        layers = 40

    for name in ("b", "h", "bw", "hf", "b_bottom", "hf_bottom"):
        setattr(_Shape, name, values.get(name))
    return gross_section(_Shape)


def _path(rng: np.random.Generator, values: Values) -> Values:
    """Where moments sag the tendon is low, over supports and towards free ends it is high."""
    h, count = values["h"], len(values["span"])
    cover = max(0.1 * h, 35.0)
    low, high, middle = h - cover, cover, _gross(values).centroid
    left, right = _ends(values)
    ends = {"pin": middle, "roller": middle, "free": middle, "fixed": high}
    profile = str(rng.choice(["straight", "parabola", "harped", "free"], p=[0.15, 0.5, 0.2, 0.15]))
    if profile == "straight":
        if "free" in (left, right) and count == 1:
            depth = middle + (high - middle) * rng.uniform(0.3, 1.0)
        elif "free" in (left, right) or count > 1:
            depth = middle * rng.uniform(0.8, 1.2)
        elif "fixed" in (left, right):
            depth = middle
        else:
            depth = middle + (low - middle) * rng.uniform(0.0, 1.0)
        return {"profile": "straight", "dp": (round(float(depth), 0),)}
    share = rng.uniform(0.5, 1.0)
    depths = [middle + share * (ends[left] - middle)]
    for i in range(count):
        overhang = (i == 0 and left == "free") or (i == count - 1 and right == "free")
        inner = high if i < count - 1 else ends[right]
        after = middle + share * (inner - middle)
        bottom = 0.5 * (depths[-1] + after) if overhang else middle + share * (low - middle)
        if count == 1 and "free" in (left, right):
            bottom = 0.5 * (middle + high)
        depths += [bottom, after]
    dp = tuple(round(float(d), 0) for d in depths)
    if profile == "free":
        return {"profile_points": _free_points(values["span"], dp)}
    values = {"profile": profile, "dp": dp}
    if profile == "harped":
        values["harp"] = HARPS[int(rng.integers(len(HARPS)))]
    elif rng.random() < 0.5:
        values["inflection"] = round(float(rng.uniform(0.05, 0.2)), 2)
    return values


def _free_points(span: tuple[float, ...], dp: tuple[float, ...]) -> tuple[tuple[float, float], ...]:
    """A polyline close to smooth: cosines between the given depths."""
    points, start = [(0.0, dp[0])], 0.0
    for i, length in enumerate(span):
        for half in range(2):
            a, b = dp[2 * i + half], dp[2 * i + half + 1]
            for k in range(1, FREE_POINTS // 2 + 1):
                t = k / (FREE_POINTS // 2)
                depth = a + (b - a) * 0.5 * (1.0 - np.cos(np.pi * t))
                points.append((start + length * (half + t) / 2.0, round(float(depth), 1)))
        start += length
    return tuple(points)


def _live(rng: np.random.Generator, values: Values) -> Values:
    spans, live = values["span"], str(rng.choice(["uniform", "midspan", "third-points", "loads"]))
    loaded = tuple(i + 1 for i in range(len(spans)) if rng.random() < 0.7)
    chosen: Values = {"live": live, "live_spans": loaded or None}
    area_load = 0.5 * _own_weight(values)
    if live == "uniform":
        return chosen | {"w_live": round(area_load, 2) + 0.5}
    if live != "loads":
        return chosen | {"P_live": round(area_load * min(spans), 0) + 1000.0}
    total = sum(spans)
    a = float(np.round(rng.uniform(0.1, 0.9) * total, -1))
    b = float(np.round(rng.uniform(0.0, 0.5) * total, -1))
    return {
        "live": "loads",
        "loads": (
            ("live", "point", a, a, round(area_load * min(spans), 0) + 1000.0),
            ("live", "uniform", b, b + 0.4 * total, round(area_load, 2) + 0.2),
        ),
    }


def _tendon(rng: np.random.Generator, values: Values) -> Values:
    """Prestress that balances a part of the sustained load, within 0.3 fc of mean compression."""
    span, depths = values["span"], values.get("dp") or [p[1] for p in values["profile_points"]]
    sag = max(max(depths) - min(depths), 0.15 * values["h"])
    load = _own_weight(values) + values["w_dead"]
    balanced = rng.uniform(0.5, 1.1)
    force = balanced * load * max(span) ** 2 / 8.0 / sag
    if len(values["span"]) == 1 and "free" in _ends(values):
        force *= 4.0
    A = _area(values)
    force = float(np.clip(force, 0.5 * A, 0.25 * values["fc"] * A))
    fpu = float(rng.choice([1770.0, 1860.0]))
    fpj = round(float(rng.uniform(0.6, 0.78)) * fpu, 0)
    mu = float(rng.choice([0.0, round(float(rng.uniform(0.03, 0.3)), 3)], p=[0.1, 0.9]))
    length = sum(span)
    tendon: Values = {
        "Aps": round(force / (0.85 * fpj), 1),
        "fpu": fpu,
        "tendon_law": str(rng.choice(["ramberg-osgood", "bilinear"], p=[0.7, 0.3])),
        "jack": str(rng.choice(["left", "right", "both"])),
        "set": float(rng.choice([0.0, 3.0, 6.0])) if length > 12e3 else float(rng.choice([0.0, 1.0, 2.0])),
        "mu": mu,
        "bond": str(rng.choice(["unbonded", "bonded"], p=[0.6, 0.4])),
    }
    wobble = rng.random()
    if wobble < 0.2:
        tendon["K"] = 0.0
    elif wobble < 0.5 and mu > 0.0:
        tendon["k_ec2"] = round(float(rng.uniform(0.002, 0.01)), 4) * 1e-3
    else:
        tendon["K"] = round(float(rng.uniform(0.0005, 0.005)), 4) * 1e-3
    stress = "fpe" if rng.random() < 0.25 else "fpj"
    return tendon | {stress: fpj if stress == "fpj" else round(0.85 * fpj, 0)}


def _bars(rng: np.random.Generator, values: Values) -> Values:
    """None, light, usual or heavy, in both faces where moments change sign."""
    ratio = float(rng.choice([0.0, 0.001, 0.003, 0.01, 0.02], p=[0.15, 0.2, 0.3, 0.25, 0.1]))
    if ratio == 0.0:
        return {}
    width = values.get("bw") or values["b"]
    As = round(ratio * width * values["h"], 0)
    cover = max(0.06 * values["h"], 25.0)
    bars: Values = {"As": As, "ds": values["h"] - cover, "fy": float(rng.choice([420.0, 500.0]))}
    if len(values["span"]) > 1 or "fixed" in _ends(values) or rng.random() < 0.5:
        bars |= {"As_top": round(As * rng.uniform(0.3, 1.0), 0), "ds_top": cover}
    if rng.random() < 0.1:
        bars |= {"hardening": 0.002}
    return bars
