"""Loops that count: which of them are a range."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from bgi.turboc.checker.typed import (
    Act,
    Advance,
    Arithmetic,
    Comparison,
    Compute,
    Constant,
    Converted,
    Define,
    Group,
    Loop,
    Present,
    Signed,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import INT, IntType, Symbol
from bgi.turboc.emitter.wrapping import Interval, cut


class Counted(NamedTuple):
    """A loop over a variable in steps of the same size, up or down to an end that stays."""

    variable: Symbol
    start: Value | None
    end: Value
    inclusive: bool
    step: Value
    """How much is added or taken away; always more than 0."""
    up: bool
    inside: Interval
    """Where the variable lies in the body."""


def counted(loop: Loop, known: dict[Symbol, Interval]) -> Counted | None:
    """A loop as a range: `for (i = a; i < b; i += c)`, where the body changes none of them.

    Args:
        loop: the loop.
        known: where variables lie.
    """
    variable, step, up = _step(loop.step)
    condition = loop.condition
    if variable is None or step is None or loop.late or not isinstance(condition, Comparison):
        return None
    if condition.op not in (("<", "<=") if up else (">", ">=")):
        return None
    end, inclusive = condition.right, condition.op[-1] == "="
    changed = {variable, *written(loop.body)}
    if variable in written(loop.body) or not _counts(condition.left, variable):
        return None
    if not (_stays(end, changed) and _stays(step, changed)):
        return None
    type_, start = variable.type, _start(loop, variable)
    assert isinstance(type_, IntType)
    begin = (type_.low, type_.high) if start is None else cut(start, known)
    low, high = cut(end, known)
    if up:
        inside = begin[0], max(begin[0], high - (not inclusive))
    else:
        inside = min(begin[1], low + (not inclusive)), begin[1]
    least, most = cut(step, known)
    fits = inside[1] + most <= type_.high if up else type_.low <= inside[0] - most
    if least <= 0 or not fits:
        return None
    return Counted(variable, start, end, inclusive, step, up, inside)


def _step(step: Value | None) -> tuple[Symbol | None, Value | None, bool]:
    """The variable that a loop counts with, the size of its steps, and whether it counts up."""
    if isinstance(step, Advance):
        return _local(step.target), Constant(step.place, INT, 1), step.by > 0
    if isinstance(step, (Update, Store)):
        result = _inner(step.result if isinstance(step, Update) else step.value)
        if isinstance(result, Arithmetic) and result.op in "+-":
            variable, before = _local(step.target), _inner(result.left)
            if isinstance(before, Present) or _local(before) is variable:
                return variable, result.right, result.op == "+"
    return None, None, True


def _inner(value: Value) -> Value:
    """A whole number without the types that it was converted to."""
    while isinstance(value, Converted) and isinstance(value.operand.type, IntType):
        value = value.operand
    return value


def _counts(value: Value, variable: Symbol) -> bool:
    """Whether the value that is compared is the variable's own."""
    type_, own = value.type, variable.type
    assert isinstance(own, IntType)
    same = _local(_inner(value)) is variable and isinstance(type_, IntType)
    return same and isinstance(type_, IntType) and type_.low <= own.low and own.high <= type_.high


def _stays(value: Value, changed: set[Symbol]) -> bool:
    """Whether a whole number is the same in every turn."""
    match value:
        case Constant():
            return isinstance(value.type, IntType)
        case Variable():
            symbol = _local(value)
            return symbol is not None and symbol not in changed
        case Arithmetic(op=op, left=left, right=right):
            return op not in "/%" and _stays(left, changed) and _stays(right, changed)
        case Converted(operand=operand) | Signed(operand=operand):
            return isinstance(value.type, IntType) and _stays(operand, changed)
    return False


def is_empty(act: Act) -> bool:
    """Whether nothing is done."""
    return isinstance(act, Group) and not act.ending and all(map(is_empty, act.items))


def _local(value: Value) -> Symbol | None:
    """A whole number that only this function changes."""
    if not isinstance(value, Variable) or not isinstance(value.type, IntType):
        return None
    symbol = value.symbol
    own = symbol.kind in ("local", "parameter") and not symbol.addressed
    return symbol if own else None


def _start(loop: Loop, variable: Symbol) -> Value | None:
    """What the variable is at first, if the loop says so."""
    first: Any = loop.first
    while isinstance(first, Group) and len(first.items) == 1:
        first = first.items[0]
    if isinstance(first, Define) and first.symbol is variable:
        return first.value
    if isinstance(first, Compute) and isinstance(first.value, Store):
        store = first.value
        if _local(store.target) is variable:
            return store.value
    return None


def written(thing: Any) -> Iterator[Symbol]:
    """The variables that statements or values assign to."""
    if isinstance(thing, (Store, Update, Advance)) and isinstance(thing.target, Variable):
        yield thing.target.symbol
    if isinstance(thing, Define):
        yield thing.symbol
    if isinstance(thing, (list, tuple)):
        for one in thing:
            yield from written(one)
    elif isinstance(thing, (Value, Act)):
        for cls in type(thing).__mro__:
            for name in getattr(cls, "__slots__", ()):
                yield from written(getattr(thing, name))
