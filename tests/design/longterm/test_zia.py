"""Zia et al. (1979): the formulas and their tables' marks, in the units of the paper."""

import pytest

from ptbatch.design.aci318 import PSI
from ptbatch.design.longterm.zia import creep, losses, relaxation, shrinkage

KSI = 1000.0 * PSI


def test_creep():
    assert creep(0.8 * KSI, 28_000 * KSI, 4_000 * KSI) / KSI == pytest.approx(1.6 * 7.0 * 0.8)  # closed form
    assert creep(-1.0, 28_000 * KSI, 4_000 * KSI) == 0.0


@pytest.mark.parametrize(
    ("days", "K_sh"), [(1, 0.92), (3, 0.85), (5, 0.80), (7, 0.77), (30, 0.58), (60, 0.45), (90, 0.45)]
)
def test_shrinkage(days, K_sh):
    """Closed form at the marks of the table: V/S 2 in, RH 70 %, 28,000 ksi."""
    found = shrinkage(28_000 * KSI, 2 * 25.4, 70.0, days) / KSI
    assert found == pytest.approx(8.2e-6 * K_sh * 28_000 * (1 - 0.12) * 30)


@pytest.mark.parametrize(
    ("ratio", "kind", "expected"),
    [
        (0.75, "low", (5.0 - 0.040 * 15.0) * 1.00),
        (0.70, "low", (5.0 - 0.040 * 15.0) * 0.75),
        (0.80, "low", (5.0 - 0.040 * 15.0) * 1.28),
        (0.55, "low", (5.0 - 0.040 * 15.0) * 0.33),  # below the table: its first entry
        (0.70, "normal", (20.0 - 0.15 * 15.0) * 1.00),
        (0.75, "normal", (20.0 - 0.15 * 15.0) * 1.45),
    ],
)
def test_relaxation(ratio, kind, expected):
    assert relaxation(ratio * 270 * KSI, 270 * KSI, 15 * KSI, kind) / KSI == pytest.approx(
        expected
    )  # closed form


def test_all_of_them():
    found = losses(
        0.3 * KSI, 0.65 * 270 * KSI, 270 * KSI, 28_000 * KSI, 4_000 * KSI, 4 * 25.4, 75.0, 7.0, "low"
    )
    CR, SH = 1.6 * 7.0 * 0.3, 8.2e-6 * 0.77 * 28_000 * (1 - 0.24) * 25
    assert (found.causes["creep"] / KSI, found.causes["shrinkage"] / KSI) == (
        pytest.approx(CR),
        pytest.approx(SH),
    )
    assert found.causes["relaxation"] / KSI == pytest.approx((5.0 - 0.040 * (CR + SH)) * 0.53)
    assert found.total == pytest.approx(
        found.causes["creep"] + found.causes["shrinkage"] + found.causes["relaxation"]
    )
