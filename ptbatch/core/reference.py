"""Hand a tuple of arrays through the kernels as one pointer.

A named tuple with dozens of arrays is copied field by field at every call, and numba counts who looks at each
of its arrays, which takes longer than looking. A `Reference` is where such a tuple lies in memory: what a
kernel takes from a field is neither copied nor counted, and a tuple of arrays in it is a reference again. The
fields, though not what is in the arrays, stay as they are for good, so that the compiler need not look again.
"""

import hashlib
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from numba import typeof
from numba._dispatcher import compute_fingerprint
from numba.core import cgutils, types
from numba.core.datamodel import models
from numba.core.typing.templates import AttributeTemplate
from numba.extending import (
    NativeValue,
    infer_getattr,
    intrinsic,
    lower_getattr_generic,
    register_model,
    typeof_impl,
    unbox,
)

from ptbatch.core.jit import kernel


class ReferenceType(types.Type):
    """Pointer to a tuple with arrays in it. Its name goes into the names of all compiled functions and is
    short for that."""

    def __init__(self, content: Any) -> None:
        self.content = content
        digest = hashlib.sha256(str(content).encode()).hexdigest()[:12]
        super().__init__(f"{content.instance_class.__name__}_{digest}")

    def field(self, name: str) -> tuple[int, Any]:
        """Place and type of a field."""
        place = self.content.fields.index(name)
        return place, self.content.types[place]


register_model(ReferenceType)(models.OpaqueModel)


def has_arrays(kind: Any) -> bool:
    """Whether a type is a tuple with an array somewhere in it."""
    parts = getattr(kind, "types", ()) if isinstance(kind, types.BaseNamedTuple) else ()
    return any(isinstance(part, types.Array) or has_arrays(part) for part in parts)


class Reference:
    """What Python holds of a tuple that kernels are to take by reference; it keeps its arrays alive."""

    def __init__(self, values: Any) -> None:
        self.values, (self.kind, size) = values, _kind_and_size(values)
        self.memory = np.empty(size, np.uint8)
        self.address = self.memory.ctypes.data
        _put(self.address, values)


_known: dict[bytes, tuple[ReferenceType, int]] = {}


def _kind_and_size(values: Any) -> tuple[ReferenceType, int]:
    """Of a tuple's reference and, in bytes, of the tuple: looking at all its arrays takes most of a
    millisecond, and nearly all members are of one kind."""
    fingerprint = compute_fingerprint(values)
    if fingerprint not in _known:
        _known[fingerprint] = ReferenceType(typeof(values)), _size(values)
    return _known[fingerprint]


@typeof_impl.register(Reference)
def _typeof(reference: Reference, context: Any) -> ReferenceType:
    return reference.kind


@unbox(ReferenceType)
def _unboxed(kind: ReferenceType, reference: Any, c: Any) -> NativeValue:
    number = c.pyapi.object_getattr_string(reference, "address")
    pointer = c.pyapi.long_as_voidptr(number)
    c.pyapi.decref(number)
    return NativeValue(pointer)


@infer_getattr
class _Fields(AttributeTemplate):
    key = ReferenceType

    def generic_resolve(self, kind: Any, name: Any) -> Any:  # type: ignore[override]
        """Type of a field."""
        if name not in kind.content.fields:
            return None
        _, part = kind.field(name)
        return ReferenceType(part) if has_arrays(part) else part


@lower_getattr_generic(ReferenceType)
def _field(context: Any, builder: Any, kind: ReferenceType, pointer: Any, name: str) -> Any:
    """A field's value, or a pointer to it where it has arrays in it."""
    place, part = kind.field(name)
    content = builder.bitcast(pointer, context.get_value_type(kind.content).as_pointer())
    at = cgutils.gep_inbounds(builder, content, 0, place)
    if has_arrays(part):
        return builder.bitcast(at, cgutils.voidptr_t)
    return _array(context, builder, part, at) if isinstance(part, types.Array) else _fixed(builder, at)


def _array(context: Any, builder: Any, kind: Any, at: Any) -> Any:
    """The array that is described there, as one that belongs to nobody."""
    array = context.make_array(kind)(context, builder)
    fields = context.data_model_manager[kind]._fields
    itemsize = context.get_abi_sizeof(context.get_data_type(kind.dtype))

    def numbers(name: str) -> list[Any]:
        found = cgutils.gep_inbounds(builder, at, 0, fields.index(name))
        return [_fixed(builder, cgutils.gep_inbounds(builder, found, 0, axis)) for axis in range(kind.ndim)]

    strides = numbers("strides")
    array.itemsize = context.get_constant(types.intp, itemsize)
    if kind.layout == "C":
        strides[-1] = array.itemsize
    array.meminfo = cgutils.get_null_value(array.meminfo.type)
    array.parent = cgutils.get_null_value(array.parent.type)
    array.nitems = _fixed(builder, cgutils.gep_inbounds(builder, at, 0, fields.index("nitems")))
    array.data = _fixed(builder, cgutils.gep_inbounds(builder, at, 0, fields.index("data")))
    array.shape = cgutils.pack_array(builder, numbers("shape"))
    array.strides = cgutils.pack_array(builder, strides)
    return array._getvalue()


def _fixed(builder: Any, at: Any) -> Any:
    """What stands there and will not change."""
    value = builder.load(at)
    value.set_metadata("invariant.load", builder.module.add_metadata([]))
    return value


def _size_in_memory(typing: Any, values: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return context.get_constant(types.intp, context.get_abi_sizeof(context.get_value_type(values)))

    return types.intp(values), build


def _put_in_memory(typing: Any, address: Any, values: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        to = builder.inttoptr(arguments[0], context.get_value_type(values).as_pointer())
        for path in _leaves(values):
            at = cgutils.gep_inbounds(builder, to, 0, *path)
            builder.store(builder.extract_value(arguments[1], path), at)
        return context.get_dummy_value()

    return types.void(types.intp, values), build


def _leaves(kind: Any) -> Iterator[tuple[int, ...]]:
    """Where the fields without arrays in them, and the arrays, are in a tuple of tuples."""
    for place, part in enumerate(kind.types):
        within: Iterable[tuple[int, ...]] = _leaves(part) if has_arrays(part) else ((),)
        yield from ((place, *path) for path in within)


size_in_memory: Any = intrinsic(_size_in_memory)
put_in_memory: Any = intrinsic(_put_in_memory)


@kernel
def _size(values):
    """Bytes that a tuple takes."""
    return size_in_memory(values)


@kernel
def _put(address, values):
    """Write a tuple to where it is to lie."""
    put_in_memory(address, values)
