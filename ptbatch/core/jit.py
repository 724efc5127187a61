"""How every kernel is compiled, and the few functions that carry a complex step through non-polynomial maths.

A kernel branches on real parts only. With a step of 1e-30 the first-order term of a smooth function is exact
to machine precision, so `lift(f, df, z)` style expansions replace the slow and branch-cut-ridden complex
library functions, and the same source serves floats (residual only) and complex numbers (residual and
tangent).
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numba
import numpy as np
from numba.core import types
from numba.core.dispatcher import Dispatcher

from ptbatch.core.store import keep

STEP = 1e-30
njit: Any = partial(numba.njit, nogil=True, error_model="numpy")


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile with the GIL released and keep the code between runs; no fast-math, so that digits do not
    depend on the machine."""
    compiled = njit(no_cfunc_wrapper=True)(function)
    if isinstance(compiled, Dispatcher):  # it is the function itself where numba is told not to compile
        keep(compiled)
        compile_once(compiled)
    return compiled


def inlined(function: Callable[..., Any]) -> Callable[..., Any]:
    """A kernel that becomes part of its callers. Whatever a kernel calls is compiled with it once more, so of
    a long chain of callers only the outermost should be a kernel of its own."""
    return njit(inline="always")(function)


def compile_once(compiled: Any) -> None:
    """Compile a kernel once for all values of an argument: numba would do it again for each True, False or
    number that stands in a call."""
    template = compiled.get_call_template
    compiled.get_call_template = lambda args, kws: template(
        tuple(types.unliteral(kind) for kind in args), {name: types.unliteral(kws[name]) for name in kws}
    )


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
def cos_sin(angle):
    """Cosine and sine, complex step carried to first order."""
    c = np.cos(angle.real)
    s = np.sin(angle.real)
    step = angle - angle.real
    return c - s * step, s + c * step
