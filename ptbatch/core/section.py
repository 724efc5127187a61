"""All sections of a member at once: forces and tangents from the layers of concrete and the bars.

Sagging curvature and moment are positive, the layer at height y strains by eps0 - y kappa. The section is the
same along the member, so that what one layer does in all sections is a loop that the processor can take
several of at a time; sums run over the layers in their order, whatever the processor.
"""

import numpy as np

from ptbatch.core.concrete import ELASTIC, FREE, commit_fibres, fibres
from ptbatch.core.jit import STEP, kernel
from ptbatch.core.steel import commit_steel, steel_stress


@kernel
def section_tangent(model, state, damping, work):
    """N, M, dN/deps0, dN/dkappa = dM/deps0 and dM/dkappa of all sections in work.section, for work.strain.

    damping: added to the modulus of each concrete fibre, as a share of the uncracked one.
    """
    eps0, kappa, stress, modulus = work.strain[0], work.strain[1], work.fibre[0], work.fibre[1]
    N, M = work.section[0], work.section[1]
    EA, ES, EI = work.section[2], work.section[3], work.section[4]
    more = damping * model.concrete.E0
    work.section[:] = 0.0
    for i in range(model.layer_y.size):
        y, area = model.layer_y[i], model.layer_area[i]
        fibres(y, eps0, kappa, state.concrete[i], model.concrete, stress, modulus)
        lever = y * area
        second = y * lever
        for s in range(eps0.size):
            stiff = modulus[s] + more
            N[s] += area * stress[s]
            M[s] -= lever * stress[s]
            EA[s] += area * stiff
            ES[s] -= lever * stiff
            EI[s] += second * stiff
    for b in range(model.bar_y.size):
        y = model.bar_y[b]
        for s in range(eps0.size):
            area, plastic = model.bar_area[s // 2, b], state.bar[s // 2, s % 2, b]
            if area > 0.0 and not np.isnan(plastic):
                eps = complex(eps0[s] - y * kappa[s], STEP)
                bar = steel_stress(eps, plastic, model.bar_fy[b], model.steel)
                stiff = area * (bar.imag / STEP)
                N[s] += area * bar.real
                M[s] -= y * area * bar.real
                EA[s] += stiff
                ES[s] -= y * stiff
                EI[s] += y * y * stiff


@kernel
def commit_sections(model, state, work):
    """Take the history of all fibres and bars to work.strain."""
    eps0, kappa = work.strain[0], work.strain[1]
    if model.concrete.law != ELASTIC:
        for i in range(model.layer_y.size):
            commit_fibres(model.layer_y[i], eps0, kappa, state.concrete[i], model.concrete)
    for b in range(model.bar_y.size):
        for s in range(eps0.size):
            eps = eps0[s] - model.bar_y[b] * kappa[s]
            plastic = state.bar[s // 2, s % 2, b]
            state.bar[s // 2, s % 2, b] = commit_steel(eps, plastic, model.bar_fy[b], model.steel)


@kernel
def face_levers(model):
    """How much farther out the top and the bottom fibre lie than the layer next to them, over the distance of
    that layer from its neighbour; zero where there is but one layer."""
    y, last = model.layer_y, model.layer_y.size - 1
    if last == 0:
        return 0.0, 0.0
    return (model.top - y[0]) / (y[0] - y[1]), (model.bottom - y[last]) / (y[last] - y[last - 1])


@kernel
def face_strains(s, levers, model, state, work):
    """Strain that the concrete has its stress from at the top and the bottom fibre of section s, for
    work.strain; what it strains by itself there is on the line through the two layers next to it."""
    free, last = state.concrete[:, FREE, s], model.layer_y.size - 1
    second, last_but_one = min(1, last), max(0, last - 1)
    top = free[0] + levers[0] * (free[0] - free[second])
    bottom = free[last] + levers[1] * (free[last] - free[last_but_one])
    eps0, kappa = work.strain[0, s], work.strain[1, s]
    return eps0 - model.top * kappa - top, eps0 - model.bottom * kappa - bottom
