"""What a handful of members takes and gives, frozen: a change of either is to be seen and to be meant.

Beyond a crack that opens at once, round-off may decide which of two ways a member goes on: iterations, and of
some members the peak in its third digit. So each is analysed several times, with jacking stresses that differ
in the 13th digit; iterations are counted over all of these, and the peak is to be met as well as they agree.

After a change that is meant, `python -m tests.test_iterations` prints the numbers anew; the changelog names
it with its reason. Time is not judged here but by `python -m benchmarks.speed`.
"""

from functools import cache
from typing import NamedTuple

import pytest

from benchmarks.named import FOLLOWED, NAMED, REFERENCE
from ptbatch.analysis import analyse
from ptbatch.member import Member
from ptbatch.response import Response

EXACT = False  # whether a count must be met exactly, or may be exceeded by SLACK
SLACK = 1.4  # round-off differs between kinds of processors, and with it a count by up to 21 %
NUDGES = (0.0, 1e-13, -1e-13, 3e-13, -3e-13, 1e-12, -1e-12)
CHANGED = "frozen is {}: if that is meant, run `python -m tests.test_iterations` and tell in the changelog"


class Frozen(NamedTuple):
    """Iterations of all nudges; mean tendon stress after anchoring [MPa]; peak load [kN] and how far the
    nudges are from the first, on that of two kinds of processors where they are farther."""

    iterations: int
    anchored: float
    peak: float
    spread: float


FROZEN = {
    "15 m beam": Frozen(1180, 1267.678, 403.50018, 2e-03),
    "60 elements": Frozen(3551, 1267.6875, 400.82264, 5e-03),
    "bonded": Frozen(1743, 1267.678, 446.20612, 2e-13),
    "two jacks": Frozen(1120, 1218.5507, 397.19507, 1e-10),
    "two spans": Frozen(1188, 1252.051, 1176.2965, 5e-12),
    "four spans, no bars": Frozen(2820, 1178.7197, 2733.0572, 4e-10),
    "slab strip": Frozen(1723, 1229.1867, 73.594081, 1e-12),
}


@cache
def found(name: str) -> Frozen:
    """The same of an analysis now."""
    responses = [analyse(nudged(name, nudge)) for nudge in NUDGES]
    peaks = [peak(response) for response in responses]
    spread = max(abs(load / peaks[0] - 1.0) for load in peaks)
    iterations = sum(response.newton_iterations for response in responses)
    return Frozen(iterations, responses[0].tendon["anchored"].mean, peaks[0], spread)


def nudged(name: str, nudge: float) -> Member:
    """A member with its jacking stress moved by a share."""
    values = dict(NAMED[name])
    return Member(member=name, **values | {"fpj": values["fpj"] * (1.0 + nudge)})


def peak(response: Response) -> float:
    """Peak load [kN]."""
    event = response.event("peak")
    assert event is not None
    return event.load / 1e3


@pytest.mark.parametrize("name", FROZEN)
def test_iterations(name):
    wanted, iterations = FROZEN[name].iterations, found(name).iterations
    if EXACT:
        assert iterations == wanted, CHANGED.format(wanted)
    assert iterations <= SLACK * wanted, CHANGED.format(wanted)


@pytest.mark.parametrize("name", FROZEN)
def test_anchored_stress(name):
    wanted = FROZEN[name].anchored
    assert found(name).anchored == pytest.approx(wanted, rel=1e-6), CHANGED.format(wanted)


@pytest.mark.parametrize("name", FROZEN)
def test_peak(name):
    wanted, spread = FROZEN[name].peak, FROZEN[name].spread
    assert found(name).peak == pytest.approx(wanted, rel=max(1e-6, 2.0 * spread)), CHANGED.format(wanted)


def test_iterations_hardly_depend_on_the_mesh_short_of_yield():
    """Time then grows with the number of elements alone. 116 and 144 when this was written."""
    values = REFERENCE | {"deflection_limit": FOLLOWED}
    few, many = (analyse(Member(member="15 m beam", **values | {"elements": n})) for n in (20, 80))
    assert few.event("yield") is None
    assert many.newton_iterations <= SLACK * few.newton_iterations


if __name__ == "__main__":
    for member in NAMED:
        iterations, anchored, load, spread = found(member)
        print(f'    "{member}": Frozen({iterations}, {anchored:.8g}, {load:.8g}, {spread:.0e}),')
