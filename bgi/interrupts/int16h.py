"""Interrupt 16h, the BIOS's keyboard."""

from bgi.bios import bioskey
from bgi.interrupts.registers import REGS, SREGS, ZERO, Function


def wait_for_key(r: REGS, s: SREGS) -> None:
    """Returns AX: the next key's scan code and character."""
    r.x.ax = bioskey(0)


def look_for_key(r: REGS, s: SREGS) -> None:
    """Returns AX: the key that waits, which stays; the zero flag says that there is none."""
    r.x.ax = key = bioskey(1)
    r.flag(ZERO, key == 0)


def shift_keys(r: REGS, s: SREGS) -> None:
    """Returns AL: the state of Shift, Ctrl, Alt and their like."""
    r.h.al = bioskey(2)


FUNCTIONS: dict[int, Function] = {
    0x00: wait_for_key,
    0x01: look_for_key,
    0x02: shift_keys,
    # The same on a keyboard with F11 and F12.
    0x10: wait_for_key,
    0x11: look_for_key,
    0x12: shift_keys,
}
