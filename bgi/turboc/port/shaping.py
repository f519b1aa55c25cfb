"""Looks at all that a program does with its pointers, and tells `Shapes`."""

from __future__ import annotations

from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.typed import (
    Address,
    Advance,
    Comparison,
    Constant,
    Converted,
    Creation,
    Define,
    Distance,
    Element,
    Give,
    Invocation,
    LibraryCall,
    Listed,
    MethodCall,
    Quoted,
    Store,
    TypedProgram,
    Update,
    Value,
)
from bgi.turboc.checker.types import (
    VOID,
    ArrayType,
    FunctionType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    is_text,
)
from bgi.turboc.port import walking
from bgi.turboc.port.outs import Outs
from bgi.turboc.port.pointershapes import Key, Shapes, addressed, owner

FILLING = {
    **dict.fromkeys(
        ["strcpy", "strcat", "strncpy", "strncat", "sprintf", "gets", "strupr", "strlwr", "strrev"],
        0,
    ),
    **dict.fromkeys(["strset", "strnset", "fgets", "cgets"], 0),
    **dict.fromkeys(("itoa", "ltoa", "ultoa"), 1),
    "gcvt": 2,
}
"""Functions that write a string, and where it goes."""

IMAGES = {"getimage": 4, "putimage": 2}
"""Functions of pieces of the screen, and where they lie."""

_SCANS = {"scanf": 1, "cscanf": 1, "sscanf": 2, "fscanf": 2}
_TEXTS = ("strcmp", "strcmpi", "stricmp", "strncmp", "strlen", "strstr", "strchr", "strtok")


