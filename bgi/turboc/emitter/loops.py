"""Loops that count: which of them are a range."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from bgi.turboc.checker.typed import (
    Act,
    Advance,
    Comparison,
    Compute,
    Constant,
    Converted,
    Define,
    Group,
    Loop,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import IntType, Symbol


class Counted(NamedTuple):
    """A loop over a variable, up to an end that stays the same."""

    variable: Symbol
    start: Value | None
    end: Value
    inclusive: bool
    low: int
    """The smallest number that the variable can begin with."""


def counted(loop: Loop) -> Counted | None:
    """A loop as a range: `for (i = a; i < b; i++)`, where neither changes in the body."""
    step, condition = loop.step, loop.condition
    if loop.late or not isinstance(step, Advance) or step.by != 1:
        return None
    if not isinstance(condition, Comparison) or condition.op not in ("<", "<="):
        return None
    variable = _local(step.target)
    left, end = condition.left, condition.right
    if isinstance(left, Converted):
        left = left.operand
    if variable is None or _local(left) is not variable or not isinstance(end.type, IntType):
        return None
    type_ = variable.type
    assert isinstance(type_, IntType)
    inclusive = condition.op == "<="
    known = isinstance(end, Constant)
    plain = end.operand if isinstance(end, Converted) else end
    if not known and (_local(plain) is None or inclusive or end.type != type_):
        return None
    if isinstance(end, Constant) and not type_.low <= end.value <= type_.high - inclusive:
        return None
    if condition.left.type != type_ and not (type_.bits == 8 and known):
        return None
    changed = set(written(loop.body))
    if variable in changed or (not known and _local(plain) in changed):
        return None
    return Counted(variable, _start(loop, variable), end, inclusive, type_.low)


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
