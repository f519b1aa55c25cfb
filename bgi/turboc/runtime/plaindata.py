"""Plain data as the bytes that a PC had for them, and back: for fread(), memcpy() and their like.

A layout is a letter of `struct`, an empty str for a pointer, a pair of a layout and a count for an
array, or a class for its objects; None if nobody knows.
"""

from __future__ import annotations

import struct
from typing import Any

from bgi.turboc.runtime.memory import CharMember, Pointer, Record, Union, write_bytes

Layout = Any

POINTER_SIZE = 4


def size_of(layout: Layout) -> int:
    """How many bytes a value takes."""
    match layout:
        case "":
            return POINTER_SIZE
        case str():
            return struct.calcsize(f"<{layout}")
        case (of, count):
            return int(size_of(of) * count)
    return int(layout.SIZE)


def to_bytes(value: Any, layout: Layout) -> bytes:
    """A value as bytes; a pointer is null there, for what it points to is not in them."""
    match layout:
        case "":
            return bytes(POINTER_SIZE)
        case str():
            return struct.pack(f"<{layout}", value)
        case (of, _):
            if isinstance(value, bytearray):
                return bytes(value)
            return b"".join([to_bytes(one, of) for one in value])
    if isinstance(value, Union):
        return bytes(value.shared_bytes)
    members = [to_bytes(getattr(value, name), one) for name, one in layout.LAYOUT]
    return b"".join(members)


def from_bytes(data: bytes, layout: Layout, old: Any) -> Any:
    """A value of bytes; arrays and objects are changed in their places."""
    match layout:
        case "":
            return None
        case str():
            return struct.unpack(f"<{layout}", data)[0]
        case (of, count):
            if isinstance(old, bytearray):
                old[:] = data
                return old
            one = size_of(of)
            for place in range(count):
                part = data[place * one : (place + 1) * one]
                old[place] = from_bytes(part, of, old[place])
            return old
    if isinstance(old, Union):
        old.shared_bytes[:] = data
        return old
    begin = 0
    for name, member in layout.LAYOUT:
        end = begin + size_of(member)
        setattr(old, name, from_bytes(data[begin:end], member, getattr(old, name)))
        begin = end
    return old


class Plain:
    """What a pointer of C points to, as bytes."""

    __slots__ = ("_layout", "pointer")

    def __init__(self, pointer: Any, layout: Layout) -> None:
        self.pointer = pointer
        self._layout = layout

    @property
    def layout(self) -> Layout:
        """That of an element: a pointer that was cast says less than what it points to."""
        memory, at = self.pointer.memory, self.pointer.at
        if isinstance(memory, CharMember):
            return "B"
        if self._layout in (None, "b", "B") or isinstance(memory[at], Record):
            return _guessed(memory[at])
        return self._layout

    def get(self, count: int) -> bytes:
        """So many bytes; what is behind the end of the memory is 0."""
        memory, at = self.pointer.memory, self.pointer.at
        if isinstance(memory, bytearray):
            return bytes(memory[at : at + count]).ljust(count, b"\0")
        layout = self.layout
        places = range(at, min(at - (-count // size_of(layout)), len(memory)))
        data = b"".join([to_bytes(memory[place], layout) for place in places])
        return data[:count].ljust(count, b"\0")

    def put(self, data: bytes) -> None:
        """Store bytes; IndexError if there is no room."""
        memory, at = self.pointer.memory, self.pointer.at
        if isinstance(memory, bytearray):
            write_bytes(self.pointer, data)
            return
        layout = self.layout
        one = size_of(layout)
        for place, begin in enumerate(range(0, len(data), one), at):
            part = data[begin : begin + one]
            if len(part) < one:
                part += to_bytes(memory[place], layout)[len(part) :]
            memory[place] = from_bytes(part, layout, memory[place])

    def elements(self, count: int) -> int | None:
        """How many elements so many bytes are; None if they are no whole number of them."""
        one = 1 if isinstance(self.pointer.memory, bytearray) else size_of(self.layout)
        return None if count % one else count // one


def _guessed(value: Any) -> Layout:
    """The layout of a value."""
    if isinstance(value, Record):
        return type(value)
    if isinstance(value, Pointer) or value is None:
        return ""
    return "f" if isinstance(value, float) else "h"
