"""Functions and classes as Python."""

from __future__ import annotations

import builtins
import re

from bgi.turboc.checker.scopes import Namer
from bgi.turboc.checker.typed import (
    Act,
    Address,
    Advance,
    Compute,
    Define,
    Field,
    Give,
    Group,
    Invocation,
    Itself,
    Loop,
    MethodCall,
    Routine,
    Store,
    TypedProgram,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    VOID,
    ArrayType,
    FunctionType,
    ReferenceType,
    StructType,
    Symbol,
)
from bgi.turboc.faults import Place
from bgi.turboc.port import walking
from bgi.turboc.port.facts import SET, Spot
from bgi.turboc.port.portactions import PortActions
from bgi.turboc.port.portclasses import is_only
from bgi.turboc.port.pycode import Code, plain
from bgi.turboc.port.weaving import AWAY, BACK, BLANK


class PortFunctions(PortActions):
    """Writes functions and classes."""

    def routine_lines(self, routine: Routine) -> None:
        """A function."""
        symbol = routine.symbol
        self.begin(routine)
        self.assigned = set()
        self._name_variables(routine)
        parameters = [one.python for one in routine.parameters if one not in self.facts.pure]
        if symbol.static:
            self.line("@staticmethod")
        elif symbol.owner is not None:
            parameters.insert(0, "self")
        with self.block(f"def {symbol.python}({', '.join(parameters)}):", symbol.place):
            before = len(self.lines)
            for one in routine.parameters:
                if one in self.cells:
                    self.line(f"{one.python} = [{one.python}]")
            if symbol.owner is not None and symbol.name == symbol.owner.tag:
                self._construct(routine, symbol.owner)
            self._begin_early(routine)
            self.acts(routine.body.items)
            self.ended(routine.body.ending)
            self.acts(routine.after)
            if symbol.owner is not None and symbol.python.startswith("construct"):
                self.line("return self")
            self._end(routine)
            self._mark_end(routine.body)
            if self.assigned:
                names = ", ".join(sorted(self.assigned))
                self.lines.insert(before, (self.indent, f"global {names}", None))

    def _name_variables(self, routine: Routine) -> None:
        """Variables get their names; those of blocks beside each other may share one."""
        used: dict[str, Symbol] = {}
        scopes = _scopes(routine.body)
        globals_ = {
            one.symbol.python
            for one in walking.values(walking.of_routine(routine))
            if isinstance(one, Variable) and one.symbol.kind in ("global", "function")
        }
        library = self.names.library_names(walking.of_routine(routine))
        free = (self.module_names - globals_) | (self.names.library - library)
        namer = Namer((self.names.namer.taken - free) | globals_ | library)
        for one in routine.parameters + routine.variables:
            first = used.get(plain(one.name))
            beside = first is not None and not _within(scopes.get(first), scopes.get(one))
            if first is not None and beside and first.type == one.type and first.kind == one.kind:
                one.python = first.python
                continue
            name = f"{one.name}_" if hasattr(builtins, one.name) else one.name
            one.python = namer.name(name)
            used[plain(one.name)] = one
        self.taken = {one.python for one in routine.parameters + routine.variables}

    module_names: set[str]
    """The names of the program's functions and global variables."""

    def _begin_early(self, routine: Routine) -> None:
        """Variables that are declared in loops and begin before them."""
        loops = [one for one in walking.acts(routine.body) if isinstance(one, Loop)]
        inside = [
            act for loop in loops for act in walking.acts(loop.body) if isinstance(act, Define)
        ]
        seen: set[Symbol] = set()
        for act in inside:
            plain = not isinstance(act.symbol.type, (ArrayType, StructType))
            if (
                act.value is None
                and plain
                and act.symbol not in seen
                and act.symbol not in self.cells
            ):
                seen.add(act.symbol)
                if self.has_to_begin(act.symbol):
                    self.line(
                        f"{act.symbol.python} = {self.nothing(act.symbol.type, (act.symbol, 0))}"
                    )
        self.early = seen

    def _end(self, routine: Routine) -> None:
        """What a function answers where its end is reached."""
        type_ = routine.symbol.type
        assert isinstance(type_, FunctionType)
        last = self.lines[-1][:2] if self.lines else None
        if last == (self.indent, "return"):
            self.lines.pop()
        if walking.ends_here(routine.body.items) or _is_endless(routine.body.items):
            return
        outs = [str(self.variable(one)) for one in self.outs.of(routine.symbol)]
        answers = type_.result != VOID and routine.symbol.name != "main"
        if answers and routine.symbol in self.asked:
            outs.insert(0, str(self.nothing(type_.result, (("result", routine.symbol), 0))))
        elif answers and outs:
            outs.insert(0, "None")
        if outs:
            self.line(f"return {', '.join(outs)}")

    asked: set[Symbol]
    """Functions whose answers count."""

    # Classes

    def class_lines(self, cls: StructType) -> None:
        """A struct as a small class."""
        base = f"({cls.base.python})" if cls.base else ""
        self.inside = cls
        with self.block(f"class {cls.python}{base}:", cls.place):
            before = len(self.lines)
            for name, symbol in cls.statics.items():
                if symbol.kind == "global":
                    self.line(f"{plain(name)} = {self.first(self.statics[symbol])}")
            makers = cls.methods.get(cls.tag, [])
            if not (makers and is_only(makers[0])) and (cls.members or not cls.base):
                self._at_first(cls)
            for routine in in_order(self.methods.get(cls, []), cls):
                if len(self.lines) > before:
                    self.lines.append((0, BLANK, None))
                outside = not self._is_inside(cls, routine.symbol.place)
                if outside:
                    self.lines.append((self.indent, AWAY, routine.symbol.place))
                self.routine_lines(routine)
                if outside:
                    self.lines.append((self.indent, BACK, routine.symbol.place))
        self.inside = None

    def _is_inside(self, cls: StructType, place: Place) -> bool:
        """Whether a method's body stands in the class."""
        origin = self.names.origins.get(cls.place.file)
        starts = [one for one in origin.closing if one >= cls.place[1:]] if origin else []
        end = origin.closing[min(starts)] if origin and starts else 0
        return place.file == cls.place.file and cls.place.line <= place.line <= end

    def _construct(self, routine: Routine, cls: StructType) -> None:
        """What a constructor does before its body."""
        whole = walking.of_routine(routine)
        given = any(isinstance(one, Compute) and _is_of_base(one) for one in routine.before)
        if cls.base is not None and not given:
            self.line("super().__init__()")
        if not is_only(routine.symbol):
            self.acts(routine.before)
            return
        for act in routine.before:
            if _is_of_base(act):
                self.act(act)
        for name, type_ in cls.members.items():
            if self.facts.first(whole, _own_member(name)) != SET:
                self.line(f"self.{plain(name)} = {self.nothing(type_, ((cls, name), 0))}")
        self.acts([act for act in routine.before if not _is_of_base(act)])

    methods: dict[StructType, list[Routine]]
    """The methods of each class."""
    statics: dict[Symbol, Define]
    """Members that all objects of a class share."""

    def _at_first(self, cls: StructType) -> None:
        """What an object holds at first."""
        if cls.base is not None:
            with self.block("def __init__(self):"):
                self.line("super().__init__()")
                for name, type_ in cls.members.items():
                    self.line(f"self.{plain(name)} = {self.nothing(type_, ((cls, name), 0))}")
            return
        if not cls.members:
            return
        parts = [self._member(cls, name) for name in cls.members]
        given = [f"{name}={default}" for name, default, _ in parts if default]
        with self.block(f"def __init__({', '.join(['self', *given])}):"):
            for name, _, value in parts:
                self.line(f"self.{name} = {value}", self._member_place(cls, name))

    def _member_place(self, cls: StructType, name: str) -> Place | None:
        """The line that a member is declared in."""
        origin = self.names.origins.get(cls.place.file)
        for number in range(cls.place.line, cls.place.line + 200):
            line = origin.line(number) if origin is not None else ""
            if re.search(rf"\b{re.escape(name)}\b", line):
                return Place(cls.place.file, number)
            if "}" in line and "{" not in line:
                break
        return None

    def _member(self, cls: StructType, name: str) -> tuple[str, str, str]:
        """A member: its name, what it is if nothing is given, and what it gets."""
        code = self.nothing(cls.members[name], ((cls, name), 0))
        python = plain(name)
        if code[0] in "[b" or "(" in code:
            if (cls, name) in self.lists:
                return python, "None", f"{code} if {python} is None else {python}"
            return python, "", str(code)
        return python, str(code), python

    lists: set[tuple[StructType, str]]
    """Members that are lists, and get their first values somewhere."""


