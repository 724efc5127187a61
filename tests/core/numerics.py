"""Derivatives for tests: complex step and central difference of the same compiled function."""

from collections.abc import Callable

import numpy as np

from ptbatch.core.jit import STEP


def complex_slope(function: Callable, x: float) -> float:
    """df/dx by the complex step; the real part must not feel the step."""
    z = function(complex(x, STEP))
    assert z.real == function(x)
    return z.imag / STEP


def central_slope(function: Callable, x: float, h: float) -> float:
    """df/dx by the central difference."""
    return (function(x + h) - function(x - h)) / (2.0 * h)


def central_jacobian(function: Callable, q: np.ndarray, h: np.ndarray | float) -> np.ndarray:
    """Columns df/dq_i by central differences of steps h."""
    steps = np.broadcast_to(h, q.shape)
    columns = []
    for i, step in enumerate(steps):
        move = np.zeros_like(q)
        move[i] = step
        columns.append((function(q + move) - function(q - move)) / (2.0 * step))
    return np.column_stack(columns)


def turned_by(phi: float) -> np.ndarray:
    """Rotation matrix."""
    return np.array([[np.cos(phi), -np.sin(phi)], [np.sin(phi), np.cos(phi)]])
