"""Hand a tuple of arrays through the kernels as one pointer.

A named tuple with dozens of arrays is copied field by field at every call, which costs more to compile than
all the mechanics. `reference(Tuple)` makes a numba structure with the tuple's fields; a kernel turns one into
the other by `Reference(*lent(values))`. The arrays are shared, not copied, and not counted either: counting
who looks at an array would take as long as looking. So whoever opens a case has to hold its arrays.
"""

import sys
from typing import Any

from numba.core import cgutils, types
from numba.experimental import structref
from numba.extending import intrinsic


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


def _lent(context: Any, values: Any) -> Any:
    """The same tuple, whose arrays belong to nobody."""

    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        (fields,) = arguments
        for i, kind in enumerate(values.types):
            if isinstance(kind, types.Array):
                array = context.make_array(kind)(context, builder, builder.extract_value(fields, i))
                array.meminfo = cgutils.get_null_value(array.meminfo.type)
                array.parent = cgutils.get_null_value(array.parent.type)
                fields = builder.insert_value(fields, array._getvalue(), i)
        return fields

    return values(values), build


lent: Any = intrinsic(_lent)
