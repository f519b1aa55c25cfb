"""Which interrupt has which functions."""

from collections.abc import Callable
from typing import NamedTuple

from bgi.interrupts import int1ah, int10h, int16h, int21h, int33h
from bgi.interrupts.registers import REGS, SREGS, Function


class Interrupt(NamedTuple):
    """The functions of an interrupt by number, and the number in some registers."""

    asked: Callable[[REGS], int]
    functions: dict[int, Function]


INTERRUPTS = {
    0x10: Interrupt(lambda r: r.h.ah, int10h.FUNCTIONS),
    0x16: Interrupt(lambda r: r.h.ah, int16h.FUNCTIONS),
    0x1A: Interrupt(lambda r: r.h.ah, int1ah.FUNCTIONS),
    0x21: Interrupt(lambda r: r.h.ah, int21h.FUNCTIONS),
    0x33: Interrupt(lambda r: r.x.ax, int33h.FUNCTIONS),
}


def interrupt(number: int, r: REGS, s: SREGS) -> None:
    """Do what an interrupt does; ValueError for one, or a function, that is not there."""
    if number not in INTERRUPTS:
        there = ", ".join(f"{known:02X}h" for known in INTERRUPTS)
        raise ValueError(f"intno {number & 0xFFFF:02X}h is not there, only {there}")
    asked, functions = INTERRUPTS[number]
    if asked(r) not in functions:
        there = ", ".join(f"{known:02X}h" for known in functions)
        raise ValueError(
            f"interrupt {number:02X}h has no function {asked(r):02X}h here, only {there}"
        )
    functions[asked(r)](r, s)
