"""The first run compiles for most of a minute. A second process helps: it compiles kernels that the first one
comes to late, for the folder where that one will look for them.
"""

import os
import subprocess
import sys
from contextlib import suppress
from typing import Any

from ptbatch.core.cache import is_warm

ANY = dict(
    member="any", span=10_000, b=300, h=600, fc=40, Aps=592, dp=(300, 500, 300), fpj=1395, elements=4
)  # fmt: skip
_helpers: list[subprocess.Popen[bytes]] = []  # held, since one that nobody holds is complained about


def compile_ahead() -> None:
    """Start the second process, if there is something to compile and a processor for it. Whatever becomes of
    it, the first one compiles what it does not find."""
    if _helpers or is_warm() or (os.cpu_count() or 1) < 2 or not sys.executable:
        return
    quiet = subprocess.DEVNULL
    # -P: a file in the working folder is not to be taken for a module
    command = [sys.executable, "-P", "-m", "ptbatch.first_run"]
    with suppress(OSError):
        _helpers.append(subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet))


def late_kernels() -> dict[Any, tuple[Any, ...]]:
    """What the first process comes to late, in about that order, and the types that it will have there."""
    from numba import typeof, types

    from ptbatch.core import follow
    from ptbatch.core.assembly import tangent
    from ptbatch.core.equilibrium import imbalance_as_evaluated
    from ptbatch.core.failure import demands_as_evaluated
    from ptbatch.core.newton import factorise_tangent, step
    from ptbatch.core.placement import slide_tendon
    from ptbatch.core.reference import ReferenceType
    from ptbatch.core.step import accept

    case, target, vector = kinds()
    whole, real = types.int64, types.float64
    model, state, ends, work = (
        ReferenceType(case.field(name)[1]) for name in ("model", "state", "ends", "work")
    )
    demand, control = (0.0, 0.0, 0.0), follow.Control(0, 0.0, 0.0, 0.0, 0.0, 0.0)
    way = typeof(follow.Way(0.0, 0.0, 0.0, demand, demand, (False, False, False), 0))
    trial = typeof(follow.Trial(0.0, False, False, 0.0, 0, 0.0, demand, False))
    return {
        tangent: (model, state, vector, ends, types.boolean, work),
        slide_tendon: (model, state, vector, work),
        factorise_tangent: (case,),
        step: (case, target),
        imbalance_as_evaluated: (case, target, real),
        accept: (case, whole, real, whole, real),
        demands_as_evaluated: (case,),
        follow.met: (typeof(demand),),
        follow.deflection: (case, typeof(control)),
        follow.foreseen: (way, real),
        follow.next_step: (trial,),
        follow.first_passed: (way, typeof(demand), typeof(demand)),
        follow.news: (way, typeof(demand)),
        follow.fastest: (case,),
    }


def kinds() -> tuple[Any, Any, Any]:
    """numba's types of a case, of a target and of a vector."""
    from numba import typeof

    from ptbatch.analysis import jacking_stress, laid_out
    from ptbatch.core.case import Target
    from ptbatch.core.reference import ReferenceType
    from ptbatch.member import Member
    from ptbatch.model.arrays import set_up
    from ptbatch.tendon_losses import tendon_losses

    setup = set_up(Member(**ANY))
    fpj = jacking_stress(setup)
    case, _ = laid_out(setup, tendon_losses(vars(setup.member), fpj), fpj)
    target = Target(setup.pattern, setup.pattern, False, -1, -1, 0.0)
    return ReferenceType(typeof(case)), typeof(target), typeof(setup.pattern)


if __name__ == "__main__":
    for kernel, signature in late_kernels().items():
        kernel.compile(signature)
