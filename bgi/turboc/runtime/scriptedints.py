"""Interrupts as a scripted PC answers them; others leave the registers as they are."""

from __future__ import annotations

import time as _time
from collections.abc import Callable

from bgi import conio
from bgi.interrupts.registers import REGS, ZERO
from bgi.turboc.runtime.scripted import Scripted

MIDNIGHT = 86_400
Print = Callable[[bytes], None]


def _mouse(pc: Scripted, r: REGS, show: Print) -> None:
    asked = r.x.ax
    if asked == 0:
        r.x.ax, r.x.bx = 0xFFFF, 2
    elif asked == 3:
        r.x.bx, r.x.cx, r.x.dx = pc.mouse()
    elif asked in (5, 6):
        buttons, r.x.cx, r.x.dx = pc.mouse()
        r.x.ax, r.x.bx = buttons, int(buttons == (2 if r.x.bx else 1))
    elif asked == 0xB:
        r.x.cx, r.x.dx = 3, 2


def _keyboard(pc: Scripted, r: REGS, show: Print) -> None:
    asked = r.h.ah & 0xF
    if asked == 0:
        r.x.ax = pc.bioskey(0)
    elif asked == 1:
        key = pc.bioskey(1)
        r.flag(ZERO, not key)
        r.x.ax = key or r.x.ax
    elif asked == 2:
        r.h.al = 0


def _clock(pc: Scripted, r: REGS, show: Print) -> None:
    if r.h.ah == 0:
        ticks = ticks_of_day(pc.now())
        r.x.cx, r.x.dx, r.h.al = ticks >> 16, ticks, 0


def ticks_of_day(now: float) -> int:
    """The timer's ticks since midnight."""
    return round(now % MIDNIGHT * 1000) * 182 // 10000


def _screen(pc: Scripted, r: REGS, show: Print) -> None:
    if r.h.ah == 0xF:
        r.h.al, r.h.ah, r.h.bh = 0x12, 80, 0
    elif r.h.ah == 3:
        r.h.dh, r.h.dl = conio.wherey() - 1, conio.wherex() - 1


def _dos(pc: Scripted, r: REGS, show: Print) -> None:
    asked = r.h.ah
    if asked in (1, 7, 8):
        r.h.al = pc.getch()
    elif asked == 0xB:
        r.h.al = 0xFF if pc.kbhit() else 0
    elif asked in (2, 6):
        show(bytes([r.h.dl]))
    elif asked == 0x30:
        r.x.ax = 5
    elif asked in (0x2A, 0x2C):
        now = pc.now()
        when = _time.gmtime(now)
        if asked == 0x2A:
            r.x.cx, r.h.dh, r.h.dl = when.tm_year, when.tm_mon, when.tm_mday
            r.h.al = (when.tm_wday + 1) % 7
        else:
            r.h.ch, r.h.cl, r.h.dh = when.tm_hour, when.tm_min, when.tm_sec
            r.h.dl = round(now % 1 * 1000) // 10


_INTERRUPTS = {0x33: _mouse, 0x16: _keyboard, 0x1A: _clock, 0x10: _screen, 0x21: _dos}


def scripted_interrupt(pc: Scripted, number: int, r: REGS, show: Print) -> None:
    """Do what an interrupt does."""
    if number in _INTERRUPTS:
        _INTERRUPTS[number](pc, r, show)
