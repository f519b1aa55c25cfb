"""Loops that count: which of them are a `for` over a range in Python."""

from __future__ import annotations

from typing import NamedTuple

from bgi.turboc.checker.typed import (
    Act,
    Advance,
    Arithmetic,
    Comparison,
    Compute,
    Constant,
    Converted,
    Define,
    Element,
    Field,
    LibraryCall,
    Loop,
    Present,
    Referred,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import IntType, Symbol
from bgi.turboc.port import walking


class Range(NamedTuple):
    """`for variable in range(start, end, step)`; `beyond` is added to the end."""

    variable: Symbol
    start: Value
    end: Value
    beyond: int
    step: int
    by: Value | None
    """The step as it is written, if it is not 1."""


def ranged(loop: Loop, changed: set[Symbol]) -> Range | None:
    """A loop as a range: its variable begins somewhere, and changes in its step only.

    Args:
        loop: the loop.
        changed: variables that functions change that are called in it.
    """
    if loop.late or loop.step is None or not isinstance(loop.condition, Comparison):
        return None
    begin = _begin(loop.first)
    if begin is None:
        return None
    variable, start = begin
    step, by = _step(loop.step, variable)
    if not step or not isinstance(variable.type, IntType):
        return None
    op, left, end = loop.condition.op, loop.condition.left, loop.condition.right
    if _plain(left) is not variable:
        return None
    if op not in (("<", "<=", "!=") if step > 0 else (">", ">=", "!=")):
        return None
    if op == "!=" and not (abs(step) == 1 and _reaches(start, end, step)):
        return None
    if not isinstance(end.type, IntType) or variable in walking.written(loop.body):
        return None
    if variable in changed or not _stays(end, loop, changed, variable):
        return None
    beyond = (1 if step > 0 else -1) if op in ("<=", ">=") else 0
    return Range(variable, start, end, beyond, step, by)


def _reaches(start: Value, end: Value, step: int) -> bool:
    """Whether a loop that ends at one number only comes there."""
    known = isinstance(start, Constant) and isinstance(end, Constant)
    return known and (end.value - start.value) * step >= 0  # type: ignore[attr-defined]


def _begin(first: Act | None) -> tuple[Symbol, Value] | None:
    items = walking.items_of(first)
    if len(items) != 1:
        return None
    match items[0]:
        case Define(symbol=symbol, value=value) if value is not None:
            return symbol, value
        case Compute(value=Store(target=Variable(symbol=symbol), value=value)):
            return symbol, value
    return None


def _plain(value: Value) -> Symbol | None:
    while isinstance(value, Converted) and isinstance(value.type, IntType):
        value = value.operand
    return value.symbol if isinstance(value, Variable) else None


def _step(value: Value, variable: Symbol) -> tuple[int, Value | None]:
    """By how much a variable changes, 0 if that is not known."""
    if isinstance(value, Advance) and _plain(value.target) is variable:
        return value.by, None
    if isinstance(value, Update | Store) and _plain(value.target) is variable:
        result = value.result if isinstance(value, Update) else value.value
        while isinstance(result, Converted):
            result = result.operand
        if isinstance(result, Arithmetic) and result.op in ("+", "-"):
            left, right = result.left, result.right
            while isinstance(left, Converted):
                left = left.operand
            same = isinstance(left, Present) or _plain(left) is variable
            if same and isinstance(right, Constant) and isinstance(right.value, int):
                return (right.value if result.op == "+" else -right.value), right
    return 0, None


def _stays(end: Value, loop: Loop, others: set[Symbol], variable: Symbol) -> bool:
    """Whether the end of a loop is the same each time."""
    changed = walking.written(loop.body)
    calls = walking.calls_own(loop.body)
    stored = {
        name
        for one in walking.values(loop.body)
        if isinstance(one, (Store, Update, Advance))
        for name in ([one.target.name] if isinstance(one.target, Field) else ["[]"])
        if not isinstance(one.target, Variable)
    }
    for one in walking.values(end):
        match one:
            case LibraryCall() | Store() | Update() | Advance():
                return False
            case Variable(symbol=symbol):
                if symbol in changed or symbol in others or symbol is variable:
                    return False
            case Field(name=name):
                if name in stored or calls:
                    return False
            case Element() | Referred():
                if stored or calls:
                    return False
    return not walking.calls_own(end)
