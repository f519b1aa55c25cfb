"""Time, sound and the PC's interrupts: dos.h, and clock() of time.h.

`from bgi import *` does not bring these names, since Python has a `time` of its own: write `from
bgi import dos`, and `dos.gettime()`. `from bgi.dos import *` brings what dos.h has, but for its
structure `time`. Programs may also find here by name what belongs to other headers, as in `from
bgi.dos import random, bioskey`: see `bgi.stdlib` and `bgi.bios`.
"""

from __future__ import annotations

import time as _time
from dataclasses import dataclass

from bgi import current
from bgi.bios import bioskey as bioskey
from bgi.bios import biostime as biostime
from bgi.errors import BGIError
from bgi.interrupts.registers import REGPACK, REGS, SREGS
from bgi.kernel.arguments import Number, check_kind, real, whole
from bgi.monitor import moment
from bgi.monitor.script import LONGEST
from bgi.stdlib import RAND_MAX as RAND_MAX
from bgi.stdlib import rand as rand
from bgi.stdlib import random as random
from bgi.stdlib import randomize as randomize
from bgi.stdlib import srand as srand

# fmt: off
__all__ = [
    "REGPACK", "REGS", "SREGS", "date", "delay", "getdate", "gettime", "int86", "int86x",
    "intdos", "intdosx", "intr", "nosound", "setdate", "settime", "sleep", "sound",
]
# fmt: on

CLK_TCK = CLOCKS_PER_SEC = moment.TICKS
"""What clock() counts in a second: the PC's timer ticks."""


@dataclass
class time:
    """A time of day, in Borland's order of fields; ti_hund is hundredths of a second."""

    ti_min: int
    ti_hour: int
    ti_hund: int
    ti_sec: int


@dataclass
class date:
    """A day; da_year is the full year."""

    da_year: int
    da_day: int
    da_mon: int


# Time


def delay(milliseconds: Number) -> None:
    """Wait a number of milliseconds; the window stays alive meanwhile.

    Args:
        milliseconds: 0 to 2147483647, which is 24 days.

    Without a window the time is counted, not waited for, so that a program under test runs at full
    speed. Before initgraph it simply waits. Raises WindowClosed if the window is closed meanwhile,
    TypeError or ValueError for anything but such a number. Source: dos.h.
    """
    _wait("milliseconds", milliseconds, 1)


def Sleep(milliseconds: Number) -> None:
    """Wait a number of milliseconds, as delay() does: Windows' name for it. Source: windows.h."""
    _wait("milliseconds", milliseconds, 1)


def sleep(seconds: Number) -> None:
    """Wait a number of seconds, as delay() waits milliseconds. Source: dos.h."""
    _wait("seconds", seconds, 1000)


def _wait(name: str, time: Number, unit: int) -> None:
    """Wait so many times `unit` milliseconds."""
    wait = real(name, time) * unit
    if not 0 <= wait <= LONGEST:
        raise ValueError(f"{name} must be a finite number of 0 or more, at most {LONGEST // unit}")
    if current.is_open():
        current.screen.monitor.sleep(wait)
    else:
        _time.sleep(wait / 1000)


def gettime() -> time:
    """Return the time of day. Source: dos.h."""
    now = current.now()
    clock = moment.local(now)
    return time(clock.tm_min, clock.tm_hour, int(now % 1 * 100), clock.tm_sec)


def getdate() -> date:
    """Return today's date. Source: dos.h."""
    day = moment.local(current.now())
    return date(day.tm_year, day.tm_mday, day.tm_mon)


def settime(timep: time) -> None:
    """Refuse to set the clock: raises BGIError, for it is the whole computer's. Source: dos.h."""
    raise BGIError("settime(): the clock can be read, not set: it is the whole computer's")


def setdate(datep: date) -> None:
    """Refuse to set the date: raises BGIError, for it is the whole computer's. Source: dos.h."""
    raise BGIError("setdate(): the date can be read, not set: it is the whole computer's")


def clock() -> int:
    """Return the timer's ticks, 18.2 a second, since the program began. Source: time.h."""
    return int((current.now() - moment.began()) * CLK_TCK)


# Sound


MAX_FREQUENCY = 0xFFFF
"""C's largest unsigned number: nobody hears what is above."""


def sound(frequency: Number) -> None:
    """Sound the speaker at a frequency in hertz, until nosound(); returns at once.

    Another pitch follows without a gap. 0 is silence, and so is what nobody can hear. Where there
    is no sound card or no window nothing is heard. Raises BGIError before initgraph, for it is the
    window that plays. Source: dos.h.
    """
    current.screen.monitor.sound(min(max(whole("frequency", frequency), 0), MAX_FREQUENCY))


def nosound() -> None:
    """Turn the speaker off. Source: dos.h."""
    if current.is_open():
        current.screen.monitor.sound(0)


# Interrupts


def int86(intno: Number, inregs: REGS, outregs: REGS | None = None) -> int:
    """Call the BIOS, DOS or the mouse driver: a software interrupt.

    Args:
        intno: 0x10 the screen, 0x16 the keyboard, 0x1A the clock, 0x21 DOS, 0x33 the mouse.
        inregs: what is asked: the function's number in `inregs.h.ah`, or `inregs.x.ax` for the
            mouse, and what it needs in the others.
        outregs: where the answer goes; left out, it is `inregs`.

    Returns AX. Before anything is open, an interrupt that needs a screen opens one of text.
    ValueError for an interrupt or a function that is not there; otherwise raises what the call does
    that stands behind it. Source: dos.h.
    """
    return int86x(intno, inregs, outregs, SREGS())


def int86x(intno: Number, inregs: REGS, outregs: REGS | None, segregs: SREGS) -> int:
    """Call an interrupt that takes an address, too.

    Args:
        intno, inregs, outregs: as for int86().
        segregs: in `es` or `ds` what C's address leads to: a text, a list of numbers, a function.
            The offset, in another register, does not count.

    Source: dos.h.
    """
    from bgi.interrupts.dispatch import interrupt  # late, as most programs need it never

    answer = inregs if outregs is None else outregs
    check_kind("inregs", inregs, REGS)
    check_kind("outregs", answer, REGS)
    check_kind("segregs", segregs, SREGS)
    answer.take(inregs)
    interrupt(whole("intno", intno), answer, segregs)
    return int(answer.x.ax)


def intdos(inregs: REGS, outregs: REGS | None = None) -> int:
    """Call DOS: int86() with interrupt 21h. Source: dos.h."""
    return int86(_DOS, inregs, outregs)


def intdosx(inregs: REGS, outregs: REGS | None, segregs: SREGS) -> int:
    """Call DOS: int86x() with interrupt 21h. Source: dos.h."""
    return int86x(_DOS, inregs, outregs, segregs)


def intr(intno: Number, preg: REGPACK) -> None:
    """Call an interrupt, with all registers in one structure, where the answer goes, too.

    Args:
        intno: as for int86().
        preg: the registers, r_ax to r_flags.

    Source: dos.h.
    """
    check_kind("preg", preg, REGPACK)
    registers = REGS()
    for name in _PACKED:
        setattr(registers.x, name, getattr(preg, f"r_{name}"))
    int86x(intno, registers, registers, SREGS(es=preg.r_es, ds=preg.r_ds))
    for name in _PACKED:
        setattr(preg, f"r_{name}", getattr(registers.x, name))


_DOS = 0x21
_PACKED = "ax", "bx", "cx", "dx", "si", "di", "flags"
