"""Where it is seen that a float of C has 32 bits: in sums that grow step by step.

`x += dx` in a loop loses a little each time, in C more than in Python; after some hundred steps x
lies beside another pixel. Such variables, and what is added to them, are cut to 32 bits.
"""

from __future__ import annotations

from typing import Any

from bgi.turboc.checker.typed import (
    Arithmetic,
    Constant,
    Converted,
    Field,
    Present,
    Signed,
    Store,
    TypedProgram,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import FLOAT, FloatType, IntType
from bgi.turboc.emitter.wrapping import member
from bgi.turboc.port import walking


def singles(program: TypedProgram) -> set[Any]:
    """The variables and members that have to be cut to 32 bits."""
    found: set[Any] = set()
    for value in walking.of_program(program):
        if isinstance(value, Update | Store) and value.target.type == FLOAT:
            key = place_key(value.target)
            result = _plain(value.result if isinstance(value, Update) else value.value)
            if key is not None and isinstance(result, Arithmetic) and result.op in ("+", "-"):
                added = _added(value, result)
                if added is not None and not _is_whole(added):
                    found.add(key)
                    found |= {place_key(one) for one in walking.values(added) if one.type == FLOAT}
    return found - {None}


def place_key(value: Value) -> object:
    """What a place is known by: a variable, or a member of a class."""
    match value:
        case Variable(symbol=symbol):
            return symbol
        case Field(base=base, name=name):
            return member(base.type, name)
    return None


def loses(value: Value) -> bool:
    """Whether a value may have more digits than 32 bits hold."""
    inner = _plain(value)
    while isinstance(inner, Signed):
        inner = _plain(inner.operand)
    if isinstance(inner, Constant):
        return not float(inner.value * 256).is_integer()
    if isinstance(inner, Variable | Field) and inner.type == FLOAT:
        return False
    return not isinstance(inner.type, IntType)


def _plain(value: Value) -> Value:
    while isinstance(value, Converted) and isinstance(value.type, FloatType):
        value = value.operand
    return value


def _added(value: Update | Store, result: Arithmetic) -> Value | None:
    """What is added to a variable; None if it is not its own value that it is added to."""
    left = _plain(result.left)
    if isinstance(value, Update):
        return result.right if isinstance(left, Present) else None
    same = place_key(left) is not None and place_key(left) == place_key(value.target)
    return result.right if same else None


def _is_whole(value: Value) -> bool:
    """Whether what is added is a number that both hold exactly."""
    return not loses(value) and isinstance(_plain(value), Constant)
