"""Interrupt 1Ah, the BIOS's clock."""

from bgi import current
from bgi.bios import biostime
from bgi.interrupts.registers import CARRY, REGS, SREGS, Function
from bgi.monitor import moment


def ticks(r: REGS, s: SREGS) -> None:
    """Returns CX, DX: the timer's ticks since midnight, 18.2 a second, upper and lower half."""
    found = biostime(0)
    r.h.al, r.x.cx, r.x.dx = 0, found >> 16, found


def time_of_day(r: REGS, s: SREGS) -> None:
    """Returns CH, CL, DH: hours, minutes and seconds, two decimal digits each."""
    now = moment.local(current.now())
    r.h.ch, r.h.cl, r.h.dh, r.h.dl = bcd(now.tm_hour), bcd(now.tm_min), bcd(now.tm_sec), 0
    r.flag(CARRY, False)


def date(r: REGS, s: SREGS) -> None:
    """Returns CH, CL, DH, DL: century, year, month and day, two decimal digits each."""
    today = moment.local(current.now())
    r.h.ch, r.h.cl = bcd(today.tm_year // 100), bcd(today.tm_year % 100)
    r.h.dh, r.h.dl = bcd(today.tm_mon), bcd(today.tm_mday)
    r.flag(CARRY, False)


def bcd(number: int) -> int:
    """A number of two digits, a digit in four bits: 59 is 59h."""
    return number // 10 % 10 << 4 | number % 10


FUNCTIONS: dict[int, Function] = {0x00: ticks, 0x02: time_of_day, 0x04: date}
