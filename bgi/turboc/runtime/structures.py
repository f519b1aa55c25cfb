"""The structures of the headers as Python has them; registers by words and by their bytes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from bgi.turboc.runtime.memory import Record

_MEMBERS = re.compile(r"(?:unsigned char|unsigned|char|int|long) ([\w, ]+);")


def structure(name: str, definition: str) -> type[Record]:
    """A class with the members of a C structure, all 0."""
    members = tuple(
        one.strip() for group in _MEMBERS.findall(definition) for one in group.split(",")
    )

    def begin(self: Any) -> None:
        for member in members:
            setattr(self, member, 0)

    body = {"__slots__": members, "MEMBERS": members, "__init__": begin}
    return type(name, (Record,), body)


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
    made = {name: structure(name, text) for name, text in definitions.items() if "::" not in name}
    words = made["WORDREGS"]

    class REGS(Record):
        """Words and bytes of the same registers."""

        __slots__ = ("h", "x")
        MEMBERS = ("x",)

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
