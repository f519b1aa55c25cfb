"""Where 16 bits can be seen: intervals that whole numbers lie in while nothing cuts them off.

Sums and products are computed as Python does, and cut to their type's bits only where they are seen
(compared, divided, stored, passed), and only if their interval does not lie in the type's range:
interval arithmetic.
"""

from __future__ import annotations

from typing import Any

from bgi.turboc.checker.typed import (
    Arithmetic,
    Choice,
    Comparison,
    Connective,
    Constant,
    Converted,
    Field,
    Inverse,
    LibraryCall,
    Signed,
    Value,
    Variable,
)
from bgi.turboc.checker.types import FloatType, IntType, StructType, Type

Interval = tuple[int, int]

Known = dict[Any, Interval]
"""Where variables lie, by symbol, and members, by what `member` says."""

WIDEST = 1 << 62
"""Beyond it nothing is known."""

_ANSWERS = {
    **dict.fromkeys(("getmaxx", "getmaxy", "getmaxwidth", "getmaxheight"), (0, 4095)),
    **{"kbhit": (0, 1), "rand": (0, 0x7FFF)},
    **dict.fromkeys(("getpixel", "getcolor", "getbkcolor", "getmaxcolor"), (0, 255)),
}
"""What functions of the library answer at most."""


def member(type_: Type, name: str) -> tuple[Type, str]:
    """A member of a class, known by the class that it belongs to."""
    cls = type_
    while isinstance(cls, StructType) and cls.base is not None and name not in cls.members:
        cls = cls.base
    return cls, name


def interval(value: Value, known: Known) -> Interval:
    """Where a whole number lies that has not been cut to its type."""
    type_ = value.type
    assert isinstance(type_, IntType)
    whole = type_.low, type_.high
    match value:
        case Constant(value=number):
            return int(number), int(number)
        case Variable(symbol=symbol):
            return known.get(symbol, whole)
        case Field(base=base, name=name):
            return known.get(member(base.type, name), whole)
        case Comparison() | Connective() | Inverse():
            return 0, 1
        case LibraryCall(name="random", arguments=(most,)) if isinstance(most.type, IntType):
            low, high = cut(most, known)
            return (0, high) if low >= 0 else whole
        case LibraryCall(name=name):
            return _ANSWERS.get(name, whole)
        case Choice(yes=yes, no=no):
            one, other = cut(yes, known), cut(no, known)
            return min(one[0], other[0]), max(one[1], other[1])
        case Converted(operand=operand) if isinstance(operand.type, FloatType):
            return -WIDEST, WIDEST
        case Converted(operand=operand) if isinstance(operand.type, IntType):
            narrower = type_.bits <= operand.type.bits
            return interval(operand, known) if narrower else cut(operand, known)
        case Signed(op="-", operand=operand):
            low, high = interval(operand, known)
            return -high, -low
        case Signed(operand=operand):
            low, high = interval(operand, known)
            return -high - 1, -low - 1
        case Arithmetic():
            return _arithmetic(value, type_, known)
    return whole


def cut(value: Value, known: Known) -> Interval:
    """Where it lies once it has been cut to its type."""
    found = interval(value, known)
    assert isinstance(value.type, IntType)
    return found if fits(found, value.type) else (value.type.low, value.type.high)


def fits(found: Interval, type_: IntType) -> bool:
    """Whether an interval lies in the range of a type."""
    return type_.low <= found[0] and found[1] <= type_.high


def _arithmetic(value: Arithmetic, type_: IntType, known: Known) -> Interval:
    if value.op in ("+", "-", "*"):
        a, b = interval(value.left, known)
        c, d = interval(value.right, known)
        if value.op == "+":
            return a + c, b + d
        if value.op == "-":
            return a - d, b - c
        ends = (a * c, a * d, b * c, b * d)
        return min(ends), max(ends)
    a, b = cut(value.left, known)
    c, d = cut(value.right, known)
    if value.op == "/":
        most = max(abs(a), abs(b)) // max(c, 1)
        return (0, most) if a >= 0 and c >= 0 else (-most, most)
    if value.op == "%":
        most = max(abs(c), abs(d)) - 1
        return (0 if a >= 0 else -most), max(min(b, most), 0)
    if value.op == "&" and (a >= 0 or c >= 0):
        return 0, min(high for low, high in ((a, b), (c, d)) if low >= 0)
    if value.op == ">>" and a >= 0:
        return 0, b
    if value.op == "<<":
        a, b = interval(value.left, known)  # the bits above are cut once, behind the shift
        if c >= 0 and d <= 31:
            ends = (a << c, a << d, b << c, b << d)
            return min(ends), max(ends)
        return -WIDEST, WIDEST
    return type_.low, type_.high


def wrapped(text: str, type_: IntType) -> str:
    """Python that cuts a number to its type's bits."""
    mask = (1 << type_.bits) - 1
    if not type_.signed:
        return f"({text} & {mask})"
    half = 1 << type_.bits - 1
    return f"(({text} & {mask} ^ {half}) - {half})"
