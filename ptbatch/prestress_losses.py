"""What takes the tendon's stress, cause by cause, from the jack to the live load."""

from collections.abc import Iterator
from typing import NamedTuple

from ptbatch.response import ANCHORED, JACKED, SERVICE, SET, Response

NOTHING = 1e-9  # of the stress: round-off


class Loss(NamedTuple):
    """A cause: where it comes from, what it takes of the mean stress and what is left then [MPa]."""

    cause: str
    source: str
    loss: float
    left: float


def losses_by_cause(response: Response) -> Iterator[Loss]:
    """In the order in which they act, as far as the member came; negative where stress is gained."""
    left = response.fpj
    analysed = "analysis"
    for cause, stage in (("friction and wobble", JACKED), ("wedge set", SET), ("anchoring", ANCHORED)):
        if stage not in response.tendon:
            return
        mean = response.tendon[stage].mean
        lost = left - mean
        yield Loss(cause, analysed, lost if abs(lost) > NOTHING * response.fpj else 0.0, mean)
        left = mean
        if stage == JACKED:
            shortening = "none: all strands are pulled at once, and the jack measures it"
            yield Loss("elastic shortening", shortening, 0.0, mean)
    if response.time_loss is None or SERVICE not in response.tendon:
        return
    effective = response.tendon[SERVICE].mean
    before = effective + response.time_loss.total
    yield Loss("sustained load", analysed, left - before, before)
    left = before
    for cause, loss in response.time_loss.causes.items():
        left -= loss
        yield Loss(cause, response.time_loss.clause, loss, left)