def _own_member(name: str) -> Spot:
    """Whether a value is a member of the object whose method it is."""

    def is_it(value: Value) -> bool:
        own = isinstance(value, Field) and value.name == name
        return own and isinstance(value.base, Itself)  # type: ignore[attr-defined]

    return is_it


def says_nothing(routine: Routine) -> bool:
    """Whether a constructor or destructor only does what the base's does."""
    symbol = routine.symbol
    if symbol.owner is None or symbol.owner.base is None or walking.items_of(routine.body):
        return False
    acts = [*routine.before, *routine.after]
    if symbol.name.startswith("~"):
        return all(_is_of_base(one) for one in acts)
    if symbol.name != symbol.owner.tag or symbol.owner.members or len(acts) != 1:
        return False
    call = acts[0].value if isinstance(acts[0], Compute) else None
    if not isinstance(call, MethodCall) or not is_only(call.method):
        return False
    names = [one.symbol if isinstance(one, Variable) else None for one in call.arguments]
    return is_only(symbol) and names == routine.parameters


def in_order(routines: list[Routine], cls: StructType) -> list[Routine]:
    """The methods of a class: constructors first, without those that say nothing."""
    kept = [one for one in routines if not says_nothing(one)]
    return sorted(kept, key=lambda one: (one.symbol.name != cls.tag, one.symbol.place))


