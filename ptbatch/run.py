"""One pass of a member through the stages, from its preparation to its record."""

from dataclasses import dataclass

from ptbatch.losses import Losses
from ptbatch.model.arrays import Setup
from ptbatch.model.duct import TendonStart
from ptbatch.stages import Rig


@dataclass(frozen=True)
class Run:
    """What a pass works on: the member set up, its rig with the record of its steps, where the tendon starts,
    and the jacking stress [MPa] with its analytic losses."""

    setup: Setup
    rig: Rig
    start: TendonStart
    losses: Losses
    fpj: float
