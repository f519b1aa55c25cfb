"""In which order values are computed: C's arguments from right to left, Python's from the left."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from bgi.turboc.checker.typed import (
    Advance,
    Creation,
    Destruction,
    Element,
    Field,
    Invocation,
    LibraryCall,
    MethodCall,
    Referred,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import PointerType, Symbol
from bgi.turboc.emitter.loops import written

_CALLS = (Invocation, LibraryCall, MethodCall, Store, Update, Advance, Creation, Destruction)


def _inner(value: Any) -> Iterator[Value]:
    """All values in a value, and itself."""
    if isinstance(value, tuple):
        for one in value:
            yield from _inner(one)
    elif isinstance(value, Value):
        yield value
        for name in type(value).__slots__:
            yield from _inner(getattr(value, name))


def has_effects(value: Value) -> bool:
    """Whether something happens while a value is computed."""
    return any(isinstance(one, _CALLS) for one in _inner(value))


def _changes_memory(value: Value) -> bool:
    """Whether computing a value may change what others find in memory."""
    return any(
        any(isinstance(given.type, PointerType) for given in one.arguments)
        if isinstance(one, LibraryCall)
        else isinstance(one, _CALLS)
        for one in _inner(value)
    )


def _reads_memory(value: Value) -> bool:
    """Whether a value depends on memory that calls and stores may change."""
    return any(
        isinstance(one, (Element, Field, Referred))
        or (isinstance(one, Variable) and (one.symbol.addressed or one.symbol.kind == "global"))
        for one in _inner(value)
    )


def _reads(value: Value, symbols: set[Symbol]) -> bool:
    return any(isinstance(one, Variable) and one.symbol in symbols for one in _inner(value))


def order_matters(values: tuple[Value, ...]) -> bool:
    """Whether arguments are worth something else if they are computed from left to right."""
    acting = [value for value in values if has_effects(value)]
    if len(acting) != 1:
        return len(acting) > 1
    changed = set(written(acting[0]))
    memory = _changes_memory(acting[0])
    others = [value for value in values if value is not acting[0]]
    return any(_reads(one, changed) or (memory and _reads_memory(one)) for one in others)
