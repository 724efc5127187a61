"""Rules between the values of a member, by subject: each a small function from values to faults."""

from ptbatch.rules import loads, materials, mesh, plausible, section, supports, tendon, wobble
from ptbatch.rules.fault import Rule

RULES: tuple[Rule, ...] = (
    *supports.RULES,
    *section.RULES,
    *materials.RULES,
    *mesh.RULES,
    *tendon.RULES,
    *wobble.RULES,
    *loads.RULES,
)
WARNINGS: tuple[Rule, ...] = (
    *supports.WARNINGS,
    *section.WARNINGS,
    *loads.WARNINGS,
    *plausible.WARNINGS,
)
