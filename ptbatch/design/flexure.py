"""Flexural strength of a section: a rectangular stress block, bars by plane strains, the tendon at a stress
that is given or by plane strains as well."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from scipy.optimize import brentq

Strip = tuple[float, float]  # thickness and width [mm], from the compressed face on


class Steel(NamedTuple):
    """Steel at a depth below the compressed face [mm]: area [mm2], and its stress [MPa] by the strain
    (tension positive) that the section adds to it."""

    depth: float
    area: float
    stress: Callable[[float], float]


class Block(NamedTuple):
    """Rectangular stress block: stress [MPa], its depth as a share of the neutral axis, and the strain of the
    concrete at the compressed face."""

    stress: float
    share: float
    strain: float


class Strength(NamedTuple):
    """Neutral axis below the compressed face [mm], moment [N mm], and the strain of the deepest steel."""

    c: float
    moment: float
    deepest_strain: float


def elastic_plastic(E: float, fy: float) -> Callable[[float], float]:
    """Stress of a bar."""
    return lambda strain: min(max(E * strain, -fy), fy)


def constant(stress: float) -> Callable[[float], float]:
    """Stress of an unbonded tendon: the same along it, whatever the section does."""
    return lambda strain: stress


def compressed(strips: Sequence[Strip], depth: float) -> tuple[float, float]:
    """Area of the strips down to a depth [mm2], and its first moment about the compressed face [mm3]."""
    area = moment = top = 0.0
    for thickness, width in strips:
        part = min(max(depth - top, 0.0), thickness)
        area += part * width
        moment += part * width * (top + 0.5 * part)
        top += thickness
    return area, moment


def strength(strips: Sequence[Strip], block: Block, steel: Sequence[Steel]) -> Strength | None:
    """Strength in pure bending; None where the steel has no tension to resist it, or more than the section
    can balance."""
    h = sum(thickness for thickness, _ in strips)

    def forces(c: float) -> list[float]:
        return [bar.area * bar.stress(block.strain * (bar.depth - c) / c) for bar in steel]

    def out_of_balance(c: float) -> float:
        return block.stress * compressed(strips, block.share * c)[0] - sum(forces(c))

    low, high = 1e-6 * h, 10.0 * h
    if out_of_balance(low) >= 0.0 or out_of_balance(high) <= 0.0:
        return None
    c = float(brentq(out_of_balance, low, high, rtol=1e-13))
    lever = block.stress * compressed(strips, block.share * c)[1]
    moment = sum(force * bar.depth for force, bar in zip(forces(c), steel, strict=True)) - lever
    deepest = max(bar.depth for bar in steel if bar.area > 0.0)
    return Strength(c, moment, block.strain * (deepest - c) / c)
