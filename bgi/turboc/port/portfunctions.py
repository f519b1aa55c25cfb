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
from bgi.turboc.port.portactions import PortActions
from bgi.turboc.port.pycode import Code, plain


class PortFunctions(PortActions):
    """Writes functions and classes."""

    def routine_lines(self, routine: Routine) -> None:
        """A function."""
        symbol = routine.symbol
        self.begin(routine)
        self.assigned = set()
        self._name_variables(routine)
        parameters = [one.python for one in routine.parameters if one not in self.facts.pure]
        with self.block(f"def {symbol.python}({', '.join(parameters)}):", symbol.place):
            before = len(self.lines)
            for one in routine.parameters:
                if one in self.cells:
                    self.line(f"{one.python} = [{one.python}]")
            self._begin_early(routine)
            self.acts(routine.body.items)
            self.ended(routine.body.ending)
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
        with self.block(f"class {cls.python}{base}:", cls.place):
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
