"""Hand a tuple of arrays through the kernels as one pointer.

A named tuple with dozens of arrays is copied field by field at every call, which costs more to compile than
all the mechanics. `reference(Tuple)` makes a numba structure with the tuple's fields; a kernel turns one into
the other by `Reference(*values)`. The arrays are shared, not copied.
"""

import sys
from typing import Any

from numba.core import types
from numba.experimental import structref


def reference(fields: type, name: str) -> Any:
    """The structure class `name` with the fields of a NamedTuple, registered in the tuple's module so that
    the compile cache finds it."""
    module = sys.modules[fields.__module__]

    def preprocess_fields(self: Any, given: Any) -> Any:
        return tuple((field, types.unliteral(kind)) for field, kind in given)

    kind = type(name + "Type", (types.StructRef,), {"preprocess_fields": preprocess_fields})
    proxy = type(name, (structref.StructRefProxy,), {})
    for made in (kind, proxy):
        made.__module__ = module.__name__
        setattr(module, made.__name__, made)
    structref.register(kind)
    structref.define_proxy(proxy, kind, list(fields._fields))  # type: ignore[attr-defined]
    return proxy