class Shaper:
    """Goes through a program."""

    def __init__(self, program: TypedProgram, headers: Headers, outs: Outs) -> None:
        self.shapes = Shapes()
        self.cells: set[Symbol] = set()
        """Variables that other pointers point to."""
        self._headers, self._outs = headers, outs
        for defined in program.globals:
            self._define(defined.symbol, defined.value)
        for routine in program.routines:
            for act in walking.acts(walking.of_routine(routine)):
                if isinstance(act, Define):
                    self._define(act.symbol, act.value)
                if isinstance(act, Give) and act.value is not None:
                    self._flow((("result", routine.symbol), 0), act.value)
        for cls in program.structs:
            self._join_virtual(cls)
        for value in walking.of_program(program):
            self._look(value)

    def _join_virtual(self, cls: StructType) -> None:
        """What a virtual method answers, and what those that replace it do, is the same."""
        for methods in cls.methods.values():
            for method in methods:
                for other in cls.base.method(method.name) if cls.base else ():
                    self.shapes.same((("result", method), 0), (("result", other), 0))

    def _define(self, symbol: Symbol, value: Value | None) -> None:
        if value is not None:
            self._initial((symbol, 0), value)

    def _initial(self, key: Key, value: Value) -> None:
        """What a variable holds at first."""
        if isinstance(value, Quoted):
            self.shapes.memory(key).flags.add("text")
        elif isinstance(value, Listed) and isinstance(value.type, StructType):
            for name, item in zip(value.type.all_members(), value.items, strict=True):
                if item is not None:
                    self._initial(((owner(value.type, name), name), 0), item)
        elif isinstance(value, Listed):
            for item in value.items:
                if item is not None:
                    self._initial(self.shapes.deeper(key), item)
        else:
            self._flow(key, value)

    def _flow(self, key: Key, value: Value) -> None:
        if isinstance(value.type, (PointerType, ReferenceType)):
            symbol = addressed(value)
            if symbol is not None:
                self.cells.add(symbol)
            self.shapes.flow(key, value)

    # Values

    def _look(self, value: Value) -> None:
        match value:
            case Store(target=target, value=given) if isinstance(value.type, PointerType):
                self._flow(self.shapes.key(target), given)
                self._wrote(target)
            case Store(target=target) | Update(target=target) | Advance(target=target):
                self._wrote(target)
                if isinstance(value.type, PointerType):
                    self.shapes.handle(self.shapes.key(target)).flags.add("advance")
            case Element(base=base, index=index):
                self._element(base, index)
            case Distance(left=left, right=right):
                self._both(left, right, "distance")
            case Comparison(left=left, right=right, op=op) if isinstance(left.type, PointerType):
                null = isinstance(right, Converted) and isinstance(right.operand, Constant)
                if not isinstance(right, Constant) and not null:
                    order = op not in ("==", "!=")
                    self._both(left, right, "order" if order else "equal")
            case Invocation() | MethodCall():
                self._call(value)
            case LibraryCall(name=name, arguments=arguments):
                self._library(name, arguments)
                if is_text(value.type) and name not in FILLING:
                    self.shapes.memory(self.shapes.key(value)).flags.add("text")
            case Creation(arguments=arguments, constructor=constructor):
                if constructor is not None:
                    self._arguments(constructor, arguments)

    def _wrote(self, target: Value) -> None:
        if isinstance(target, Element):
            self.shapes.memory(self.shapes.key(target.base)).flags.add("written")

    def _element(self, base: Value, index: Value) -> None:
        if isinstance(base.type, PointerType):
            first = isinstance(index, Constant) and not index.value
            self.shapes.handle(self.shapes.key(base)).flags.add("deref" if first else "index")

    def _both(self, left: Value, right: Value, flag: str) -> None:
        for one in (left, right):
            key = self.shapes.key(one)
            self.shapes.handle(key).flags.add(flag)
            if flag != "equal":
                self.shapes.memory(key).flags.add(flag)
        self.shapes.memory(self.shapes.key(left)).join(self.shapes.memory(self.shapes.key(right)))

    def _call(self, value: Invocation | MethodCall) -> None:
        for parameter, argument in self._outs.pairs(value):
            if parameter in self._outs.found:
                place = self._outs.place(argument)
                if place is not None and isinstance(place.type, PointerType):
                    self.shapes.same(self.shapes.deeper((parameter, 0)), self.shapes.key(place))
            else:
                self._flow((parameter, 0), argument)

    def _arguments(self, function: Symbol, arguments: tuple[Value, ...]) -> None:
        for parameter, argument in zip(self._outs.parameters(function), arguments, strict=False):
            self._flow((parameter, 0), argument)

    def _library(self, name: str, arguments: tuple[Value, ...]) -> None:
        symbol = self._headers.symbol(name)
        assert symbol is not None and isinstance(symbol.type, FunctionType)
        parameters = symbol.type.parameters
        for place, argument in enumerate(arguments):
            if not isinstance(argument.type, PointerType):
                continue
            memory = self.shapes.memory(self.shapes.key(argument))
            if place == FILLING.get(name, -1) or (
                place >= _SCANS.get(name, 99) and is_text(argument.type)
            ):
                self._filled(argument)
            elif (
                name in _TEXTS
                or (place < len(parameters) and is_const_text(parameters[place]))
                or (place >= len(parameters) and is_text(argument.type))
            ):
                memory.flags.add("text")
            elif place == IMAGES.get(name, -1):
                memory.flags.add("image")
            elif place < len(parameters) and is_data(parameters[place]):
                memory.flags.add("data")

    def _filled(self, argument: Value) -> None:
        """A string is written: to an array of its own, or through a pointer."""
        memory = self.shapes.memory(self.shapes.key(argument))
        memory.flags.add("text")
        direct = isinstance(argument, Address) and isinstance(argument.operand.type, ArrayType)
        if not direct:
            memory.flags.add("filled_through")


def is_const_text(type_: object) -> bool:
    """Whether it is the type of a string that is only read."""
    return isinstance(type_, PointerType) and type_.const and is_text(type_)


def is_data(type_: object) -> bool:
    """Whether it is the type of memory that a function takes for bytes."""
    return isinstance(type_, PointerType) and type_.to == VOID
