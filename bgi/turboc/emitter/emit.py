"""A whole program as Python, and which line of it comes from which of C."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.scopes import Namer, python_name
from bgi.turboc.checker.typed import Define, Routine, TypedProgram
from bgi.turboc.checker.types import (
    VOID,
    ArrayType,
    FunctionType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    flat,
    innermost,
    size,
)
from bgi.turboc.emitter.emitactions import ActionWriter
from bgi.turboc.emitter.emitplaces import is_cell
from bgi.turboc.emitter.gotos import taken_apart
from bgi.turboc.emitter.layouts import flat_layout, letter
from bgi.turboc.faults import NOWHERE, Place

HELPERS = [
    "Pointer",
    "room",
    "MemberPlace",
    "CharMember",
    "Record",
    "Plain",
    "typed",
    "put",
    "put_member",
    "index",
    "single",
    "busy",
    "far_pointer",
    "remainder",
    "number",
    "destroy",
    "int",
    "float",
    "range",
    "bytearray",
    "Union",
    "shared",
    "self",
]
"""Names of Python that the emitted program uses."""


class Emitted(NamedTuple):
    """A program in Python."""

    text: str
    places: list[Place]
    """Where each line comes from."""
    used: set[str]
    """Names of the library."""
    main: str
    frame: int
    """The bytes that the variables of one call take at most."""


class _Emitter(ActionWriter):
    """Writes a program."""

    def program(self, program: TypedProgram) -> Emitted:
        for cls in program.structs:
            cls.python = self.namer.name(cls.tag if not cls.tag[0].isdigit() else "unnamed")
        for defined in program.globals:
            defined.symbol.python = self.namer.name(defined.symbol.name)
        for routine in program.routines:
            if routine.symbol.owner is None:
                routine.symbol.python = self.namer.name(python_name(routine.symbol))
        methods: dict[StructType, list[Routine]] = {}
        for routine in program.routines:
            if routine.symbol.owner is not None:
                methods.setdefault(routine.symbol.owner, []).append(routine)
        self.hidden = {one for cls in program.structs for one in _hidden(cls)}
        for cls in program.structs:
            self._class(cls, methods.get(cls, []))
        for cls in program.structs:
            if cls.kind != "union":
                self._laid_out(cls)
        for routine in program.routines:
            if routine.symbol.owner is None:
                self._routine(routine)
        self.place = NOWHERE
        for defined in program.globals:
            self._global(defined)
        strings = [
            f"{name} = bytearray({data + bytes(1)!r})" for data, name in self.strings.items()
        ]
        text = "\n".join([*strings, *self.lines, ""])
        places = [NOWHERE] * len(strings) + self.places
        frame = max(sum(flat(one.type) for one in r.variables) for r in program.routines) * 8
        return Emitted(text, places, self.used, program.main.python, frame)

    def _global(self, defined: Define) -> None:
        self.place = defined.place
        symbol = defined.symbol
        self.line(f"{symbol.python} = {self.made_variable(symbol, defined.value)}")

    # Classes

    def _class(self, cls: StructType, methods: list[Routine]) -> None:
        """A class with slots for its members."""
        self.place = NOWHERE
        base = cls.base.python if cls.base else "Union" if cls.kind == "union" else "Record"
        if cls.base is not None and cls.base.library:
            self.used.add(cls.base.python)
        own = [self.attribute(name) for name in cls.members]
        every = [self.attribute(name) for name in cls.all_members()]
        with self.block(f"class {cls.python}({base}):"):
            self.line(f"SIZE = {size(cls)}")
            if cls.kind == "union":
                self._shared(cls)
            else:
                self.line(f"__slots__ = {tuple(own)!r}")
                self.line(f"MEMBERS = {tuple(every)!r}")
                self._begin(cls)
            for routine in methods:
                self._routine(routine)

    def _laid_out(self, cls: StructType) -> None:
        """How its objects lie in memory."""
        members = [
            f"({self.attribute(name)!r}, {flat_layout(type_)})"
            for name, type_ in cls.all_members().items()
        ]
        self.line(f"{cls.python}.LAYOUT = [{', '.join(members)}]")

    def _begin(self, cls: StructType) -> None:
        """What an object holds before its constructor is called."""
        with self.block("def __init__(self):"):
            if cls.base is not None:
                self.line("super().__init__()")
            for name, type_ in cls.members.items():
                self.line(f"self.{self.attribute(name)} = {self.nothing(type_)}")

    def _shared(self, cls: StructType) -> None:
        """The members of a union: views of the same bytes."""
        self.line("__slots__ = ()")
        for name, type_ in cls.members.items():
            self.line(f"{self.attribute(name)} = shared({_shared_format(type_)!r})")

    # Functions

    def _routine(self, routine: Routine) -> None:
        """A function or a method."""
        symbol = routine.symbol
        type_ = symbol.type
        assert isinstance(type_, FunctionType)
        self.place, self.temporaries, self.assigned = symbol.place, 0, set()
        machine = taken_apart(routine.body) if routine.jumps else None
        if machine is not None:
            routine.variables += machine.variables
        used: set[str] = set()
        for one in routine.parameters + routine.variables:
            one.python = Namer(self.namer.taken | used).name(one.name)
            used.add(one.python)
        names = [one.python for one in routine.parameters]
        if symbol.owner is not None and not symbol.static:
            names.insert(0, "self")
        if type_.open or symbol.name == "main":
            names.append("*_more")
        if symbol.static:
            self.line("@staticmethod")
        with self.block(f"def {symbol.python}({', '.join(names)}):"):
            before = len(self.lines)
            self._variables(routine)
            for act in routine.before:
                self.act(act)
            if machine is not None:
                self.machine(machine)
            else:
                self.act(routine.body)
            for act in routine.after:
                self.act(act)
            constructor = symbol.owner is not None and symbol.name == symbol.owner.tag
            if constructor:
                self.line("return self")
            elif type_.result != VOID and not isinstance(type_.result, ReferenceType):
                self.line(f"return {self.nothing(type_.result)}")
            if self.assigned:
                self.lines.insert(
                    before, "    " * self.indent + f"global {', '.join(sorted(self.assigned))}"
                )
                self.places.insert(before, symbol.place)

    def _variables(self, routine: Routine) -> None:
        """Variables as they are before anything is assigned."""
        for one in routine.parameters:
            if is_cell(one):
                self.line(f"{one.python} = {self.cell(one.python, one.type)}")
        for one in routine.variables:
            inner = innermost(one.type)
            made = isinstance(inner, StructType) and inner.methods.get(inner.tag)
            if not made and not isinstance(one.type, ReferenceType):
                self.line(f"{one.python} = {self._empty(one)}")

    def _empty(self, symbol: Symbol) -> str:
        text = self.nothing(symbol.type)
        if isinstance(symbol.type, ArrayType):
            return text
        return self.cell(text, symbol.type) if is_cell(symbol) else text


def _hidden(cls: StructType) -> Iterator[Symbol]:
    """The methods of its bases that its own hide in Python."""
    own = {one.python for methods in cls.methods.values() for one in methods}
    base = cls.base
    while base is not None:
        yield from (one for same in base.methods.values() for one in same if one.python in own)
        base = base.base


def _shared_format(type_: Type) -> str:
    """The format of a member of a union; empty for characters."""
    return f"<{letter(type_)}" if letter(type_) else ""


def emit(program: TypedProgram, headers: Headers) -> Emitted:
    """A program in Python."""
    namer = Namer([*HELPERS, *headers.names()])
    emitter = _Emitter(headers, namer)
    return emitter.program(program)
