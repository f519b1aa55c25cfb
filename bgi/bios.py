"""The BIOS's keyboard and its clock: bios.h."""

from __future__ import annotations

from bgi import current
from bgi.errors import brief
from bgi.kernel.arguments import Number, whole
from bgi.monitor import moment
from bgi.monitor.keycodes import bios_code

__all__ = ["bioskey", "biostime"]


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


def biostime(cmd: Number, newtime: Number = 0) -> int:
    """Return the timer's ticks, 18.2 a second, since midnight.

    Args:
        cmd: 0, which reads the clock; nothing else is allowed.
        newtime: what C's function would set the clock to; any number will do.

    ValueError for another command. Source: bios.h.
    """
    if whole("cmd", cmd) != 0:
        raise ValueError(f"cmd must be 0: the clock can be read, not set; got {brief(cmd)}")
    whole("newtime", newtime)
    now = current.now()
    day = moment.local(now)
    return int(((day.tm_hour * 60 + day.tm_min) * 60 + day.tm_sec + now % 1) * moment.TICKS)
