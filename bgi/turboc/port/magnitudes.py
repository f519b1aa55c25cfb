"""How large whole numbers are likely to get: where their 16 bits could be seen.

Variables of graphics programs hold what fits on a screen; what is multiplied by a number that is
written is meant to fit. Products of variables are what overflows, and what is computed with them.
"""

from __future__ import annotations

from bgi.turboc.checker.typed import (
    Arithmetic,
    Choice,
    Comparison,
    Connective,
    Constant,
    Converted,
    Inverse,
    Signed,
    Value,
    Variable,
)
from bgi.turboc.checker.types import FloatType, IntType, Symbol
from bgi.turboc.emitter.wrapping import Interval

SCREEN = 640
"""The largest number that a variable is thought to hold."""

FACTOR = 1
"""The same of a real number: it is an angle, a sine, a ratio."""

HIGHEST = 0x7FFF


def magnitude(value: Value, known: dict[Symbol, Interval]) -> int:
    """The largest number that a value is likely to be, if nothing cuts it off."""
    match value:
        case Constant(value=number):
            return abs(int(number))
        case Variable(symbol=symbol) if isinstance(value.type, IntType):
            return min(known.get(symbol, (0, SCREEN))[1], SCREEN)
        case Comparison() | Connective() | Inverse():
            return 1
        case Choice(yes=yes, no=no):
            return max(_cut(yes, known), _cut(no, known))
        case Signed(operand=operand):
            return magnitude(operand, known)
        case Converted(operand=operand) if FloatType in (type(operand.type), type(value.type)):
            return magnitude(operand, known)
        case Converted(operand=operand) if isinstance(operand.type, IntType):
            assert isinstance(value.type, IntType)
            narrower = value.type.bits <= operand.type.bits
            return magnitude(operand, known) if narrower else _cut(operand, known)
        case Arithmetic():
            return _computed(value, known)
    return FACTOR if isinstance(value.type, FloatType) else SCREEN


def _cut(value: Value, known: dict[Symbol, Interval]) -> int:
    return min(magnitude(value, known), HIGHEST)


def _computed(value: Arithmetic, known: dict[Symbol, Interval]) -> int:
    op = value.op
    if op == "%":
        return min(_cut(value.left, known), _cut(value.right, known))
    if op == "/" and isinstance(value.type, FloatType):
        return FACTOR
    if op in ("/", ">>", "&", "|", "^"):
        return _cut(value.left, known)
    left, right = magnitude(value.left, known), magnitude(value.right, known)
    exceeds = max(left, right) > HIGHEST
    if op == "*":
        written = isinstance(value.left, Constant) or isinstance(value.right, Constant)
        return left * right if exceeds or not written else min(left * right, HIGHEST)
    return left + right if exceeds else min(left + right, HIGHEST)
