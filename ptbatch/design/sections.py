"""Sections of a member as a check of bending needs them: seen from the compressed face."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.design.flexure import Strip
from ptbatch.design.longterm import TimeLoss
from ptbatch.design.moments import of_loads, secondary, stations
from ptbatch.geometry.profile import ideal_profile
from ptbatch.geometry.section import gross_section
from ptbatch.member import Bar, Member
from ptbatch.model.loading import has_service_value, live, self_weight, sustained
from ptbatch.response import ANCHORED, Response

Array = NDArray[np.float64]

SAGGING, HOGGING = 1, -1
NO_TIME = "without creep, shrinkage and relaxation of the tendon: give RH, or long_term_loss"


class Moments(NamedTuple):
    """Elastic moments [N mm] at stations x [mm]: of the self-weight, of all dead load, of the live load at
    its service value (zero where none was given), and secondary."""

    x: Array
    weight: Array
    dead: Array
    live: Array
    secondary: Array


@dataclass(frozen=True)
class Subject:
    """What is checked: a member, its analysis, the stress [MPa] that time takes off the tendon, and what that
    is made of where it was not given."""

    member: Member
    response: Response
    time_loss: float
    loss: TimeLoss | None = None

    @property
    def fse(self) -> float:
        """Mean effective stress of the tendon: after anchoring, less what time takes [MPa]."""
        return self.response.tendon[ANCHORED].mean - self.time_loss

    @property
    def timely(self) -> bool:
        """Whether anything is known of what time takes."""
        return self.loss is not None or self.member.long_term_loss is not None

    def effective(self, x: float) -> float:
        """The same at a place [MPa]."""
        state = self.response.tendon[ANCHORED]
        places = np.concatenate([[0.0], state.x, [self.member.total_length]])
        stresses = np.concatenate([state.anchor_stress[:1], state.stress, state.anchor_stress[1:]])
        return float(np.interp(x, places, stresses)) - self.time_loss

    @property
    def has_live(self) -> bool:
        """Whether there is a live load to check for."""
        return has_service_value(self.member)

    @cached_property
    def moments(self) -> Moments:
        """Moments at supports, at the nodes of the elements and where loads begin."""
        member = self.member
        weight, on = self_weight(member), live(member)
        dead = [*weight, *sustained(member)]
        x = stations(member, [*dead, *on], ())
        force = np.array([self.effective(place) for place in x]) * member.Aps
        primary = -force * (ideal_profile(member).depth(x) - gross_section(member).centroid)
        service = of_loads(member, x, on) if self.has_live else np.zeros_like(x)
        alone, all_dead = of_loads(member, x, weight), of_loads(member, x, dead)
        return Moments(x, alone, all_dead, service, secondary(member, x, primary))

    def strips(self, sense: int) -> list[Strip]:
        """Thickness and width from the compressed face on: the top where it sags."""
        section = gross_section(self.member)
        strips = list(zip(section.thickness.tolist(), section.width.tolist(), strict=True))
        return strips if sense == SAGGING else strips[::-1]

    def depth(self, depth: float, sense: int) -> float:
        """Depth below the compressed face of what lies so deep below the top fibre [mm]."""
        return depth if sense == SAGGING else self.member.h - depth

    def tendon_depth(self, x: float, sense: int) -> float:
        """Depth of the tendon below the compressed face [mm]."""
        return self.depth(float(ideal_profile(self.member).depth(x)), sense)

    def bars(self, x: float) -> list[Bar]:
        """Bars at a place."""
        member = self.member
        own = zip(member.As + member.As_top, member.ds + member.ds_top, strict=True)
        whole = [Bar(0.0, member.total_length, depth, area, member.fy) for area, depth in own if area > 0.0]
        return [*whole, *(bar for bar in member.bars if bar.x_start <= x <= bar.x_end)]

    def span_at(self, x: float) -> float:
        """Length of the longest span that a place belongs to [mm]."""
        ends = zip(self.member.support_x, self.member.support_x[1:], strict=False)
        return max(b - a for a, b in ends if a - 1e-6 <= x <= b + 1e-6)
