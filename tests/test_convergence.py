"""Refinement of mesh, layers and steps: the answer converges, in the order that they promise."""

from functools import cache

import numpy as np
import pytest

from ptbatch import Member, Response, analyse
from tests.members import ELASTIC, IMAGINARY

FRICTIONLESS = IMAGINARY | ELASTIC | dict(mu=0.0, K=0.0, set=0.0)
GROUTED = dict(
    member="grouted", span=8000, b=300, h=600, fc=40, Aps=600, dp=(300, 500, 300), fpj=1300, set=6, mu=0.15,
    K=1e-6, As=600, ds=550, bond="bonded", live="uniform", w_live=10,
)  # fmt: skip
BELOW_YIELD = 100e3  # N, between cracking and yield


@cache
def grouted(refine: int = 1, **mesh: object) -> Response:
    return analyse(Member(**GROUTED | mesh), refine=refine)


def deflection(response: Response, load: float) -> float:
    """At a load on the rising branch."""
    rising = slice(0, int(response.curve.load.argmax()))
    return float(np.interp(load, response.curve.load[rising], response.curve.deflection[rising]))


def orders(values: list[float]) -> np.ndarray:
    """Observed orders of convergence from values on meshes that are each twice as fine as the one before."""
    change = np.abs(np.diff(values))
    return np.log2(change[:-1] / change[1:])


@pytest.mark.parametrize("sheathing", ["smooth", "polygon"])
def test_camber_is_of_second_order_in_the_mesh(sheathing):
    duct = FRICTIONLESS | dict(sheathing=sheathing)
    camber = [analyse(Member(**duct | dict(elements=n))).camber for n in (6, 12, 24, 48)]
    assert orders(camber) == pytest.approx(2.0, abs=0.1)


def test_camber_is_of_second_order_in_the_layers():
    camber = [analyse(Member(**FRICTIONLESS | dict(layers=n))).camber for n in (10, 20, 40)]
    assert orders(camber) == pytest.approx(2.0, abs=0.1)  # the midpoint rule


@pytest.mark.parametrize("mesh", ["elements", "layers"])
def test_deflection_of_a_cracked_beam_is_of_second_order(mesh):
    numbers = {"elements": (5, 10, 20), "layers": (10, 20, 40)}[mesh]
    found = [deflection(grouted(4, **{mesh: n}), BELOW_YIELD) for n in numbers]
    assert orders(found) == pytest.approx(2.0, abs=0.3)  # it is interpolated between steps


@pytest.mark.parametrize(
    "finer", [dict(elements=40), dict(elements=80), dict(layers=80), dict(refine=2), dict(refine=4)], ids=str
)
def test_peak_of_a_member_with_bars_does_not_depend_on_the_mesh(finer):
    assert grouted(**finer).event("peak").load == pytest.approx(grouted().event("peak").load, rel=2e-3)
