"""How near the materials are to what is looked for on the way: cracking, yield, limit strains."""

import numpy as np

from ptbatch.core.beam import beam_strains
from ptbatch.core.concrete import ELASTIC, NO_TENSION
from ptbatch.core.jit import kernel
from ptbatch.core.section import face_levers, face_strains
from ptbatch.core.tendon import ELASTIC_TENDON

CRACKING, YIELD, LIMIT = range(3)  # what `demands` returns, each 1 where it is reached
CRACK_SCALE = 1e-4  # strain; cracking is counted as a difference, for without tension it is at zero strain


@kernel
def demands(case, u):
    """`demands_as_evaluated` at displacements u; the tendon's strain is that of the last evaluation."""
    beam_strains(case.model, u, case.work)
    return demands_as_evaluated(case)


@kernel
def demands_as_evaluated(case):
    """((cracking, yield, limit), tendon): how near the member is to its first crack, to yield of a bar or the
    tendon, to the limit strain of any material and of the tendon alone; at the strains of the last
    evaluation.

    Concrete is judged at the extreme fibres of the sections. A ruptured bar no longer counts.
    """
    model, state, work = case.model, case.state, case.work
    opening = crushing = -1.0
    bars = yielding = 0.0
    levers = face_levers(model)
    for e in range(model.x.size - 1):
        for g in range(2):
            eps0, kappa = work.strain[0, 2 * e + g], work.strain[1, 2 * e + g]
            top, bottom = face_strains(2 * e + g, levers, model, state, work)
            opening = max(opening, top, bottom)
            crushing = max(crushing, -top, -bottom)
            for i in range(model.bar_y.size):
                if model.bar_area[e, i] > 0.0 and not np.isnan(state.bar[e, g, i]):
                    strain = abs(eps0 - model.bar_y[i] * kappa)
                    bars = max(bars, strain)
                    yielding = max(yielding, strain * model.steel.Es / model.bar_fy[i])
    tendon = 0.0
    for e in range(work.stretch.size):
        tendon = max(tendon, work.stretch[e])
        if model.strand.law != ELASTIC_TENDON:
            yielding = max(yielding, work.T[e] / (model.strand.Aps * model.strand.fpy))
    concrete = model.concrete
    eps_cr = 0.0 if concrete.tension_law == NO_TENSION else concrete.eps_cr
    cracking = 0.0 if concrete.law == ELASTIC else 1.0 + (opening - eps_cr) / CRACK_SCALE
    crushing = 0.0 if concrete.law == ELASTIC else crushing / concrete.crushing_strain
    tendon = 0.0 if model.strand.law == ELASTIC_TENDON else tendon / model.strand.epu
    return (cracking, yielding, max(crushing, bars / model.steel.esu, tendon)), tendon
