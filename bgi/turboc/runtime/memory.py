"""The memory of a running C program: pointers, blocks of bytes, and members to point to.

A memory is a list, or a bytearray for characters. A variable that is pointed to is a memory of one.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

MOST_BYTES = 64 << 20
"""Of all that a program may hold at a time, nearly."""


class Pointer:
    """A place in a memory; null is None."""

    __slots__ = ("at", "memory")

    def __init__(self, memory: Any, at: int = 0) -> None:
        self.memory = memory
        self.at = at

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Pointer):
            return False
        if self.memory is other.memory:
            return self.at == other.at
        return self._object() is not None and self._object() is other._object()

    def _object(self) -> Any:
        """The object that it points to, if it is one."""
        if isinstance(self.memory, list) and 0 <= self.at < len(self.memory):
            found = self.memory[self.at]
            return None if isinstance(found, (int, float, Pointer)) else found
        return (
            (self.memory.base, self.memory.name) if isinstance(self.memory, MemberPlace) else None
        )

    def __hash__(self) -> int:
        return hash(self.at)

    def __lt__(self, other: Pointer) -> bool:
        return self.at < other.at

    def __le__(self, other: Pointer) -> bool:
        return self.at <= other.at

    def __gt__(self, other: Pointer) -> bool:
        return self.at > other.at

    def __ge__(self, other: Pointer) -> bool:
        return self.at >= other.at

    def __add__(self, count: int) -> Pointer:
        return Pointer(self.memory, self.at + count)

    def __sub__(self, other: Any) -> Any:
        if isinstance(other, Pointer):
            return self.at - other.at
        return Pointer(self.memory, self.at - other)


class MemberPlace:
    """A member of an object as a memory of one."""

    __slots__ = ("base", "name")

    def __init__(self, base: Any, name: str) -> None:
        self.base = base
        self.name = name

    def __len__(self) -> int:
        return 1

    def __getitem__(self, index: int) -> Any:
        if index:
            raise IndexError(index)
        return getattr(self.base, self.name)

    def __setitem__(self, index: int, value: Any) -> None:
        if index:
            raise IndexError(index)
        setattr(self.base, self.name, value)


class CharMember(MemberPlace):
    """A member that is a character: its memory holds bytes, as all memories of characters do."""

    __slots__ = ()

    def __getitem__(self, index: int) -> Any:
        return super().__getitem__(index) & 0xFF

    def __setitem__(self, index: int, value: Any) -> None:
        super().__setitem__(index, (value & 0xFF ^ 0x80) - 0x80)


class Allocated(bytearray):
    """Memory of malloc(): bytes, until the program says by a pointer's type what they are."""

    __slots__ = ("elements",)
    elements: list[Any]
    taken = 0
    """By all of them."""

    def __init__(self, size: int) -> None:
        super().__init__(size)
        Allocated.taken += size

    def __del__(self) -> None:
        Allocated.taken -= len(self)


def typed(pointer: Any, size: int, make: Callable[[int], list[Any]]) -> Any:
    """A pointer to memory of malloc() as elements of a type: so many bytes are one."""
    if pointer is None or not isinstance(pointer.memory, Allocated):
        far = pointer is not None and hasattr(pointer.memory, "typed")
        return pointer.memory.typed(size, pointer.at) if far else pointer
    block = pointer.memory
    if not hasattr(block, "elements"):
        block.elements = make(max(len(block) // size, 1))
    return Pointer(block.elements, pointer.at // size)


def room(count: int) -> int:
    """The number of elements that `new` makes; MemoryError for too many."""
    if not 0 <= count <= MOST_BYTES // 8:
        raise MemoryError
    return count


def put(memory: Any, at: int, value: Any) -> Any:
    """Store into a memory, as an expression: the value comes back."""
    memory[at] = value
    return value


def put_member(base: Any, name: str, value: Any) -> Any:
    """Store into a member, as an expression."""
    setattr(base, name, value)
    return value


def index(at: int) -> int:
    """An index into a memory; IndexError before its beginning, where Python would count back."""
    if at < 0:
        raise IndexError(at)
    return at


def text(pointer: Any) -> bytes:
    """The characters that a pointer points to, up to the zero that ends them."""
    memory, at = pointer.memory, pointer.at
    if not isinstance(memory, bytearray):
        memory = bytearray(memory[place] for place in range(len(memory)))
    if at < 0:
        raise IndexError(at)
    end = memory.find(0, at)
    return bytes(memory[at:] if end < 0 else memory[at:end])


def write_text(pointer: Any, data: bytes) -> None:
    """Write characters and the zero that ends them; IndexError if there is no room."""
    write_bytes(pointer, data + b"\0")


def write_bytes(pointer: Any, data: bytes) -> None:
    """Write characters; IndexError if there is no room."""
    memory, at = pointer.memory, pointer.at
    if at < 0 or at + len(data) > len(memory):
        raise IndexError(at + len(data))
    if isinstance(memory, bytearray):
        memory[at : at + len(data)] = data
    else:
        for place, code in enumerate(data):
            memory[at + place] = code


def copied(value: Any) -> Any:
    """A struct's member, for a copy of the struct: objects and arrays are copied, too."""
    if isinstance(value, (int, float, Pointer)) or value is None:
        return value
    if isinstance(value, bytearray):
        return value[:]
    if isinstance(value, list):
        return [copied(one) for one in value]
    return value.copy() if hasattr(value, "copy") else value


class Record:
    """What all structs are: objects that can be copied, and assigned to each other."""

    __slots__ = ()
    MEMBERS: tuple[str, ...] = ()

    def assign(self, other: Any) -> Any:
        """Take over all members of another."""
        for name in self.MEMBERS:
            setattr(self, name, copied(getattr(other, name)))
        return self

    def copy(self) -> Any:
        """Another of the same members."""
        made = type(self).__new__(type(self))
        return made.assign(self)

    def filled(self, **members: Any) -> Any:
        """The same with other members."""
        for name, value in members.items():
            setattr(self, name, value)
        return self


class Union(Record):
    """What all unions are: bytes that their members share."""

    __slots__ = ("shared_bytes",)
    MEMBERS = ("shared_bytes",)
    SIZE = 0

    def __init__(self) -> None:
        self.shared_bytes = bytearray(self.SIZE)


def shared(format: str) -> property:
    """A member of a union: a number in a format of `struct`, or with none the bytes themselves."""
    if not format:
        return property(lambda union: union.shared_bytes)
    number = struct.Struct(format)

    def get(union: Union) -> Any:
        return number.unpack_from(union.shared_bytes)[0]

    def put(union: Union, value: Any) -> None:
        number.pack_into(union.shared_bytes, 0, value)

    return property(get, put)
