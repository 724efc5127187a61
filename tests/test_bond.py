"""Bond between none and full: friction goes on acting in service."""

import numpy as np
import pytest

from ptbatch.analysis import analyse
from ptbatch.member import Member
from tests.members import SMALL

BEAM = SMALL | dict(
    K=0.0, set=0.0, fpj=900, As=300, ds=450, As_top=(), ds_top=(), live="third-points", deflection_limit=40
)  # fmt: skip
STRAIGHT = BEAM | dict(profile="straight", dp=400)


def at_limit(values, **changes):
    """The tendon at the largest load, that at the deflection limit, and the load [kN]."""
    response = analyse(Member(**values | changes))
    assert response.failure == "deflection limit"
    return response.tendon["peak"], response.event("peak").load / 1e3


def test_a_perfectly_unbonded_tendon_has_one_stress():
    tendon, _ = at_limit(BEAM, mu=0.0)
    assert tendon.most == pytest.approx(tendon.least, rel=1e-6)
    assert tendon.mean > 1.2 * 900


@pytest.mark.parametrize("values", [BEAM, STRAIGHT], ids=["parabola", "straight"])
def test_friction_makes_the_stress_differ_along_the_member(values):
    """A straight tendon has no friction until the member bends it."""
    tendon, _ = at_limit(values, mu=0.3)
    anchored = analyse(Member(**values | dict(mu=0.3))).tendon["anchored"]
    crown = int(np.argmax(tendon.stress))
    assert tendon.most - tendon.least > 3.0
    assert 0 < crown < len(tendon.stress) - 1 or values is BEAM
    assert tendon.most - tendon.least != pytest.approx(anchored.most - anchored.least, rel=0.1)


def test_ever_more_friction_approaches_bond():
    """Load at the same deflection, and the least stress, which bond keeps near that after anchoring."""
    gaps = []
    for mu in (0.0, 3.0, 10.0, 30.0):
        loose, stuck = (at_limit(STRAIGHT, mu=mu, bond=bond) for bond in ("unbonded", "bonded"))
        gaps.append((stuck[1] - loose[1], loose[0].least - stuck[0].least))
    for gap in zip(*gaps, strict=True):
        assert all(after < before for before, after in zip(gap, gap[1:], strict=False))
    assert gaps[-1][0] < gaps[0][0] / 3.0
