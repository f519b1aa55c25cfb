"""Variables, members, elements and pointers as Python."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.typed import (
    Address,
    Choice,
    Constant,
    Converted,
    Creation,
    Element,
    Field,
    Itself,
    LibraryCall,
    Offset,
    Quoted,
    Referred,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    CHAR,
    UCHAR,
    ArrayType,
    FloatType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    is_number,
    size,
)
from bgi.turboc.faults import CError, Place
from bgi.turboc.port.facts import Facts
from bgi.turboc.port.helpers import Helpers
from bgi.turboc.port.outs import Outs
from bgi.turboc.port.pointershapes import (
    BYTES,
    CURSOR,
    IMAGE,
    LIST,
    OBJECT,
    TEXT,
    Key,
    Shapes,
    is_flattened,
)
from bgi.turboc.port.portnames import Names
from bgi.turboc.port.pycode import Code, binary, call, choice, plain, quoted

REGISTERS = ("REGS", "SREGS", "REGPACK")
"""Structures of the library that a program fills itself."""

ALLOCATORS = ("malloc", "calloc", "farmalloc", "farcalloc", "_graphgetmem", "alloca", "_fmalloc")
"""Functions that give memory."""


class PortPlaces:
    """Writes places and pointers."""

    def __init__(
        self, headers: Headers, names: Names, shapes: Shapes, outs: Outs, facts: Facts
    ) -> None:
        self.headers, self.names = headers, names
        self.shapes, self.outs, self.facts = shapes, outs, facts
        self.helpers = Helpers(names.namer)
        self.cells: set[Symbol] = set()
        self.lines: list[tuple[int, str, Place | None]] = []
        """Indent, text, and the place in the source of each line."""
        self.indent = 0
        self.after: list[str] | None = None
        """What is to be done behind the statement, such as `i += 1`; None where that cannot be."""
        self.assigned: set[str] = set()
        """Global variables that the function assigns to."""
        self.taken: set[str] = set()
        """The names of the function's variables."""
        self.place: Place | None = None

    # Lines

    def line(self, text: str, place: Place | None = None) -> None:
        """A line of Python."""
        self.lines.append((self.indent, text, place or self.place))
        self.place = None

    @contextmanager
    def block(self, head: str, place: Place | None = None) -> Iterator[None]:
        """Lines further in; there is at least one."""
        self.line(head, place)
        self.indent += 1
        before = len(self.lines)
        yield
        if not any(text for _, text, _ in self.lines[before:]):
            self.line("pass")
        self.indent -= 1

    @contextmanager
    def captured(self) -> Iterator[list[tuple[int, str, Place | None]]]:
        """What is to be done before a value is computed, kept apart."""
        outer, self.lines = self.lines, []
        after, self.after = self.after, None
        yield self.lines
        self.lines, self.after = outer, after

    def temporary(self, wanted: str) -> str:
        """A name for a value of the moment, which no variable of the function has."""
        name, number = wanted, 1
        while name in self.taken or name in self.names.namer.taken:
            number += 1
            name = f"{wanted}_{number}"
        return name

    # Others know

    def value(self, value: Value) -> Code:
        """A value."""
        raise NotImplementedError

    def test(self, value: Value) -> Code:
        """A value that is only asked whether it is 0."""
        raise NotImplementedError

    def created(self, value: Creation) -> Code:
        """A new object."""
        raise NotImplementedError

    def refuse(self, place: Place, what: str) -> CError:
        """What cannot be carried over."""
        return CError(place, f"this cannot be carried over to Python: {what}")

    # Variables

    def name_of(self, symbol: Symbol) -> str:
        """The Python name of a variable."""
        if not symbol.python:
            symbol.python = plain(symbol.name)
        return symbol.python

    def place_code(self, value: Value) -> Code:
        """A place, to read and to write."""
        match value:
            case Variable(symbol=symbol):
                return self.variable(symbol)
            case Field(base=base, name=name):
                return Code(f"{self.object(base)}.{plain(name)}")
            case Element():
                return self.element(value)
            case Referred(operand=Variable(symbol=symbol)):
                return self.variable(symbol)
            case Referred(operand=operand):
                return self.value(operand)
        return self.value(value)

    def target(self, value: Value) -> Code:
        """A place that is assigned to."""
        symbol = value.symbol if isinstance(value, Variable) else None
        if symbol is not None and symbol.kind == "global" and symbol not in self.cells:
            name = self.name_of(symbol)
            self.assigned |= {name} if "." not in name else set()
        return self.place_code(value)

    def variable(self, symbol: Symbol) -> Code:
        """A variable; one that pointers point to is a list of one."""
        name = self.name_of(symbol)
        return Code(f"{name}[0]" if symbol in self.cells else name)

    def object(self, value: Value) -> str:
        """What stands before the dot of a member."""
        return self.value(value).inside(17)

    def element(self, value: Element) -> Code:
        """An element, or what a pointer points to."""
        base, index = value.base, value.index
        first = isinstance(index, Constant) and not index.value
        if first and isinstance(base, Variable) and base.symbol in self.outs.found:
            return self.variable(base.symbol)
        shape = self.shapes.shape(base)
        code = self.value(base) if not isinstance(base.type, ArrayType) else self.place_code(base)
        if shape == OBJECT and first:
            return code
        return Code(f"{code.inside(17)}[{self.value(index)}]")

    # What a variable holds at first

    def nothing(self, type_: Type, key: Key) -> Code:
        """What a variable holds to which nothing has been assigned."""
        match type_:
            case IntType():
                return Code("0")
            case FloatType():
                return Code("0.0")
            case StructType():
                return self.empty_object(type_)
            case ArrayType(of, count):
                shape = self.shapes.of_key(key, type_)
                if shape == TEXT:
                    return Code('""')
                if shape == IMAGE:
                    return Code("None")
                if shape == BYTES:
                    return Code(f"bytearray({count})")
                return self.many(of, self.shapes.deeper(key), Code(str(count)))
        return Code("None")

    def empty_object(self, type_: StructType) -> Code:
        """An object of a class, as it is at first."""
        if type_.library:
            return self.library_object(type_)
        return Code(f"{type_.python}()")

    def library_object(self, type_: StructType) -> Code:
        """A structure of the library, before it is asked for."""
        if type_.tag in REGISTERS:
            return Code(f"{self.names.use('bgi.dos', type_.tag)}()")
        return Code("None")

    def many(self, type_: Type, key: Key, count: Code) -> Code:
        """A list of so many elements."""
        one = self.nothing(type_, key)
        inside = isinstance(type_, (ArrayType, StructType)) and one not in ('""', "None")
        if inside:
            return Code(f"[{one} for _ in range({count})]")
        return binary("*", Code(f"[{one}]"), count)

    # Pointers

    def pointer(self, value: Value, wanted: str) -> Code:
        """A pointer, in the shape that is wanted."""
        while isinstance(value, Converted) and isinstance(value.operand.type, PointerType):
            if is_flattened(value):
                rows = self.pointer(value.operand, LIST)
                return Code(f"[one for row in {rows} for one in row]")
            value = value.operand
        match value:
            case Constant() | Converted(operand=Constant()):
                return Code("None")
            case Address(operand=Quoted() as text):
                return self._literal(text, wanted)
            case Address(operand=operand) if isinstance(operand.type, ArrayType):
                return self._array(operand, wanted)
            case Address(operand=operand):
                return self._address(value, operand, wanted)
            case Offset(base=base, count=count):
                return self._offset(value, base, count, wanted)
            case LibraryCall(name=name) if name in ALLOCATORS:
                return self.allocated(value, wanted)
            case Choice(condition=condition, yes=yes, no=no):
                both = self.pointer(yes, wanted), self.pointer(no, wanted)
                return choice(both[0], self.test(condition), both[1])
        return self.adapted(self.value(value), self.shapes.shape(value), wanted, value.place)

    def _literal(self, text: Quoted, wanted: str) -> Code:
        if wanted in (BYTES, LIST, CURSOR):
            code = Code(f"bytearray({text.data + bytes(1)!r})")
            return self._cursor(code) if wanted == CURSOR else code
        return self.names.named(text) or quoted(text.data.partition(b"\0")[0].decode("cp437"))

    def _cursor(self, code: Code, at: Code | None = None) -> Code:
        return call(self.helpers.use("Pointer"), [code] if at is None else [code, at])

    def _array(self, operand: Value, wanted: str) -> Code:
        code = self.place_code(operand)
        if isinstance(operand, Element) and wanted == OBJECT:
            return Code(f"{code}[0]")
        return self.adapted(code, self.shapes.shape(operand), wanted, operand.place)

    def _address(self, value: Address, operand: Value, wanted: str) -> Code:
        struct = isinstance(operand.type, StructType)
        if isinstance(operand, Element) and (wanted == CURSOR or not struct):
            return self._offset(value, operand.base, operand.index, wanted)
        if struct:
            code = self.value(operand)
            if wanted == CURSOR:
                return self._cursor(Code(f"[{code}]"))
            return Code(f"[{code}]") if wanted == LIST else code
        if isinstance(operand, Variable) and operand.symbol in self.cells:
            code = Code(self.name_of(operand.symbol))
            return self._cursor(code) if wanted == CURSOR else code
        if isinstance(operand, Referred):
            return self.pointer(operand.operand, wanted)
        raise self.refuse(value.place, "a pointer to this place")

    def _offset(self, value: Value, base: Value, index: Value, wanted: str) -> Code:
        """A place so many elements further than another."""
        count = self.value(index)
        shape = self.shapes.shape(base)
        if isinstance(base, Address) and isinstance(base.operand.type, ArrayType):
            base = base.operand
        memory = self.place_code(base) if isinstance(base.type, ArrayType) else self.value(base)
        if wanted in (OBJECT, ""):
            return Code(f"{memory.inside(17)}[{count}]")
        if shape == CURSOR and wanted == CURSOR:
            return binary("+", memory, count)
        if wanted == CURSOR:
            return self._cursor(memory, count)
        if wanted == TEXT:
            text = self.adapted(memory, shape, TEXT, value.place)
            return text if count == "0" else Code(f"{text.inside(17)}[{count}:]")
        return Code(f"{memory.inside(17)}[{count}:]")

    def adapted(self, code: Code, shape: str, wanted: str, place: Place) -> Code:
        """A pointer of one shape as one of another."""
        if shape == wanted or not wanted or not shape or code == "None":
            return code
        if wanted == TEXT and shape in (BYTES, CURSOR, LIST):
            return call(self.helpers.use("text"), [code])
        if wanted == CURSOR and shape in (LIST, BYTES):
            return self._cursor(code)
        if wanted == OBJECT and shape in (LIST, CURSOR):
            return Code(f"{code.inside(17)}[0]")
        if wanted == IMAGE or shape == IMAGE or {shape, wanted} == {LIST, BYTES}:
            return code
        if wanted == BYTES and shape == TEXT:
            return Code(f'bytearray({code}.encode("cp437") + b"\\0")')
        raise self.refuse(place, f"{_one(shape)} used as {_one(wanted)}")

    def string(self, value: Value) -> Code:
        """A string to read."""
        return self.pointer(value, TEXT)

    # Memory

    def allocated(self, value: LibraryCall, wanted: str, to: Type | None = None) -> Code:
        """Memory of malloc(), of as many elements as its size says."""
        if wanted == IMAGE or to is None:
            return Code(f"bytearray({self.value(value.arguments[0])})")
        count = self._count(value, to)
        if isinstance(to, StructType) and wanted == OBJECT:
            return self.empty_object(to)
        if wanted == TEXT:
            return Code('""')
        if to in (CHAR, UCHAR) and wanted in (BYTES, CURSOR):
            made = Code(f"bytearray({count})")
        else:
            key = self.shapes.deeper(self.shapes.key(value))
            made = self.many(to, key, count)
        return self._cursor(made) if wanted == CURSOR else made

    def _count(self, value: LibraryCall, to: Type) -> Code:
        bytes_ = value.arguments[0]
        if value.name.endswith("calloc"):
            return self.value(bytes_)
        one = size(to)
        while isinstance(bytes_, Converted):
            bytes_ = bytes_.operand
        if isinstance(bytes_, Constant):
            return Code(str(int(bytes_.value) // one))
        for many, each in (("left", "right"), ("right", "left")):
            factor = getattr(bytes_, each, None)
            while isinstance(factor, Converted):
                factor = factor.operand
            if isinstance(factor, Constant) and factor.value == one and bytes_.op == "*":  # type: ignore[attr-defined]
                return self.value(getattr(bytes_, many))
        return self.value(bytes_) if one == 1 else binary("//", self.value(bytes_), Code(str(one)))

    def destination(self, target: Value) -> str:
        """The shape that a pointer takes in the place that it is stored in."""
        return self.shapes.of_key(self.shapes.key(target), target.type)

    def given(self, value: Value, wanted: str, to: Type | None = None) -> Code:
        """A value for a place: a pointer in its shape, a number as it is."""
        if not isinstance(value.type, (PointerType, ReferenceType)):
            return self.value(value)
        inner = value
        while isinstance(inner, Converted):
            inner = inner.operand
        if isinstance(inner, LibraryCall) and inner.name in ALLOCATORS:
            pointed = to if to is not None else value.type
            assert isinstance(pointed, (PointerType, ReferenceType))
            return self.allocated(inner, wanted, pointed.to)
        return self.pointer(value, wanted)


def _one(shape: str) -> str:
    """A shape with its article."""
    return f"an {shape}" if shape[0] in "aeiou" else f"a {shape}"


def is_plain(value: Value) -> bool:
    """Whether a value is a number that a plain variable holds."""
    return isinstance(value, Variable) and is_number(value.type)


def is_itself(value: Value) -> bool:
    """Whether a value is the object whose method it is."""
    return isinstance(value, Itself)
