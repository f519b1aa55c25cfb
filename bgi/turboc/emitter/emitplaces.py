"""Places in memory as Python: variables, members and elements, to read and to write."""

from __future__ import annotations

import re
from typing import NamedTuple

from bgi.turboc.checker.headers import Headers
from bgi.turboc.checker.scopes import Namer, safe
from bgi.turboc.checker.typed import (
    Address,
    Element,
    Field,
    Itself,
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
    FunctionType,
    IntType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
    flat,
    innermost,
)
from bgi.turboc.emitter.wrapping import Interval, cut

SIMPLE = re.compile(r"[A-Za-z_][\w.]*|\d+")
"""What may be written twice: it costs next to nothing."""


class Spot(NamedTuple):
    """A place: how it is read, and how it is written."""

    read: str
    write: str
    """A statement, with `@` for the value."""
    expression: str
    """The same as an expression."""
    before: tuple[tuple[str, str], ...] = ()
    """Names that have to be set before."""
    memory: str = ""
    at: str = ""

    def store(self, value: str) -> str:
        """An expression that stores a value."""
        return self.expression.replace("@", value)


def is_cell(symbol: Symbol) -> bool:
    """Whether a variable lives in a memory of one, since its address is taken."""
    return symbol.addressed and isinstance(symbol.type, (IntType, FloatType, PointerType))


