"""What is known of variables: which are never negative, which are set before they are read."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from bgi.turboc.checker.typed import (
    Act,
    Address,
    Advance,
    Again,
    Branch,
    Choice,
    Comparison,
    Compute,
    Connective,
    Constant,
    Converted,
    Define,
    Field,
    Give,
    Group,
    Invocation,
    Jump,
    Leave,
    LibraryCall,
    Listed,
    Loop,
    MethodCall,
    Select,
    Store,
    TypedProgram,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import IntType, StructType, Symbol, Type
from bgi.turboc.emitter.wrapping import Known, interval, member
from bgi.turboc.port import walking
from bgi.turboc.port.outs import LIBRARY_OUTS, Outs
from bgi.turboc.port.shaping import FILLING
from bgi.turboc.port.singles import singles

FILLED = {
    **FILLING,
    **dict.fromkeys(
        ["getviewsettings", "getlinesettings", "getfillsettings", "gettextsettings"], 0
    ),
    **dict.fromkeys(["getarccoords", "getpalette", "gettime", "getdate", "gettextinfo"], 0),
}
"""Functions that write a string or a structure, and where it goes."""

READ, SET, OPEN = "read", "set", "open"
"""What happens to a variable first; open: neither."""

Spot = Callable[[Value], bool]
"""Whether a value is the variable that is meant."""

SOMEWHERE = 1 << 14
"""Small numbers: for the question whether a sum is negative, overflow does not count."""


class Facts:
    """What is known of the variables of a program."""

    def __init__(self, program: TypedProgram, outs: Outs) -> None:
        self._outs = outs
        self.known: Known = {}
        """Whole numbers that are never negative: variables and members."""
        self._never_negative(program)
        self.singles = singles(program)
        """Those that have 32 bits, and where it is seen."""
        self.pure: set[Symbol] = set()
        """Parameters that answer, and are not looked at before."""
        self._pure(program)

        self._writes: dict[Symbol, set[Symbol]] = {}
        self._calls: dict[Symbol, set[Symbol]] = {}
        for routine in program.routines:
            whole = walking.of_routine(routine)
            self._writes[routine.symbol] = walking.written(whole)
            self._calls[routine.symbol] = set(walking.called(whole))

    @property
    def recurs(self) -> bool:
        """Whether a function calls itself, if only through others."""
        return any(self._reaches(one, one) for one in self._calls)

    def _reaches(self, start: Symbol, end: Symbol) -> bool:
        waiting, seen = list(self._calls.get(start, ())), set()
        while waiting:
            one = waiting.pop()
            if one is end:
                return True
            if one not in seen:
                seen.add(one)
                waiting += self._calls.get(one, ())
        return False

    def changed_by_calls(self, thing: Act) -> set[Symbol]:
        """The variables that functions may change that are called there."""
        waiting, seen = list(walking.called(thing)), set()
        changed: set[Symbol] = set()
        while waiting:
            one = waiting.pop()
            if one not in seen:
                seen.add(one)
                changed |= self._writes.get(one, set())
                waiting += self._calls.get(one, ())
        return changed

    # Signs

    def _never_negative(self, program: TypedProgram) -> None:
        given: dict[Any, list[Value | None]] = {
            member(cls, name): [] for cls in program.structs for name in cls.members
        }
        types: dict[Any, Type] = {
            member(cls, name): one for cls in program.structs for name, one in cls.members.items()
        }
        lost: set[Any] = {one for one in given if one[0].kind == "union"}
        for value in walking.of_program(program):
            match value:
                case Store(target=target, value=one):
                    while isinstance(one, Store):  # x = y = 0
                        one = one.value
                    given.setdefault(_key(target), []).append(one)
                case Update(target=target) | Address(operand=target):
                    lost.add(_key(target))
                case Advance(target=target, by=by):
                    lost |= {_key(target)} if by < 0 else set()
                case Invocation() | MethodCall():
                    for parameter, one in self._outs.pairs(value):
                        given.setdefault(parameter, []).append(one)
                case Listed(type=StructType() as cls, items=items):
                    for name, item in zip(cls.all_members(), items, strict=True):
                        given.setdefault(member(cls, name), []).extend([item] if item else [])
        for act in self._defined(program):
            if act.value is not None:
                given.setdefault(act.symbol, []).append(act.value)
        high: Known = {}
        for key in given:
            type_ = key.type if isinstance(key, Symbol) else types.get(key)
            if isinstance(type_, IntType) and key not in lost:
                high[key] = 0, min(type_.high, SOMEWHERE)
        self.known = _kept(high, given)

    def _defined(self, program: TypedProgram) -> list[Define]:
        found = list(program.globals)
        for routine in program.routines:
            inside = walking.acts(walking.of_routine(routine))
            found += [one for one in inside if isinstance(one, Define)]
        return found

    # What happens first

    def _pure(self, program: TypedProgram) -> None:
        for routine in program.routines:
            for one in self._outs.of(routine.symbol):
                if not routine.jumps:
                    spot = self.behind(one)
                    if self.first(walking.of_routine(routine), spot, returns=READ) == SET:
                        self.pure.add(one)

    def behind(self, parameter: Symbol) -> Spot:
        """What a parameter points to."""

        def is_it(value: Value) -> bool:
            inner = getattr(value, "operand", None) or getattr(value, "base", None)
            return isinstance(inner, Variable) and inner.symbol is parameter

        return is_it

    def first(self, acts: Iterable[Act], spot: Spot, returns: str = SET) -> str:
        """What happens to a variable first in statements."""
        for act in acts:
            found = self._act(act, spot, returns)
            if found != OPEN:
                return found
        return OPEN

    def _act(self, act: Act, spot: Spot, returns: str) -> str:
        match act:
            case Compute(value=value):
                return self._value(value, spot)
            case Define(symbol=symbol, value=value):
                found = self._value(value, spot) if value is not None else OPEN
                here = Variable(act.place, symbol.type, symbol)
                return SET if found == OPEN and value is not None and spot(here) else found
            case Group(items=items):
                return self.first(items, spot, returns)
            case Branch(condition=condition, yes=yes, no=no):
                found = self._value(condition, spot)
                if found != OPEN:
                    return found
                both = [self._act(yes, spot, returns)]
                both.append(self._act(no, spot, returns) if no is not None else OPEN)
                return _joined(both)
            case Loop():
                return self._loop(act, spot, returns)
            case Select(value=value, parts=parts):
                found = self._value(value, spot)
                if found != OPEN:
                    return found
                whole = any(None in values for values, _ in parts)
                ways = [self.first(part, spot, returns) for _, part in parts]
                return _joined([*ways, *([] if whole else [OPEN])])
            case Give(value=value):
                found = self._value(value, spot) if value is not None else OPEN
                return returns if found == OPEN else found
            case Jump():
                return READ
            case Leave() | Again():
                return OPEN
        return OPEN

    def _loop(self, act: Loop, spot: Spot, returns: str) -> str:
        found = self.first([act.first] if act.first else [], spot, returns)
        if found == OPEN and act.condition is not None and not act.late:
            found = self._value(act.condition, spot)
        if found != OPEN:
            return found
        inside = self._act(act.body, spot, returns)
        if inside == OPEN:
            rest = [one for one in (act.step, act.condition if act.late else None) if one]
            return _after(self._value(one, spot) for one in rest)
        once = act.late or act.condition is None or _runs(act)
        once = once and not walking.leaves_switch([act.body])
        return inside if inside == READ or once else OPEN

    def _value(self, value: Value, spot: Spot) -> str:
        """What happens to it first in a value."""
        if spot(value):
            return READ
        match value:
            case Store(target=target, value=given):
                found = self._value(given, spot)
                if found == OPEN and spot(target):
                    return SET
                return found if found != OPEN else self._parts(target, spot)
            case Connective(left=left, right=right):
                found = self._value(left, spot)
                if found != OPEN:
                    return found
                return READ if self._value(right, spot) == READ else OPEN
            case Choice(condition=condition, yes=yes, no=no):
                found = self._value(condition, spot)
                return (
                    found
                    if found != OPEN
                    else _joined([self._value(one, spot) for one in (yes, no)])
                )
            case LibraryCall(name=name, arguments=arguments) if name in LIBRARY_OUTS:
                return self._answers(value, arguments, LIBRARY_OUTS[name], name, spot)
            case LibraryCall(name=name, arguments=arguments) if name in FILLED:
                place = FILLED[name]
                adds = name in ("strcat", "strncat", "strupr", "strlwr", "strrev", "strset")
                at = len(arguments) if place >= len(arguments) or adds else place
                return self._fills(arguments, at, spot)
            case MethodCall(method=method, base=base) if method.name == "operator>>":
                found = self._value(base, spot)
                if found != OPEN or not value.arguments:
                    return found
                read = self._outs.place(value.arguments[0])
                return SET if read is not None and spot(read) else self._parts(value, spot)
            case Invocation(arguments=arguments) | MethodCall(arguments=arguments):
                pure = [
                    place
                    for place, (parameter, _) in enumerate(self._outs.pairs(value))
                    if parameter in self.pure
                ]
                return self._answers(value, arguments, tuple(pure), "", spot)
        return self._parts(value, spot)

    def _parts(self, value: Value, spot: Spot) -> str:
        return _after(
            self._value(one, spot)
            for name in walking.fields(type(value))
            for one in _values(getattr(value, name))
        )

    def _fills(self, given: tuple[Value, ...], at: int, spot: Spot) -> str:
        """A call that writes a whole string or a structure."""
        for place, one in enumerate(given):
            if place != at and self._value(one, spot) == READ:
                return READ
        target: Value | None = given[at] if at < len(given) else None
        while isinstance(target, Converted | Address):
            target = target.operand
        return SET if target is not None and spot(target) else OPEN

    def _answers(
        self, value: Value, given: tuple[Value, ...], places: tuple[int, ...], name: str, spot: Spot
    ) -> str:
        """A call that sets what some of its arguments point to."""
        answers = False
        read = [0, 1] if name == "initgraph" else []
        for place, one in enumerate(given):
            target = self._outs.place(one) if place in places else None
            if target is not None and spot(target):
                if place in read:
                    return READ
                answers = True
            elif self._value(one, spot) == READ:
                return READ
        return SET if answers else OPEN


def _key(target: Value) -> object:
    """What is known by: a variable, or a member of a class."""
    match target:
        case Variable(symbol=symbol):
            return symbol
        case Field(base=base, name=name):
            return member(base.type, name)
    return None


def _kept(high: Known, given: dict[Any, list[Value | None]]) -> Known:
    """Those of which all values are not negative, if the others are not."""
    changed = True
    while changed:
        changed = False
        for symbol in list(high):
            for one in given[symbol]:
                whole = one is not None and isinstance(one.type, IntType)
                if not whole or interval(one, high)[0] < 0:  # type: ignore[arg-type]
                    del high[symbol]
                    changed = True
                    break
    return high


def _values(thing: object) -> list[Value]:
    if isinstance(thing, Value):
        return [thing]
    return [one for one in thing if isinstance(one, Value)] if isinstance(thing, tuple) else []


def _joined(ways: list[str]) -> str:
    """What happens first, if any of several ways may be gone."""
    if READ in ways:
        return READ
    return SET if ways and all(one == SET for one in ways) else OPEN


def _after(ways: Iterable[str]) -> str:
    """What happens first in values that are computed one after the other."""
    return next((one for one in ways if one != OPEN), OPEN)


def _runs(act: Loop) -> bool:
    """Whether a loop runs at least once, as `for (i = 0; i < 10; i++)` does."""
    condition, first = act.condition, walking.items_of(act.first)
    if len(first) != 1 or not isinstance(condition, Comparison):
        return False
    begin = first[0]
    if isinstance(begin, Compute) and isinstance(begin.value, Store):
        value: Value | None = begin.value.value
    else:
        value = begin.value if isinstance(begin, Define) else None
    end = condition.right
    if not (isinstance(value, Constant) and isinstance(end, Constant)):
        return False
    low, high = value.value, end.value
    return {"<": low < high, "<=": low <= high, ">": low > high, ">=": low >= high}.get(
        condition.op, False
    )
