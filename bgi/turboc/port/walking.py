"""What stands in what: all values and statements of a typed tree."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from bgi.turboc.checker.typed import (
    Act,
    Address,
    Advance,
    Again,
    Branch,
    Compute,
    Constant,
    Define,
    Give,
    Group,
    Invocation,
    Jump,
    Leave,
    Loop,
    MethodCall,
    Quoted,
    Routine,
    Select,
    Store,
    TypedProgram,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import Symbol


class Out(Act):
    """Leaves a loop from a switch in it: Python's `break`, but not C's."""

    __slots__ = ()


def values(thing: Any) -> Iterator[Value]:
    """All values in a value, a statement or a list of them, from the outside in."""
    if isinstance(thing, (list, tuple)):
        for one in thing:
            yield from values(one)
    elif isinstance(thing, (Value, Act)):
        if isinstance(thing, Value):
            yield thing
        for name in fields(type(thing)):
            yield from values(getattr(thing, name))


def acts(thing: Any) -> Iterator[Act]:
    """All statements in a statement or a list, from the outside in."""
    if isinstance(thing, (list, tuple)):
        for one in thing:
            yield from acts(one)
    elif isinstance(thing, Act):
        yield thing
        for name in fields(type(thing)):
            yield from acts(getattr(thing, name))


_FIELDS: dict[type, list[str]] = {}


def fields(cls: type) -> list[str]:
    """The names of a node's own fields that may hold nodes."""
    if cls not in _FIELDS:
        every = [name for one in cls.__mro__ for name in getattr(one, "__slots__", ())]
        dull = ("place", "type", "symbol", "written", "method", "ending", "constructor")
        _FIELDS[cls] = [name for name in every if name not in dull]
    return _FIELDS[cls]


def whole(value: Value) -> Iterator[Value]:
    """All values in a value, with those that constants were computed from."""
    for one in values(value):
        yield one
        if isinstance(one, Constant) and one.written is not None:
            yield from whole(one.written)


def of_program(program: TypedProgram) -> Iterator[Value]:
    """All values of a program."""
    for defined in program.globals:
        yield from values(defined)
    for routine in program.routines:
        yield from values([routine.before, routine.body, routine.after])


def written(thing: Any) -> set[Symbol]:
    """The variables that are assigned to in something, or whose address is given away."""
    found = {
        one.target.symbol
        for one in values(thing)
        if isinstance(one, (Store, Update, Advance)) and isinstance(one.target, Variable)
    }
    found |= {
        one.operand.symbol
        for one in values(thing)
        if isinstance(one, Address) and isinstance(one.operand, Variable)
    }
    return found | {one.symbol for one in acts(thing) if isinstance(one, Define)}


def reads(thing: Any, symbol: Symbol) -> bool:
    """Whether a variable occurs in something, but as the target of an assignment."""
    targets = {id(one.target) for one in values(thing) if isinstance(one, Store)}
    return any(
        isinstance(one, Variable) and one.symbol is symbol and id(one) not in targets
        for one in values(thing)
    )


def calls_own(thing: Any) -> bool:
    """Whether a function of the program is called."""
    return any(isinstance(one, (Invocation, MethodCall)) for one in values(thing))


def called(thing: Any) -> Iterator[Symbol]:
    """The functions of the program that may be called: by name, or as a value."""
    for one in values(thing):
        if isinstance(one, MethodCall):
            yield one.method
        elif isinstance(one, Variable) and one.symbol.kind == "function":
            yield one.symbol


def items_of(act: Act | None) -> list[Act]:
    """The statements of a block in a list, without blocks that say nothing."""
    if act is None:
        return []
    if isinstance(act, Group) and not act.ending:
        return [one for item in act.items for one in items_of(item)]
    return [act]


def leaves_switch(thing: list[Act]) -> bool:
    """Whether a break of theirs belongs to the loop or switch around them."""
    return _holds(thing, lambda act: isinstance(act, Leave), (Loop, Select))


def jumps_in(thing: list[Act]) -> list[Jump]:
    """All gotos."""
    return [one for one in acts(thing) if isinstance(one, Jump)]


def _holds(thing: list[Act], wanted: Callable[[Act], bool], stop: tuple[type, ...]) -> bool:
    for act in thing:
        if wanted(act):
            return True
        if isinstance(act, Group) and _holds(act.items, wanted, stop):
            return True
        if isinstance(act, Branch):
            both = [act.yes, *([act.no] if act.no else [])]
            if _holds(both, wanted, stop):
                return True
        parts = act.parts if isinstance(act, Select) and Select not in stop else []
        if _holds([one for _, part in parts for one in part], wanted, stop):
            return True
    return False


def goes_on(thing: list[Act]) -> bool:
    """Whether a continue of theirs belongs to the loop around them."""
    return _holds(thing, lambda act: isinstance(act, Again), (Loop,))


def ends_here(thing: list[Act]) -> bool:
    """Whether nothing behind these statements is reached."""
    for act in reversed(thing):
        if isinstance(act, Group) and not act.items:
            continue
        if isinstance(act, Group):
            return ends_here(act.items)
        if isinstance(act, Branch) and act.no is not None:
            return ends_here([act.yes]) and ends_here([act.no])
        if isinstance(act, Select):
            parts = [body for _, body in act.parts]
            whole = any(None in values for values, _ in act.parts)
            left = any(leaves_switch(body) for body in parts)
            return whole and not left and bool(parts[-1]) and ends_here(parts[-1])
        return isinstance(act, (Leave, Give, Again, Jump, Out))
    return False


def of_routine(routine: Routine) -> list[Act]:
    """All statements of a function."""
    return [*routine.before, routine.body, *routine.after]


def literal(value: Value) -> bytes | None:
    """The bytes of a string that is written there; None if it is none."""
    text = value.operand if isinstance(value, Address) else None
    return text.data if isinstance(text, Quoted) else None


def computed(act: Act) -> Value | None:
    """The value of a statement that is only one."""
    return act.value if isinstance(act, Compute) else None
