"""What each pointer and each array of a program becomes in Python.

Pointers that are assigned to each other are a family: all of them become the same. A family whose
members are only followed by `->` are objects; those that are only indexed are lists; strings that
are never changed letter by letter are Python's strings; what goes on walks gets a class of its own.
"""

from __future__ import annotations

from typing import Any

from bgi.turboc.checker.typed import (
    Address,
    Advance,
    Choice,
    Constant,
    Converted,
    Element,
    Field,
    Invocation,
    MethodCall,
    Offset,
    Quoted,
    Referred,
    Sequence,
    Store,
    Update,
    Value,
    Variable,
)
from bgi.turboc.checker.types import (
    CHAR,
    UCHAR,
    ArrayType,
    FunctionType,
    PointerType,
    ReferenceType,
    StructType,
    Symbol,
    Type,
)

OBJECT, LIST, TEXT, BYTES, CURSOR, IMAGE, FUNCTION, CELL = [
    "object",
    "list",
    "text",
    "bytes",
    "cursor",
    "image",
    "function",
    "cell",
]
"""What a pointer can be."""

Key = tuple[Any, int]
"""Whose pointer it is, and how many steps from there."""


class Family:
    """Pointers, or memories, that are the same."""

    def __init__(self) -> None:
        self.flags: set[str] = set()
        self._parent: Family | None = None

    def head(self) -> Family:
        """The one that stands for all."""
        found = self
        while found._parent is not None:
            found = found._parent
        return found

    def join(self, other: Family) -> None:
        """Make two families one."""
        mine, others = self.head(), other.head()
        if mine is not others:
            others._parent = mine
            mine.flags |= others.flags


