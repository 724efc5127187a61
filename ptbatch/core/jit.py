"""How every kernel is compiled, and the few functions that carry a complex step through non-polynomial maths.

A kernel branches on real parts only. With a step of 1e-30 the first-order term of a smooth function is exact
to machine precision, so `lift(f, df, z)` style expansions replace the slow and branch-cut-ridden complex
library functions, and the same source serves floats (residual only) and complex numbers (residual and
tangent).
"""

from collections.abc import Callable
from typing import Any

import numba
import numpy as np

from ptbatch.core.cache import cache_folder

STEP = 1e-30

numba.config.CACHE_DIR = str(cache_folder())  # type: ignore[attr-defined]


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile with the GIL released and the disk cache on; no fast-math, so that digits do not depend on the
    machine."""
    return numba.njit(cache=True, nogil=True, error_model="numpy")(function)


@kernel
def root(z):
    """Square root of a positive number, complex step carried to first order."""
    r = np.sqrt(z.real)
    return r + (z - z.real) / (2.0 * r)


@kernel
def inverse(z):
    """One over a number other than zero, complex step carried to first order."""
    r = 1.0 / z.real
    return r - (z - z.real) * (r * r)


@kernel
def inverse_root(z):
    """One over the square root of a positive number, complex step carried to first order."""
    r = 1.0 / np.sqrt(z.real)
    return r - (z - z.real) * (0.5 * r * r * r)


@kernel
def power(z, exponent):
    """z ** exponent for a positive base, complex step carried to first order."""
    p = z.real**exponent
    return p + (z - z.real) * (exponent * p / z.real)


@kernel
def cos_sin(angle):
    """Cosine and sine, complex step carried to first order."""
    c = np.cos(angle.real)
    s = np.sin(angle.real)
    step = angle - angle.real
    return c - s * step, s + c * step
