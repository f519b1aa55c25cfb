"""A whole program as Python: its parts in order, with the comments of the source between them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from bgi.turboc.checker.scopes import python_name
from bgi.turboc.checker.typed import Define, Listed, Routine, TypedProgram
from bgi.turboc.checker.types import StructType, Symbol
from bgi.turboc.faults import CError, CErrors, Place
from bgi.turboc.port import walking
from bgi.turboc.port.facts import Facts
from bgi.turboc.port.jumps import without_jumps
from bgi.turboc.port.outs import Outs
from bgi.turboc.port.portclasses import method_name
from bgi.turboc.port.portfunctions import PortFunctions, asked_functions, changed_parameters
from bgi.turboc.port.portnames import Names
from bgi.turboc.port.shaping import Shaper
from bgi.turboc.port.weaving import Weaver
from bgi.turboc.understanding import Understood, deep

Line = tuple[int, str, Place | None]


class Part(NamedTuple):
    """A part of the program: where it stands in the source, and its lines."""

    place: Place
    lines: list[Line]
    tall: bool
    """Whether it is a function or a class, with two blank lines around it."""


class _Porter(PortFunctions):
    """Writes a program."""

    def program(self, program: TypedProgram) -> list[Part]:
        self.lists = set()
        self._name_all(program)
        self.routines = program.routines
        self.module_names = {
            *(one.symbol.python for one in program.globals),
            *(one.symbol.python for one in program.routines),
        }
        self.asked, self.changed = asked_functions(program), changed_parameters(program)
        self.errors: list[CError] = []
        parts: list[Part] = []
        for routine in program.routines:
            if routine.symbol.owner is None:
                with self._part(parts, routine.symbol.place, True):
                    self.routine_lines(routine)
        for cls in program.structs:
            with self._part(parts, cls.place, True):
                self.class_lines(cls)
        for defined in program.globals:
            if "." in defined.symbol.python:
                continue
            with self._part(parts, self._before_function(defined, program.routines), False):
                self.line(f"{defined.symbol.python} = {self.first(defined)}", defined.place)
        if self.errors:
            raise CErrors(sorted(self.errors, key=lambda one: one.place))
        return parts

    @contextmanager
    def _part(self, parts: list[Part], place: Place, tall: bool) -> Iterator[None]:
        self.lines, self.indent, self.place, self.after = [], 0, None, None
        self.walrus = False
        try:
            yield
        except CError as error:
            self.errors.append(error)
        parts.append(Part(place, self.lines, tall))

    def _name_all(self, program: TypedProgram) -> None:
        for cls in program.structs:
            tag = cls.tag if not cls.tag[0].isdigit() else "record"
            cls.python = self.names.namer.name(_class_name(cls.alias or tag))
        for routine in program.routines:
            if routine.symbol.owner is None:
                plain = python_name(routine.symbol)
                routine.symbol.python = self.names.namer.name(plain)
        self.methods, self.statics = {}, {one.symbol: one for one in program.globals}
        for routine in program.routines:
            owner = routine.symbol.owner
            if owner is not None:
                self.methods.setdefault(owner, []).append(routine)
        members: dict[Symbol, str] = {}
        for cls in program.structs:
            members |= {one: f"{cls.python}.{name}" for name, one in cls.statics.items()}
            for method in [one for same in cls.methods.values() for one in same]:
                method.python = method_name(method)
        for defined in program.globals:
            name = members.get(defined.symbol)
            defined.symbol.python = name or self.names.namer.name(defined.symbol.name)
        for value in walking.of_program(program):
            if isinstance(value, Listed) and isinstance(value.type, StructType):
                for name, item in zip(value.type.all_members(), value.items, strict=True):
                    if item is not None:
                        self.lists.add((value.type, name))

    def _before_function(self, defined: Define, routines: list[Routine]) -> Place:
        """A static variable of a function stands before it."""
        place = defined.place
        for routine in routines:
            start = routine.symbol.place
            origin = self.names.origins.get(start.file)
            body = routine.body.place
            end = origin.closing.get((body.line, body.column), 0) if origin else 0
            if start.file == place.file and start.line < place.line <= end:
                return start._replace(column=0)
        return place


def _class_name(tag: str) -> str:
    """A class's name as Python writes it: `star_field` is StarField."""
    if not tag.islower():
        return tag
    return "".join(part.capitalize() for part in tag.split("_"))


def _place_and_value(one: tuple[str, tuple[Place, str]]) -> tuple[Place, int]:
    """Constants of an enum, which all stand in one place, go by their values."""
    _, (place, text) = one
    return place, int(text) if text.lstrip("-").isdecimal() else 0


def _before_class(place: Place, program: TypedProgram, names: Names) -> Place:
    """A constant that is defined in a class stands before it."""
    for cls in program.structs:
        start = cls.place
        closing = names.origins[start.file].closing if start.file in names.origins else {}
        ends = [one for one in closing if one >= start[1:]]
        if ends and start.file == place.file and start.line < place.line <= closing[min(ends)]:
            return start._replace(column=0)
    return place


def ported(program: Understood) -> str:
    """A program in Python; CErrors holds what cannot be carried over."""
    typed = program.typed
    with deep():
        for routine in typed.routines:
            if routine.jumps:
                without_jumps(routine)
        names = Names(program)
        outs = Outs(typed)
        shaper = Shaper(typed, program.headers, outs)
        facts = Facts(typed, outs)
        porter = _Porter(program.headers, names, shaper.shapes, outs, facts)
        porter.cells = shaper.cells
        parts = porter.program(typed)
    names.modules |= porter.helpers.modules
    if facts.recurs:
        names.modules.add("sys")
    weaver = Weaver(names.origins, list(program.sources))
    constants = [
        Part(_before_class(place, typed, names), [(0, f"{name} = {text}", place)], False)
        for name, (place, text) in sorted(names.constants.items(), key=_place_and_value)
    ]
    return weaver.text(
        program.file,
        [*constants, *parts],
        imports=names.imports(),
        helpers=porter.helpers.lines(),
        notes=porter.helpers.notes(),
        main=typed.main.python,
        deep=facts.recurs,
    )