class Shapes:
    """The families of a program, and what they become."""

    def __init__(self) -> None:
        self._handles: dict[Key, Family] = {}
        self._memories: dict[Key, Family] = {}
        self._inner: dict[Key, Key] = {}
        self._kept: list[Value] = []
        """Values whose identity is a key: they have to live as long."""

    def handle(self, key: Key) -> Family:
        """The family of a pointer."""
        return self._handles.setdefault(key, Family()).head()

    def memory(self, key: Key) -> Family:
        """The family of the memory that a pointer leads to."""
        return self._memories.setdefault(key, Family()).head()

    def deeper(self, key: Key) -> Key:
        """What stands in the memory that a pointer leads to."""
        return self._inner.get(key) or (key[0], key[1] + 1)

    def key(self, value: Value) -> Key:
        """Whose pointer, or array, a value is."""
        match value:
            case Variable(symbol=symbol):
                return symbol, 0
            case Field(base=base, name=name):
                return (owner(base.type, name), name), 0
            case Element(base=base):
                return self.deeper(self.key(base))
            case Referred(operand=operand) | Converted(operand=operand):
                return self.key(operand)
            case Address(operand=operand) if isinstance(operand.type, ArrayType):
                return self.key(operand)
            case Address(operand=operand):
                made = self._of_value(value, self.key(operand))
                if isinstance(operand, Element):
                    self.memory(self.key(operand.base)).join(self.memory(made))
                return made
            case Offset(base=base):
                made = self._of_value(value, self.deeper(self.key(base)))
                self.memory(self.key(base)).join(self.memory(made))
                return made
            case Sequence(items=items):
                return self.key(items[-1])
            case Store(target=target) | Update(target=target) | Advance(target=target):
                return self.key(target)
            case Invocation(function=Variable(symbol=symbol)) | MethodCall(method=symbol):
                return ("result", symbol), 0
        return self._of_value(value, None)

    def _of_value(self, value: Value, inner: Key | None) -> Key:
        self._kept.append(value)
        key = id(value), 0
        if inner is not None:
            self._inner[key] = inner
        return key

    # What flows where

    def flow(self, to: Key, value: Value) -> None:
        """A value becomes what a pointer holds."""
        while isinstance(value, Converted) and isinstance(value.operand.type, PointerType):
            if is_flattened(value):
                return  # a copy
            value = value.operand
        if isinstance(value, Converted | Constant):
            self.handle(to).flags.add("null")
            return
        if isinstance(value, Choice):
            self.flow(to, value.yes)
            self.flow(to, value.no)
            self.same(to, self.key(value))
            return
        from_ = self.key(value)
        self.memory(to).join(self.memory(from_))
        self._join_inside(self.deeper(to), self.deeper(from_))
        source = _source(value)
        if source:
            self.handle(to).flags.add(source)
        else:
            self.handle(to).join(self.handle(from_))
        if isinstance(value, Address) and isinstance(value.operand, Quoted):
            self.memory(to).flags.add("text")

    def same(self, one: Key, other: Key) -> None:
        """Two are of one family, and so is what they lead to."""
        self.handle(one).join(self.handle(other))
        self.memory(one).join(self.memory(other))
        self._join_inside(self.deeper(one), self.deeper(other))

    def _join_inside(self, one: Key, other: Key, depth: int = 0) -> None:
        if depth < 3 and one != other:
            self.handle(one).join(self.handle(other))
            self.memory(one).join(self.memory(other))
            self._join_inside(self.deeper(one), self.deeper(other), depth + 1)

    # What becomes of them

    def shape(self, value: Value) -> str:
        """What a value is in Python that is a pointer or an array."""
        return self.of_key(self.key(value), value.type)

    def of_key(self, key: Key, type_: Type) -> str:
        """What a pointer or an array of that type becomes."""
        if isinstance(type_, ReferenceType):
            type_ = type_.to
        memory, handle = self.memory(key).flags, self.handle(key).flags
        if "image" in memory:
            return IMAGE
        if isinstance(type_, ArrayType):
            return self._of_array(memory, type_)
        if not isinstance(type_, PointerType):
            return ""
        to = type_.to
        if isinstance(to, FunctionType):
            return FUNCTION
        if to in (CHAR, UCHAR) and "text" in memory:
            return self._of_text(memory, handle)
        walks = {"advance", "order", "distance"} & handle
        if isinstance(to, StructType):
            if not walks and "index" not in handle:
                return OBJECT
            return CURSOR if walks or {"from_offset", "from_object"} & handle else LIST
        if walks or {"from_offset", "from_field"} & handle:
            return CURSOR
        return LIST

    def _of_array(self, memory: set[str], type_: ArrayType) -> str:
        if type_.of in (CHAR, UCHAR) and "text" in memory:
            return BYTES if self._is_changed(memory) else TEXT
        return LIST

    def _of_text(self, memory: set[str], handle: set[str]) -> str:
        if not self._is_changed(memory):
            return TEXT
        walks = {"advance", "from_offset", "order", "distance"} & handle
        return CURSOR if walks else BYTES

    def _is_changed(self, memory: set[str]) -> bool:
        """Whether a memory of characters is written letter by letter, or through pointers."""
        return bool(memory & {"written", "filled_through", "data", "distance"})


def is_flattened(value: Converted) -> bool:
    """Whether a pointer to rows is taken for one to what stands in them."""
    inner, to = value.operand, value.type
    while isinstance(inner, Converted):
        inner = inner.operand
    if not (isinstance(inner.type, PointerType) and isinstance(to, PointerType)):
        return False
    row = inner.type.to
    if isinstance(inner, Address) and isinstance(inner.operand.type, ArrayType):
        row = inner.operand.type.of
    return isinstance(row, ArrayType) and row.of == to.to


def owner(type_: Type, name: str) -> StructType | None:
    """The class that a member belongs to."""
    cls = type_ if isinstance(type_, StructType) else None
    while cls is not None and name not in cls.members:
        cls = cls.base
    return cls


def _source(value: Value) -> str:
    """Where a pointer comes from, if it is not from another pointer."""
    match value:
        case Address(operand=operand) if isinstance(operand.type, ArrayType):
            return "from_array"
        case Address(operand=operand) if isinstance(operand.type, StructType):
            return "from_object"
        case Address(operand=Field()):
            return "from_field"
        case Offset() | Address(operand=Element()):
            return "from_offset"
        case Address():
            return "from_variable"
    return ""


def addressed(value: Value) -> Symbol | None:
    """The variable whose address a value is, if it is a number or a pointer."""
    match value:
        case Address(operand=Variable(symbol=symbol)):
            if not isinstance(symbol.type, (ArrayType, StructType)):
                return symbol
    return None
