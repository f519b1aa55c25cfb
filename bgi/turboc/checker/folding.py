"""Arithmetic of C on numbers that are known, in as many bits as their types have."""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable
from typing import Any

from bgi.turboc.checker.types import FLOAT, FloatType, IntType, Type

Number = int | float


_SINGLE = struct.Struct("f")


def single(number: float) -> float:
    """A number as a float of 32 bits holds it."""
    try:
        return float(_SINGLE.unpack(_SINGLE.pack(number))[0])
    except OverflowError:
        return math.copysign(math.inf, number)


def fitted(number: Number, type_: Type) -> Number:
    """A number as a type holds it: whole ones lose their upper bits, real ones their fraction."""
    if isinstance(type_, FloatType):
        return single(number) if type_ == FLOAT else float(number)
    assert isinstance(type_, IntType)
    whole = int(number) if math.isfinite(number) else 0
    bits = whole & (1 << type_.bits) - 1
    return bits - (bits >> type_.bits - 1 << type_.bits) if type_.signed else bits


def quotient(left: int, right: int) -> int:
    """C's division: what is behind the point is cut off."""
    whole = abs(left) // abs(right)
    return whole if (left < 0) == (right < 0) else -whole


def remainder(left: int, right: int) -> int:
    """C's remainder: it has the sign of the left side."""
    return left - right * quotient(left, right)


_WHOLE: dict[str, Callable[[Any, Any], Any]] = {
    **{"+": operator.add, "-": operator.sub, "*": operator.mul, "/": quotient, "%": remainder},
    **{"&": operator.and_, "|": operator.or_, "^": operator.xor},
    "<<": lambda left, right: left << (right & 31),
    ">>": lambda left, right: left >> (right & 31),
}
_COMPARISONS: dict[str, Callable[[Any, Any], bool]] = {
    **{"<": operator.lt, ">": operator.gt, "<=": operator.le, ">=": operator.ge},
    **{"==": operator.eq, "!=": operator.ne},
}


def arithmetic(op: str, left: Number, right: Number, type_: Type) -> Number | None:
    """The result of an operation; None if it has none, or is left to the run."""
    if op in ("/", "%") and not right:
        return None
    try:
        if isinstance(type_, FloatType) and op == "/":
            return fitted(left / right, type_)
        return fitted(_WHOLE[op](left, right), type_)
    except (OverflowError, TypeError):
        return None


def comparison(op: str, left: Number, right: Number) -> int:
    """Whether it holds: 1 or 0."""
    return int(_COMPARISONS[op](left, right))
