"""Gross concrete section: a stack of rectangles, cut into layers for the fibre beam element."""

from dataclasses import dataclass
from functools import lru_cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MEASURES = ("shape", "b", "h", "bw", "hf", "b_bottom", "hf_bottom", "layers")
SHAPES = ("rectangle", "tee", "i", "box")


@dataclass(frozen=True, eq=False)
class Section:
    """Layers of a section, from the top down, and its exact gross properties.

    y, width, thickness: shape (layers,), centre below the top fibre, width and height of each layer [mm].
    area [mm2], centroid below the top fibre [mm], inertia about the centroid [mm4], h: overall depth [mm].
    """

    y: Array
    width: Array
    thickness: Array
    area: float
    centroid: float
    inertia: float
    h: float


def gross_section(member: Any) -> Section:
    """Section of a member.

    member: anything with shape, b, h, bw, hf, b_bottom, hf_bottom and layers as in the workbook, in mm. A tee
    has its flange on top; a box is an i whose bw is the sum of its webs. b_bottom and hf_bottom default to b
    and hf. The layers are shared out in proportion to height, at least two to each part, and end at the edges
    of the flanges. The last ones are kept.
    Raises ValueError if the shape is unknown or a part has no width or height.
    """
    return _section(tuple(getattr(member, name) for name in MEASURES))


@lru_cache(256)
def _section(measures: tuple[Any, ...]) -> Section:
    member = SimpleNamespace(**dict(zip(MEASURES, measures, strict=True)))
    width, height = _parts(member)
    top = np.cumsum(height) - height
    area, middle = width * height, top + height / 2.0
    centroid = float(area @ middle / area.sum())
    inertia = float(np.sum(area * (height**2 / 12.0 + (middle - centroid) ** 2)))
    counts = _layer_counts(height, member.layers)
    thickness = np.repeat(height / counts, counts)
    y = np.cumsum(thickness) - thickness / 2.0
    layers = y, np.repeat(width, counts), thickness
    return Section(*layers, float(area.sum()), centroid, inertia, float(member.h))


def section_layers(member: Any) -> tuple[Array, Array, Array]:
    """Centre depth, width and thickness of the concrete layers [mm], from the top down."""
    section = gross_section(member)
    return section.y, section.width, section.thickness


def _parts(member: Any) -> tuple[Array, Array]:
    """Widths and heights of the rectangles that the section is made of, from the top down."""
    if member.shape not in SHAPES:
        raise ValueError(f"shape: {member.shape!r} is none of {', '.join(SHAPES)}")
    parts = [(member.b, member.h)]
    if member.shape == "tee":
        parts = [(member.b, member.hf), (member.bw, member.h - member.hf)]
    elif member.shape in ("i", "box"):
        b_bottom = member.b if member.b_bottom is None else member.b_bottom
        hf_bottom = member.hf if member.hf_bottom is None else member.hf_bottom
        web = member.h - member.hf - hf_bottom
        parts = [(member.b, member.hf), (member.bw, web), (b_bottom, hf_bottom)]
    if not np.all(np.array(parts) > 0.0):
        raise ValueError(f"section: each part needs a width and a height above zero, got {parts} mm")
    width, height = np.array(parts, dtype=float).T
    return width, height


def _layer_counts(height: Array, layers: int) -> NDArray[np.int64]:
    """Layers of each part; rounding and the minimum of two are made up for in the tallest part."""
    counts = np.maximum(2, np.rint(layers * height / height.sum()).astype(np.int64))
    tallest = int(np.argmax(height))
    counts[tallest] = max(2, counts[tallest] + layers - counts.sum())
    return counts
