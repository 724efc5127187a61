"""Rules between the values of a member, by subject: each a small function from values to faults."""

from ptbatch.rules import loads, materials, section, supports, tendon
from ptbatch.rules.fault import Rule

RULES: tuple[Rule, ...] = (
    *supports.RULES,
    *section.RULES,
    *materials.RULES,
    *tendon.RULES,
    *loads.RULES,
)
WARNINGS: tuple[Rule, ...] = (*supports.WARNINGS, *section.WARNINGS, *loads.WARNINGS)
