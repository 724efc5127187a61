"""Batch analysis of post-tensioned concrete members.

    from ptbatch import Member, analyse
    beam = Member(member="B1", span=12000, b=300, h=600, fc=40, Aps=592, dp=(300, 500, 300), fpj=1395)
    response = analyse(beam)

Units are N, mm, MPa and radians. The four names are loaded when they are first used, so that `import ptbatch`
costs nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ptbatch.analysis import analyse as analyse
    from ptbatch.member import Member as Member
    from ptbatch.member import MemberError as MemberError
    from ptbatch.response import Response as Response

__version__ = "0.1.0"
__all__ = ["Member", "MemberError", "Response", "analyse"]

_HOMES = {
    "Member": "ptbatch.member",
    "MemberError": "ptbatch.member",
    "Response": "ptbatch.response",
    "analyse": "ptbatch.analysis",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'ptbatch' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
