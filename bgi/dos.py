"""Time, sound, chance and the BIOS keyboard: dos.h, and parts of time.h, stdlib.h and bios.h.

`from bgi import *` does not bring these names, since Python has a `random` and a `time` of its own:
write `from bgi import dos`, and `dos.random(6)`. `from bgi.dos import *` brings what dos.h has, but
for its structure `time`: a program's own `time` and `random` stay what they are. What another
header has is imported by name, as in `from bgi.dos import random, randomize`.
"""

from __future__ import annotations

import time as _time
from dataclasses import dataclass

from bgi import current
from bgi.errors import brief
from bgi.kernel.arguments import Number, real, whole
from bgi.kernel.state import KERNEL
from bgi.monitor import moment
from bgi.monitor.keycodes import bios_code
from bgi.monitor.script import LONGEST

__all__ = ["date", "delay", "getdate", "gettime", "nosound", "sleep", "sound"]

CLK_TCK = CLOCKS_PER_SEC = 18.2
"""What clock() counts in a second: the PC's timer ticks."""

RAND_MAX = 32767
"""The largest number that rand() returns."""


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
    now = _now()
    clock = _local(now)
    return time(clock.tm_min, clock.tm_hour, int(now % 1 * 100), clock.tm_sec)


def getdate() -> date:
    """Return today's date. Source: dos.h."""
    day = _local(_now())
    return date(day.tm_year, day.tm_mday, day.tm_mon)


def clock() -> int:
    """Return the timer's ticks, 18.2 a second, since the program began. Source: time.h."""
    return int((_now() - moment.began()) * CLK_TCK)


def biostime(cmd: Number, newtime: Number = 0) -> int:
    """Return the timer's ticks since midnight.

    Args:
        cmd: 0, which reads the clock; nothing else is allowed.
        newtime: what C's function would set the clock to; any number will do.

    ValueError for another command. Source: bios.h.
    """
    if whole("cmd", cmd) != 0:
        raise ValueError(f"cmd must be 0: the clock can be read, not set; got {brief(cmd)}")
    now = _now()
    day = _local(now)
    return int(((day.tm_hour * 60 + day.tm_min) * 60 + day.tm_sec + now % 1) * CLK_TCK)


def _now() -> float:
    """Seconds since 1970, by the monitor's clock where there is one: without a window it counts."""
    return current.screen.monitor.time() if current.is_open() else moment.now()


def _local(now: float) -> _time.struct_time:
    """A moment as the clock on the wall shows it."""
    try:
        return _time.localtime(now)
    except (OSError, OverflowError, ValueError):
        raise ValueError("the clock does not go so far: the program has waited too long") from None


# Sound


def sound(frequency: Number) -> None:
    """Sound the speaker at a frequency in hertz, until nosound(); returns at once.

    Another pitch follows without a gap. 0 is silence, and so is what nobody can hear. Where there
    is no sound card or no window nothing is heard. Raises BGIError before initgraph, for it is the
    window that plays. Source: dos.h.
    """
    current.screen.monitor.sound(max(whole("frequency", frequency), 0))


def nosound() -> None:
    """Turn the speaker off. Source: dos.h."""
    if current.is_open():
        current.screen.monitor.sound(0)


# Chance: Borland's linear congruential generator, which multiplies and adds; its upper bits count

_MULTIPLIER = 0x015A4E35


def srand(seed: Number) -> None:
    """Make rand() begin anew; the same seed (0 to 65535) always gives the same numbers.

    Source: stdlib.h.
    """
    KERNEL.seed = whole("seed", seed) & 0xFFFF


def rand() -> int:
    """Return a random whole number from 0 to RAND_MAX (32767): 346, 130, 10982, ...

    Without srand() or randomize() always the same, number for number Borland's. Source: stdlib.h.
    """
    KERNEL.seed = (KERNEL.seed * _MULTIPLIER + 1) & 0xFFFFFFFF
    return KERNEL.seed >> 16 & RAND_MAX


def random(num: Number) -> int:
    """Return a random whole number from 0 to num - 1, as Turbo C++ 3 computed it.

    Args:
        num: how many numbers there are to choose from, 1 to 32767; of none, 0, comes a 0.

    ValueError for a number below 0. Source: stdlib.h.
    """
    count = whole("num", num)
    if count < 0:
        raise ValueError(f"num must be 0 or more, not {brief(count)}")
    return rand() * count >> 15


def randomize() -> None:
    """Make rand() and random() different in every run, by the clock. Source: stdlib.h."""
    from calendar import timegm  # late, as most programs need it never

    srand(timegm(_local(_now())))


# The keyboard by the BIOS


def bioskey(cmd: Number) -> int:
    """Ask the BIOS for a key, or for the state of the Shift keys.

    Args:
        cmd: 0 waits for a key and takes it; 1 looks for one, which stays; 2 asks for the state.

    For a key the answer is its scan code times 256 plus its character (0 for an arrow and its
    like): 0x4800 Up, 0x5000 Down, 0x4B00 Left, 0x4D00 Right, 0x011B Esc; 0 if there is none to look
    at. For the state it is a sum of 1 right Shift, 2 left Shift, 4 Ctrl, 8 Alt, 0x20 NumLock and
    0x40 CapsLock. ValueError for another command; otherwise raises what getch() does. Source:
    bios.h.
    """
    command = whole("cmd", cmd)
    monitor = current.screen.monitor
    if command == 0:
        return bios_code(monitor.read_keystroke())
    if command == 1:
        keystroke = monitor.keys.peek() if monitor.key_waiting() else None
        return bios_code(keystroke) if keystroke else 0
    if command == 2:
        return monitor.keys.shifts
    raise ValueError(f"cmd must be 0, 1 or 2, not {brief(command)}")
