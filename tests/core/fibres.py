"""One concrete fibre: its law, its stress, its history."""

import numpy as np

from ptbatch.core.concrete import commit_fibres, fibres
from ptbatch.member import Member
from ptbatch.model.materials import concrete

LAWS = ("hognestad", "parabola-rectangle", "popovics", "elastic")
TENSIONS = ("none", "softening", "stiffening")
EC, FT = 30000.0, 3.0
EPS_CR = FT / EC


def law(concrete_law="hognestad", tension_law="stiffening", fc=40.0, **more):
    values = dict(member="C", span=8000, b=300, h=600, Aps=100, dp=(300, 500, 300), fpj=1000)
    laws = dict(fc=fc, Ec=EC, ft=FT, concrete_law=concrete_law, tension_law=tension_law)
    return concrete(Member(**values | laws | more))


def fibre(eps, c, past=None):
    """(stress, modulus) [MPa]."""
    found = np.zeros((2, 1))
    past = np.zeros(6) if past is None else past
    fibres(0.0, np.array([eps]), np.zeros(1), past.reshape(6, 1), c, found[0], found[1])
    return found[:, 0]


def stress(eps, c, past=None):
    """Stress [MPa]."""
    return fibre(eps, c, past)[0]


def modulus(eps, c, past=None):
    """Modulus [MPa]."""
    return fibre(eps, c, past)[1]


def history(c, *strains):
    """History of a fibre that has been to these strains."""
    past = np.zeros(6)
    for eps in strains:
        commit(eps, past, c)
    return past


def commit(eps, past, c):
    """Move the history of a fibre on."""
    commit_fibres(0.0, np.array([eps]), np.zeros(1), past.reshape(6, 1), c)
