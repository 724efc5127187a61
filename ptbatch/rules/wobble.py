"""Wobble: given once; as waves on the profile it must have an angle, a mesh fine enough and room."""

from collections.abc import Iterator
from math import ceil
from types import SimpleNamespace

import numpy as np

from ptbatch.geometry.profile import ideal_profile, tendon_profile
from ptbatch.geometry.wobble import FEWEST, stretches
from ptbatch.rules.fault import Fault, Rule, Values, rule
from ptbatch.rules.mesh import elements_bearable
from ptbatch.rules.tendon import path_is_sound
from ptbatch.tendon_losses import PATH

DIRECT = "take wobble = direct: the same friction, per length of tendon"


@rule("k_ec2", "given")
def wobble_given_once(v: Values) -> Iterator[Fault]:
    """K or k_ec2."""
    if "K" in v["given"]:
        yield Fault("k_ec2", v["k_ec2"], "both K and k_ec2 are given", "leave one blank: K = mu k_ec2")


@rule("wobble", "mu", "K")
def waves_have_friction(v: Values) -> Iterator[Fault]:
    """Waves make the friction of K by their angle, which needs mu."""
    if v["wobble"] == "sine" and v["mu"] == 0.0 < v["K"]:
        wrong = "without curvature friction mu no waves make the friction of K"
        yield Fault("wobble", "sine", wrong, f"give mu, or {DIRECT}")


@rule(*PATH, "wobble", "mu", "K", "elements")
def waves_resolved(v: Values) -> Iterator[Fault]:
    """Each stretch between breaks of the profile has the elements for its waves."""
    if not _has_waves(v):
        return
    parts = stretches(ideal_profile(SimpleNamespace(**v)), v["span"], v["elements"])
    part = min(parts, key=lambda part: part.length / part.element)
    needed = ceil((FEWEST - 1e-9) * v["elements"] * part.element / part.length)
    if needed > v["elements"]:
        place = f"x = {part.start:g} to {part.stop:g} mm, {part.length / part.element:.1f} elements"
        wrong = f"too few for waves on the part of the profile from {place}"
        yield Fault("elements", v["elements"], wrong, f"give at least {needed}, or {DIRECT}")


@rule(*PATH, "wobble", "mu", "K", "elements")
def waves_fit(v: Values) -> Iterator[Fault]:
    """The waves are no steeper than wobble can be and stay inside the section."""
    if not _has_waves(v) or waves_resolved(v):
        return
    cure = f"give more elements, which make the waves shorter and lower, or {DIRECT}"
    try:
        profile = tendon_profile(SimpleNamespace(**v))
    except ValueError as steep:
        yield Fault("wobble", "sine", str(steep).removeprefix("wobble: "), cure)
        return
    x = np.linspace(0.0, sum(v["span"]), 1 + 20 * v["elements"] * len(v["span"]))
    depth = profile.depth(x)
    over = np.maximum(-depth, depth - v["h"])
    if over.max() >= 0.0:
        at = int(np.argmax(over))
        wrong = f"waves for K / mu take the tendon to a depth of {depth[at]:.4g} mm at x = {x[at]:.4g} mm"
        yield Fault("wobble", "sine", f"{wrong}, outside the section", cure)


def _has_waves(v: Values) -> bool:
    wanted = v["wobble"] == "sine" and v["mu"] and v["K"]
    return bool(wanted and path_is_sound(v) and not elements_bearable(v))


RULES: tuple[Rule, ...] = (wobble_given_once, waves_have_friction, waves_resolved, waves_fit)
