"""How near the materials are to their limit strains."""

import numpy as np

from ptbatch.core.beam import GAUSS, chord, strains
from ptbatch.core.concrete import ELASTIC
from ptbatch.core.history import element_displacements
from ptbatch.core.jit import kernel
from ptbatch.core.tendon import ELASTIC_TENDON


@kernel
def utilisation(case, u):
    """(concrete, bars, tendon): largest strain over crushing, bar rupture and tendon rupture strain, at
    displacements u.

    Concrete is judged at the extreme fibres of the sections. The tendon's strain is that of the last
    evaluation. A ruptured bar no longer counts.
    """
    model, state, work = case.model, case.state, case.work
    crushing = 0.0
    bars = 0.0
    for e in range(model.x.size - 1):
        element_displacements(e, u, work.q6)
        length = model.x[e + 1] - model.x[e]
        elongation, _, _, _, turn1, turn2 = chord(length, work.q6)
        for g in range(2):
            eps0, kappa = strains(length, elongation, turn1, turn2, GAUSS[g])
            crushing = max(crushing, model.top * kappa - eps0, model.bottom * kappa - eps0)
            for i in range(model.bar_y.size):
                if model.bar_area[e, i] > 0.0 and not np.isnan(state.bar[e, g, i]):
                    bars = max(bars, abs(eps0 - model.bar_y[i] * kappa))
    tendon = 0.0
    for e in range(model.rest_length.size):
        tendon = max(tendon, (work.length[e] - model.rest_length[e]) / model.rest_length[e])
    return (
        0.0 if model.concrete.law == ELASTIC else crushing / model.concrete.crushing_strain,
        bars / model.steel.esu,
        0.0 if model.strand.law == ELASTIC_TENDON else tendon / model.strand.epu,
    )
