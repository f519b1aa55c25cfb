"""How a type lies in the memory of a PC, as `bgi.turboc.runtime.plaindata` is told it."""

from __future__ import annotations

from bgi.turboc.checker.typed import Converted, Value
from bgi.turboc.checker.types import (
    ArrayType,
    FloatType,
    IntType,
    PointerType,
    StructType,
    Type,
    VoidType,
    innermost,
)

_INTEGERS = {8: "b", 16: "h", 32: "i"}
_REALS = {32: "f", 64: "d", 80: "d2x"}


def letter(type_: Type) -> str:
    """A number in Python's letters for `struct`; empty for anything else."""
    match type_:
        case FloatType(bits):
            return _REALS[bits]
        case IntType(bits, signed):
            made = _INTEGERS.get(bits, "h")  # a bit field lies in a word
            return made if signed else made.upper()
    return ""


def layout(type_: Type) -> str:
    """A type's layout, in Python."""
    match type_:
        case ArrayType(of, count):
            return f"({layout(of)}, {count})"
        case StructType():
            return type_.python
        case VoidType():
            return "None"
    return repr(letter(type_))


def flat_layout(type_: Type) -> str:
    """The layout of a member, whose arrays of arrays are one array."""
    if not isinstance(type_, ArrayType):
        return layout(type_)
    count = 1
    of: Type = type_
    while isinstance(of, ArrayType):
        count *= of.count
        of = of.of
    return f"({layout(of)}, {count})"


def pointed(value: Value) -> Type:
    """What a pointer points to, whatever it was cast to."""
    while isinstance(value, Converted) and isinstance(value.operand.type, PointerType):
        value = value.operand
    assert isinstance(value.type, PointerType)
    return innermost(value.type.to)