def _is_of_base(act: Act) -> bool:
    """Whether it calls the constructor of a base."""
    return isinstance(act, Compute) and isinstance(act.value, MethodCall)


def _scopes(body: Group) -> dict[Symbol, list[int]]:
    """The blocks that each variable is declared in, from the outside in."""
    found: dict[Symbol, list[int]] = {}

    def look(thing: object, path: list[int]) -> None:
        if isinstance(thing, (list, tuple)):
            for one in thing:
                look(one, path)
        elif isinstance(thing, Define):
            found.setdefault(thing.symbol, path)
        elif isinstance(thing, Act):
            inner = (
                [*path, id(thing)] if isinstance(thing, Group) and not _declares(thing) else path
            )
            for name in walking.fields(type(thing)):
                look(getattr(thing, name), inner)

    look(body, [])
    return found


def _declares(act: Group) -> bool:
    """Whether a block is no block, but several variables that are declared together."""
    return bool(act.items) and all(isinstance(one, Define) for one in act.items)


def _within(one: list[int] | None, other: list[int] | None) -> bool:
    """Whether one of two blocks stands in the other."""
    if one is None or other is None:
        return True
    short = min(len(one), len(other))
    return one[:short] == other[:short]


def _is_endless(items: list[Act]) -> bool:
    """Whether the last statement is a loop that only a return leaves."""
    last = walking.items_of(items[-1]) if items else []
    if not last or not isinstance(last[-1], Loop):
        return False
    loop = last[-1]
    endless = loop.condition is None or str(getattr(loop.condition, "value", 0)) == "1"
    return endless and not walking.leaves_switch([loop.body])


def changed_parameters(program: TypedProgram) -> set[Symbol]:
    """Parameters that are objects, and that their functions change or give away."""
    found: set[Symbol] = set()
    for routine in program.routines:
        own = {one for one in routine.parameters if isinstance(one.type, StructType)}
        if not own:
            continue
        for value in walking.values(walking.of_routine(routine)):
            if isinstance(value, (Store, Update, Advance)):
                found |= own & {_root(value.target)}
            elif isinstance(value, Address):
                found |= own & {_root(value.operand)}
    return found


def _root(value: Value) -> Symbol | None:
    """The variable that a member belongs to."""
    while isinstance(value, Field) or hasattr(value, "base"):
        value = value.base
    return value.symbol if isinstance(value, Variable) else None


def asked_functions(program: TypedProgram) -> set[Symbol]:
    """The functions whose answers count somewhere."""
    quiet: set[int] = set()
    for routine in program.routines:
        for act in walking.acts(walking.of_routine(routine)):
            if isinstance(act, Compute):
                quiet.add(id(act.value))
    found: set[Symbol] = set()
    for value in walking.of_program(program):
        if id(value) in quiet:
            continue
        if isinstance(value, Invocation) and isinstance(value.function, Variable):
            found.add(value.function.symbol)
        elif isinstance(value, MethodCall):
            found.add(value.method)
    return found


def is_reference(symbol: Symbol) -> bool:
    """Whether a variable is a reference."""
    return isinstance(symbol.type, ReferenceType)


def gives(routine: Routine) -> bool:
    """Whether a function gives a value back anywhere."""
    inside = walking.acts(walking.of_routine(routine))
    return any(isinstance(one, Give) and one.value is not None for one in inside)


EMPTY = Code("")