class Places:
    """Writes places."""

    def __init__(self, headers: Headers, namer: Namer) -> None:
        self.headers = headers
        self.namer = namer
        self.known: dict[Symbol, Interval] = {}
        """Where variables lie that are known to stay within bounds."""
        self.present: list[str] = []
        """What the targets of the updates around hold."""
        self.used: set[str] = set()
        """Functions of the library that are called."""
        self.assigned: set[str] = set()
        """Global variables that the function assigns to."""
        self.hidden: set[Symbol] = set()
        """Methods of whose names a class that is derived has others."""
        self.strings: dict[bytes, str] = {}
        self.temporaries = 0

    def value(self, value: Value) -> str:
        """A value."""
        raise NotImplementedError

    def temporary(self) -> str:
        """A name for a value of the moment."""
        self.temporaries += 1
        return f"_{self.temporaries}"

    def name_of(self, symbol: Symbol) -> str:
        """The Python name of a variable or function."""
        if symbol.kind == "library" or not symbol.python:
            symbol.python = symbol.python or symbol.name
        if self.headers.symbol(symbol.name) is symbol:
            self.used.add(symbol.name)
        return symbol.python

    # Memory

    def nothing(self, type_: Type) -> str:
        """What a variable holds to which nothing has been assigned."""
        match type_:
            case IntType():
                return "0"
            case FloatType():
                return "0.0"
            case StructType():
                if type_.library:
                    self.used.add(type_.python)
                return f"{type_.python}()"
            case ArrayType():
                return self.many(innermost(type_), str(flat(type_)))
        return "None"

    def many(self, type_: Type, count: str) -> str:
        """A memory of so many elements."""
        if type_ in (CHAR, UCHAR):
            return f"bytearray({count})"
        if isinstance(type_, StructType):
            return f"[{self.nothing(type_)} for _ in range({count})]"
        return f"[{self.nothing(type_)}] * ({count})"

    def cell(self, text: str, type_: Type) -> str:
        """A memory of one."""
        return f"bytearray([{text} & 255])" if type_ in (CHAR, UCHAR) else f"[{text}]"

    def string(self, value: Quoted) -> str:
        """A string, which all that write the same share."""
        name = self.strings.get(value.data)
        if name is None:
            name = self.strings[value.data] = self.namer.name(f"text_{len(self.strings) + 1}")
        return name

    def scaled(self, count: str, by: int) -> str:
        """A number times a known one."""
        if count.isdecimal():
            return str(int(count) * by)
        return count if by == 1 else f"{count} * {by}"

    # Places

    def spot(self, value: Value) -> Spot:
        """A place that a number, pointer or object stands in."""
        match value:
            case Variable(symbol=symbol):
                return self._variable_spot(symbol)
            case Field(base=base, name=name):
                return self._field_spot(base, name)
            case Element():
                memory, at = self.element(value)
                return self.memory_spot(memory, at, value.type)
            case Referred(operand=operand):
                if isinstance(value.type, StructType):
                    text = self.value(operand)
                    return Spot(text, f"{text} = @", f"({text} := @)")
                memory, at = self.pointed(operand)
                return self.memory_spot(memory, at, value.type)
        text = self.value(value)
        return Spot(text, f"{text} = @", f"{text}.assign(@)")

    def _variable_spot(self, symbol: Symbol) -> Spot:
        name = self.name_of(symbol)
        if is_cell(symbol):
            return self.memory_spot(name, "0", symbol.type)
        if symbol.kind == "global":
            self.assigned.add(name)
        return Spot(name, f"{name} = @", f"({name} := @)")

    def _field_spot(self, base: Value, name: str) -> Spot:
        text = self.value(base)
        attribute = self.attribute(name)
        stored = f"put_member({text}, {attribute!r}, @)"
        return Spot(f"{text}.{attribute}", f"{text}.{attribute} = @", stored)

    def attribute(self, name: str) -> str:
        """The Python name of a member."""
        return safe(name)

    def memory_spot(self, memory: str, at: str, type_: Type) -> Spot:
        """An element of a memory; those of characters hold bytes."""
        read, write = f"{memory}[{at}]", f"{memory}[{at}] = @"
        stored = f"put({memory}, {at}, @)"
        if type_ == CHAR:
            read = f"(({read} ^ 128) - 128)"
            stored = f"((put({memory}, {at}, @ & 255) ^ 128) - 128)"
        if type_ in (CHAR, UCHAR):
            write = f"{memory}[{at}] = @ & 255"
        if type_ == UCHAR:
            stored = f"put({memory}, {at}, @ & 255)"
        return Spot(read, write, stored, (), memory, at)

    def settled(self, spot: Spot) -> Spot:
        """A place that may be used twice: what is computed on the way is computed once."""
        before: list[tuple[str, str]] = []
        changed: dict[str, str] = {}
        if spot.memory:
            for text in (spot.memory, spot.at):
                if not SIMPLE.fullmatch(text):
                    name = self.temporary()
                    before.append((name, text))
                    changed[text] = name
        elif "." in spot.read and "(" in spot.read:
            text = spot.read.rpartition(".")[0]
            name = self.temporary()
            before.append((name, text))
            changed[text] = name
        if not before:
            return spot
        read, write, expression = spot.read, spot.write, spot.expression
        for text, name in changed.items():
            read = read.replace(text, name)
            write, expression = write.replace(text, name), expression.replace(text, name)
        return Spot(read, write, expression, tuple(before))

    def element(self, value: Element) -> tuple[str, str]:
        """The memory of an element, and where in it that is."""
        if isinstance(value.base.type, ArrayType):
            memory, start = self.array(value.base)
        else:
            memory, start = self.pointed(value.base)
        count = self.scaled(self.value(value.index), flat(value.type))
        at = count if start == "0" else start if count == "0" else f"{start} + {count}"
        low = cut(value.index, self.known)[0]
        if low >= 0:
            return memory, at
        if isinstance(value.type, ArrayType):
            return memory, at
        if SIMPLE.fullmatch(at):
            return memory, f"{at} if {at} >= 0 else index({at})"
        name = self.temporary()
        return memory, f"{name} if ({name} := {at}) >= 0 else index({name})"

    def array(self, value: Value) -> tuple[str, str]:
        """The memory that an array lies in, and where it begins."""
        match value:
            case Variable(symbol=symbol):
                return self.name_of(symbol), "0"
            case Element():
                return self.element(value)
            case Quoted():
                return self.string(value), "0"
            case Referred(operand=operand):
                return self.pointed(operand)
        return self.value(value), "0"

    def pointed(self, value: Value) -> tuple[str, str]:
        """The memory that a pointer points into, and where."""
        if isinstance(value, Address) and isinstance(value.operand.type, ArrayType):
            return self.array(value.operand)
        if isinstance(value, Offset) and isinstance(value.type, PointerType):
            memory, at = self.pointed(value.base)
            count = self.scaled(self.value(value.count), flat(value.type.to))
            return memory, count if at == "0" else f"{at} + {count}"
        text = self.value(value)
        if re.fullmatch(r"[A-Za-z_]\w*", text):
            return f"{text}.memory", f"{text}.at"
        name = self.temporary()
        return f"({name} := {text}).memory", f"{name}.at"

    def address(self, value: Value, type_: Type) -> str:
        """A pointer to a place, or a reference."""
        to = value.type
        if isinstance(type_, ReferenceType) and isinstance(to, StructType):
            return self.value(value)
        if isinstance(to, ArrayType):
            memory, at = self.array(value)
            return f"Pointer({memory}, {at})"
        match value:
            case Variable(symbol=symbol) if is_cell(symbol):
                return f"Pointer({self.name_of(symbol)})"
            case Element() if not isinstance(to, FunctionType):
                memory, at = self.element(value)
                return f"Pointer({memory}, {at})"
            case Field(base=base, name=name) if not isinstance(to, StructType):
                kind = "CharMember" if to in (CHAR, UCHAR) else "MemberPlace"
                return f"Pointer({kind}({self.value(base)}, {self.attribute(name)!r}))"
            case Referred(operand=operand) if not isinstance(to, StructType):
                return self.value(operand)
            case Itself():
                return "Pointer([self])"
        return f"Pointer({self.cell(self.value(value), to)})"
