"""What an outcome depends on, as a key: every value of the member, and the program."""

import hashlib
import json
from dataclasses import fields
from functools import cache
from pathlib import Path

from ptbatch import __version__
from ptbatch.core.cache import source_key
from ptbatch.journal.records import KEY
from ptbatch.member import Member

PACKAGE = Path(__file__).parent.parent


def member_key(member: Member) -> bytes:
    """Sixteen bytes that are the same for the same member, settings and defaults included, and program."""
    values = [[field.name, getattr(member, field.name)] for field in fields(member)]
    return hashlib.sha256(_program() + json.dumps(values).encode()).digest()[:KEY]


@cache
def _program() -> bytes:
    """Version, kernels with their compiler, and every source file: also what a developer has just changed."""
    digest = hashlib.sha256(f"{__version__} {source_key()}".encode())
    for path in sorted(PACKAGE.rglob("*.py")):
        digest.update(str(path.relative_to(PACKAGE)).encode())
        digest.update(path.read_bytes())
    return digest.digest()
