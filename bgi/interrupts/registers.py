"""The registers of an interrupt, as dos.h lays them out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from bgi.errors import brief
from bgi.kernel.arguments import length, whole

CARRY, ZERO = 0x01, 0x40
"""Bits of the flags."""


def _word(name: str) -> property:
    """A register of sixteen bits."""

    def get(registers: WORDREGS) -> int:
        return registers.held[name]

    def put(registers: WORDREGS, value: object) -> None:
        registers.held[name] = whole(name, value) & 0xFFFF

    return property(get, put)


def _byte(name: str, word: str, shift: int) -> property:
    """One half of a register."""

    def get(registers: BYTEREGS) -> int:
        return registers.held[word] >> shift & 0xFF

    def put(registers: BYTEREGS, value: object) -> None:
        other = registers.held[word] & 0xFF00 >> shift
        registers.held[word] = other | (whole(name, value) & 0xFF) << shift

    return property(get, put)


class WORDREGS:
    """The registers as numbers of sixteen bits: those behind `REGS.x`."""

    __slots__ = ("held",)

    def __init__(self, held: dict[str, int]) -> None:
        self.held = held

    ax, bx, cx, dx = _word("ax"), _word("bx"), _word("cx"), _word("dx")
    si, di = _word("si"), _word("di")
    cflag, flags = _word("cflag"), _word("flags")


class BYTEREGS:
    """The same registers in halves: those behind `REGS.h`."""

    __slots__ = ("held",)

    def __init__(self, held: dict[str, int]) -> None:
        self.held = held

    al, ah = _byte("al", "ax", 0), _byte("ah", "ax", 8)
    bl, bh = _byte("bl", "bx", 0), _byte("bh", "bx", 8)
    cl, ch = _byte("cl", "cx", 0), _byte("ch", "cx", 8)
    dl, dh = _byte("dl", "dx", 0), _byte("dh", "dx", 8)


class REGS:
    """The registers of an interrupt: `r.x.ax` is sixteen bits, `r.h.ah` and `r.h.al` their halves.

    Both views are of the same registers, which begin as 0. What is too large loses its upper bits.
    """

    __slots__ = ("h", "x")

    def __init__(self) -> None:
        held = dict.fromkeys(("ax", "bx", "cx", "dx", "si", "di", "cflag", "flags"), 0)
        self.x, self.h = WORDREGS(held), BYTEREGS(held)

    def __copy__(self) -> REGS:
        found = REGS()
        found.take(self)
        return found

    def __repr__(self) -> str:
        return f"REGS({', '.join(f'{name}={value:04X}h' for name, value in self.x.held.items())})"

    def take(self, other: REGS) -> None:
        """Take over what other registers hold."""
        self.x.held.update(other.x.held)

    def flag(self, mask: int, on: bool) -> None:
        """Set a bit of the flags, or clear it."""
        self.x.flags = self.x.flags & ~mask | (mask if on else 0)
        self.x.cflag = self.x.flags & CARRY


@dataclass
class SREGS:
    """The segment registers: here each holds what C's address leads to, a list, text or function.

    The offset, in another register, does not count.
    """

    es: Any = None
    cs: Any = None
    ss: Any = None
    ds: Any = None


@dataclass
class REGPACK:
    """The registers of intr(): r_ds and r_es as in SREGS."""

    r_ax: int = 0
    r_bx: int = 0
    r_cx: int = 0
    r_dx: int = 0
    r_bp: int = 0
    r_si: int = 0
    r_di: int = 0
    r_ds: Any = None
    r_es: Any = None
    r_flags: int = 0


Function = Callable[[REGS, SREGS], None]
"""One function of an interrupt: takes what it is asked from the registers, and answers there."""


def nothing(r: REGS, s: SREGS) -> None:
    """What has no effect here."""


def numbers(name: str, thing: object, count: int) -> list[int]:
    """So many numbers that a segment register leads to."""
    found: Sequence[Any] = thing  # type: ignore[assignment]  # length() checks
    if thing is None or length(name, thing) < count:
        raise ValueError(f"{name} must lead to {count} numbers, not to {brief(thing)}")
    return [whole(name, found[place]) for place in range(count)]


def room(name: str, thing: object, count: int) -> bytearray:
    """A bytearray of so many bytes, or more, that a segment register leads to."""
    if not isinstance(thing, bytearray) or len(thing) < count:
        raise ValueError(f"{name} must lead to a bytearray({count}), not to {brief(thing)}")
    return thing
