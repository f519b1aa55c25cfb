"""The structures of the headers as Python has them; registers by words and by their bytes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from bgi.turboc.runtime.memory import Record
from bgi.turboc.runtime.plaindata import Layout, size_of

_LETTERS = {
    **{"unsigned char": "B", "signed char": "b", "char": "b", "int": "h", "unsigned": "H"},
    **{"long": "i", "unsigned long": "I", "double": "d"},
}
_MEMBERS = re.compile(rf"\b({'|'.join(sorted(_LETTERS, key=len, reverse=True))}) ([^;(*]+);")
_ARRAY = re.compile(r"(\w+)\[(\d+)\]")


def _layout(definition: str) -> list[tuple[str, Layout]]:
    """The members of a C structure and how they lie in memory."""
    found: list[tuple[str, Layout]] = []
    for type_, names in _MEMBERS.findall(definition):
        for name in names.split(","):
            letter = _LETTERS[type_]
            array = _ARRAY.fullmatch(name.strip())
            found.append((array[1], (letter, int(array[2]))) if array else (name.strip(), letter))
    return found


def structure(name: str, definition: str) -> type[Record]:
    """A class with the members of a C structure, all 0."""
    layout = _layout(definition)
    members = tuple(member for member, _ in layout)

    def begin(self: Any) -> None:
        for member, one in layout:
            setattr(self, member, bytearray(one[1]) if isinstance(one, tuple) else 0)

    body = {"__slots__": members, "MEMBERS": members, "__init__": begin, "LAYOUT": layout}
    return type(name, (Record,), {**body, "SIZE": sum(size_of(one) for _, one in layout)})


def _half(word: str, high: bool) -> property:
    shift = 8 if high else 0

    def get(self: Any) -> int:
        return getattr(self.words, word) >> shift & 0xFF  # type: ignore[no-any-return]

    def put(self: Any, value: int) -> None:
        kept = getattr(self.words, word) & (0x00FF if high else 0xFF00)
        setattr(self.words, word, kept | (value & 0xFF) << shift)

    return property(get, put)


class ByteRegisters(Record):
    """The registers' halves."""

    __slots__ = ("words",)
    MEMBERS = ("al", "ah", "bl", "bh", "cl", "ch", "dl", "dh")
    al, ah, bl, bh = _half("ax", False), _half("ax", True), _half("bx", False), _half("bx", True)
    cl, ch, dl, dh = _half("cx", False), _half("cx", True), _half("dx", False), _half("dx", True)

    def __init__(self, words: Any) -> None:
        self.words = words


def structures(definitions: Mapping[str, str]) -> dict[str, type[Record]]:
    """All structures of the headers by name."""
    made = {name: structure(name, text) for name, text in definitions.items()}
    words = made["WORDREGS"]

    class REGS(Record):
        """Words and bytes of the same registers."""

        __slots__ = ("h", "x")
        MEMBERS = ("x",)
        LAYOUT = (("x", words),)
        SIZE = 16

        def __init__(self) -> None:
            self.x = words()
            self.h = ByteRegisters(self.x)

        def assign(self, other: Any) -> Any:
            """Take over another's registers."""
            self.x.assign(other.x)
            return self

        def copy(self) -> Any:
            """The same registers once more."""
            return REGS().assign(self)

    return {**made, "REGS": REGS, "BYTEREGS": ByteRegisters}
