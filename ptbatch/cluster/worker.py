"""What a worker of a cluster does: plain values of members in, plain values of outcomes out.

With the rows comes what their digits depend on. A worker that has something else analyses nothing and says
so.
"""

import hashlib
import platform
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.metadata import version
from pathlib import Path
from threading import Lock
from typing import Any

from ptbatch import __version__
from ptbatch.member import Member
from ptbatch.runner import engine
from ptbatch.validation import TABLES
from ptbatch.workbook.results import Outcome

Values = dict[str, Any]
PACKAGE = Path(__file__).parent.parent
LIBRARIES = ("numba", "numpy", "scipy")

_engine = cache(engine)
_importing = Lock()  # the threads of a worker start at once, and one of them imports the analysis


def analyse_rows(wanted: Mapping[str, str], rows: Sequence[Values]) -> dict[str, Any]:
    """Outcomes of members by `values`, none where this machine is not as wanted; and what it is."""
    from distributed import get_worker

    mine = identity()
    outcomes = list(map(_analyse, rows)) if mine == wanted else []
    return {"worker": get_worker().address, "identity": mine, "outcomes": [vars(each) for each in outcomes]}


def _analyse(row: Values) -> Outcome:
    with _importing:
        run = _engine()
    return run(member(row))


@cache
def identity() -> dict[str, str]:
    """What the digits of a result depend on: versions, and a digest of all sources."""
    digest = hashlib.sha256()
    for path in sorted(PACKAGE.rglob("*.py")):
        digest.update(path.read_bytes().replace(b"\r\n", b"\n"))
    return {
        "ptbatch": __version__,
        "source": digest.hexdigest()[:12],
        "Python": ".".join(platform.python_version_tuple()[:2]),
        **{name: version(name) for name in LIBRARIES},
    }


def values(member: Member) -> Values:
    """A member as plain values."""
    own = {name: getattr(member, name) for name in Member.__dataclass_fields__}
    return own | {name: [tuple(row) for row in own[name]] for name in TABLES}


def member(values: Values) -> Member:
    """The member of such values, which are sound and are not examined again."""
    tables = {name: tuple(make(*row) for row in values[name]) for name, (make, _) in TABLES.items()}
    made = object.__new__(Member)
    made.__dict__.update(values | tables)
    return made
