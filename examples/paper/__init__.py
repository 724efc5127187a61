"""The paper's numerical studies and the closed forms behind them: members, and what is known of each."""

from collections.abc import Iterator

from examples.paper.bond import bond
from examples.paper.closed_forms import closed_forms, fan, tendon_of_90_ft
from examples.paper.entries import HEADERS as PUBLISHED_HEADERS
from examples.paper.figures import HEADERS as FIGURE_HEADERS
from examples.paper.figures import figure_rows
from examples.paper.findings import findings
from examples.paper.known_answers import known_answers
from examples.paper.members import Row, cooke_slabs, imaginary_beam, specimens, tao_and_du
from examples.paper.members import specimen_2_with_every_bond as loaded_specimen
from examples.paper.table_1 import table_1
from examples.paper.waves import profile_rows as wavy_profiles
from examples.paper.waves import specimens_with_one_sine

__all__ = [
    "FIGURE_HEADERS",
    "PUBLISHED_HEADERS",
    "figure_rows",
    "paper_members",
    "profile_rows",
    "published_rows",
]


def paper_members() -> list[Row]:
    """Rows of the sheet `members` of `paper.xlsx`."""
    return [
        *imaginary_beam(),
        *specimens(),
        *specimens_with_one_sine(),
        *loaded_specimen(),
        *tao_and_du(),
        *cooke_slabs(),
        *closed_forms(),
    ]


def profile_rows() -> Iterator[Row]:
    """Rows of its sheet `profile`."""
    member = tendon_of_90_ft()["member"]
    for x, depth in fan():
        yield {"member": member, "x [ft]": x, "dp [ft]": depth}
    yield from wavy_profiles()


def published_rows() -> list[Row]:
    """Rows of the sheet `published` of `paper-published.xlsx`."""
    return [*table_1(), *findings(), *bond(), *known_answers()]
