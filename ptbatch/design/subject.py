"""What is checked: a member, its analysis, its elastic moments, and its sections seen from the compressed
face."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ptbatch.design.flexure import Strip
from ptbatch.design.moments import of_loads, reactions, secondary, shears, stations
from ptbatch.geometry.curve import Profile, Side
from ptbatch.geometry.profile import ideal_profile
from ptbatch.geometry.section import Section, gross_section
from ptbatch.member import Bar, Load, Member
from ptbatch.model.loading import by_span, has_service_value, live, self_weight, sustained
from ptbatch.response import ANCHORED, Response

Array = NDArray[np.float64]

SAGGING, HOGGING = 1, -1
TOLD = 6  # every so many stations
SIDES: tuple[Side, Side] = ("left", "right")
NO_TIME = "without creep, shrinkage and relaxation of the tendon: give RH, or long_term_loss"

Combination = tuple[float, float]  # factors of dead and live load; secondary moments count once


class Moments(NamedTuple):
    """Elastic moments [N mm] at stations x [mm]: of the self-weight, of all dead load, of the live load at
    its service value (zero where none was given) and of that load on the spans where it makes the largest and
    the least moment, primary (- P e) and secondary ones of the prestress. told: which of the stations a table
    shows."""

    x: Array
    weight: Array
    dead: Array
    live: Array
    live_most: Array
    live_least: Array
    primary: Array
    secondary: Array
    told: list[int]

    def live_for(self, sense: int) -> Array:
        """Live load where it makes the largest moment of a sense."""
        return self.live_most if sense == SAGGING else self.live_least


@dataclass(frozen=True)
class Subject:
    """What is checked: a member and its analysis."""

    member: Member
    response: Response

    @property
    def time_loss(self) -> float:
        """What time takes off the tendon's stress [MPa]; zero where nothing is known of it."""
        return self.response.time_loss.total if self.response.time_loss else 0.0

    @property
    def fse(self) -> float:
        """Mean effective stress of the tendon: after anchoring, less what time takes [MPa]."""
        return self.response.tendon[ANCHORED].mean - self.time_loss

    @property
    def timely(self) -> bool:
        """Whether anything is known of what time takes."""
        return self.response.time_loss is not None

    @property
    def doubt(self) -> str:
        """What is not known, so that nothing can be passed in the ultimate limit state; else empty."""
        missing = [] if self.has_live else ["no service live load is given"]
        return "; ".join([*missing, *([] if self.timely else [NO_TIME])])

    def combinations(self, usual: Sequence[Combination]) -> Sequence[Combination]:
        """Factors of dead and live load: the standard's, or the member's own."""
        dead, live = self.member.factor_dead, self.member.factor_live
        return usual if dead is None or live is None else ((dead, 0.0), (dead, live))

    def effective(self, x: float) -> float:
        """Effective stress of the tendon at a place [MPa]."""
        return float(np.interp(x, *self._anchored)) - self.time_loss

    @cached_property
    def _anchored(self) -> tuple[Array, Array]:
        """Places [mm] and stresses [MPa] of the tendon after anchoring, anchors included."""
        state = self.response.tendon[ANCHORED]
        places = np.concatenate([[0.0], state.x, [self.member.total_length]])
        return places, np.concatenate([state.anchor_stress[:1], state.stress, state.anchor_stress[1:]])

    @cached_property
    def anchored(self) -> Array:
        """Stress of the tendon after anchoring at the stations of the moments [MPa]."""
        return np.asarray(np.interp(self._stations, *self._anchored))

    @cached_property
    def profile(self) -> Profile:
        """Of the tendon, without wobble."""
        return ideal_profile(self.member)

    @cached_property
    def section(self) -> Section:
        """The gross section."""
        return gross_section(self.member)

    @cached_property
    def eccentricity(self) -> Array:
        """Of the tendon at the stations of the moments, below the centroid positive [mm]."""
        return self.profile.depth(self._stations) - self.section.centroid

    @property
    def has_live(self) -> bool:
        """Whether there is a live load to check for."""
        return has_service_value(self.member)

    @cached_property
    def moments(self) -> Moments:
        """Moments at stations between the supports and where loads begin."""
        member = self.member
        weight, x = self_weight(member), self._stations
        dead = [*weight, *sustained(member)]
        primary = -(self.anchored - self.time_loss) * member.intact_area * self.eccentricity
        parts = self.live_parts[0]
        most, least = (np.sum(clip(parts, 0.0), axis=0) for clip in (np.maximum, np.minimum))
        alone, all_dead = of_loads(member, x, weight), of_loads(member, x, dead)
        near = [int(np.abs(x - place).argmin()) for place in member.support_x]
        told = sorted({*range(0, len(x), TOLD), *near})
        lives = parts.sum(axis=0), most, least
        return Moments(x, alone, all_dead, *lives, primary, secondary(member, x, primary), told)

    @cached_property
    def _stations(self) -> Array:
        member = self.member
        return stations(member, [*self_weight(member), *sustained(member), *live(member)], ())

    @cached_property
    def live_parts(self) -> tuple[Array, Array]:
        """Moments (spans, stations) [N mm] and shears (spans, stations, 2) [N] of the live load on one span
        after the other."""
        member, x = self.member, self._stations
        spans = by_span(member, live(member) if self.has_live else [])
        m = [of_loads(member, x, on) if on else np.zeros_like(x) for on in spans]
        v = [shears(x, moments, on) for moments, on in zip(m, spans, strict=True)]
        return np.array(m), np.array(v)

    @cached_property
    def loads(self) -> dict[str, list[Load]]:
        """Self-weight, all dead load, the live load at its service value; none of the secondary moments."""
        weight = self_weight(self.member)
        on = live(self.member) if self.has_live else []
        return {
            "self_weight": weight,
            "dead": [*weight, *sustained(self.member)],
            "live": on,
            "secondary": [],
        }

    @cached_property
    def _by_cause(self) -> dict[str, Array]:
        m = self.moments
        return {"self_weight": m.weight, "dead": m.dead, "live": m.live, "secondary": m.secondary}

    @cached_property
    def shears(self) -> dict[str, Array]:
        """Shear forces (stations, 2) [N] by cause, just left and just right of the stations."""
        return {name: shears(self.moments.x, m, self.loads[name]) for name, m in self._by_cause.items()}

    @cached_property
    def reactions(self) -> dict[str, Array]:
        """Reactions (supports,) [N] by cause, upward positive."""
        x = self.moments.x
        return {name: reactions(self.member, x, m, self.loads[name]) for name, m in self._by_cause.items()}

    def strips(self, sense: int) -> list[Strip]:
        """Thickness and width from the compressed face on: the top where it sags."""
        section = self.section
        strips = list(zip(section.thickness.tolist(), section.width.tolist(), strict=True))
        return strips if sense == SAGGING else strips[::-1]

    def depth(self, depth: float, sense: int) -> float:
        """Depth below the compressed face of what lies so deep below the top fibre [mm]."""
        return depth if sense == SAGGING else self.member.h - depth

    def tendon_depth(self, x: float, sense: int) -> float:
        """Depth of the tendon below the compressed face [mm]."""
        return self.depth(float(self.profile.depth(x)), sense)

    def slope(self, x: float) -> float:
        """Slope of the tendon, falling to the right positive; the mean of both sides at a kink."""
        profile = self.profile
        before, after = (float(profile.slope(np.array(x), side)) for side in SIDES)
        return 0.5 * (before + after)

    @property
    def middle(self) -> float:
        """The middle of the longest span [mm]."""
        member = self.member
        longest = max(range(len(member.span)), key=lambda i: member.span[i])
        return member.support_x[longest] + 0.5 * member.span[longest]

    def bars(self, x: float) -> list[Bar]:
        """Bars at a place."""
        near = 1e-9 * self.member.total_length
        return [bar for bar in self.member.all_bars if bar.x_start - near <= x <= bar.x_end + near]

    def span_at(self, x: float) -> float:
        """Length of the longest span that a place belongs to [mm]."""
        ends = zip(self.member.support_x, self.member.support_x[1:], strict=False)
        return max(b - a for a, b in ends if a - 1e-6 <= x <= b + 1e-6)
