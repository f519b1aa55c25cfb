"""Interrupt 21h, DOS: the keyboard and the screen, the clock, and the end of the program."""

from __future__ import annotations

from typing import NoReturn

from bgi import current
from bgi.console.lineinput import read_line
from bgi.errors import brief
from bgi.fonts.codepage import encode
from bgi.interrupts.registers import REGS, SREGS, ZERO, Function, room
from bgi.monitor import Monitor, moment

CTRL_C = 3
ASKS = 0xFF
"""What function 6 has in DL to read in place of writing."""


def _monitor() -> Monitor:
    return current.screen.monitor


# Reading


def _next_key(stops: bool) -> int:
    """The next byte from the keyboard; Ctrl-C may stop the program."""
    monitor = _monitor()
    half = monitor.keys.half()
    code = monitor.read_key()
    if stops and code == CTRL_C and not half:
        raise KeyboardInterrupt
    return code


def read_and_show(r: REGS, s: SREGS) -> None:
    """Returns AL: the next key, which is shown; 0 for an arrow and its like, then its scan code."""
    r.h.al = code = _next_key(stops=True)
    _show(code)


def read_raw(r: REGS, s: SREGS) -> None:
    """Returns AL: the next key, unseen. Ctrl-C is a key like another."""
    r.h.al = _next_key(stops=False)


def read_unseen(r: REGS, s: SREGS) -> None:
    """Returns AL: the next key, unseen."""
    r.h.al = _next_key(stops=True)


def read_text(r: REGS, s: SREGS) -> None:
    """DS: a bytearray, whose first number says how much room there is, with the Enter.

    The second one becomes how much was typed; that follows, and the Enter.
    """
    most = room("ds", s.ds, 1)[0]
    buffer = room("ds", s.ds, most + 2)
    if most == 0:
        return
    crt = current.crt or current.console()
    typed = read_line(_monitor().read_keystroke, crt.teletype, crt.erase, most - 1)
    crt.teletype(b"\r")
    buffer[1 : len(typed) + 3] = bytes([len(typed), *typed, 13])


def key_waits(r: REGS, s: SREGS) -> None:
    """Returns AL: FFh if a key waits, else 0."""
    r.h.al = 0xFF if _monitor().key_waiting() else 0


def forget_keys(r: REGS, s: SREGS) -> None:
    """AL: another function, 1, 6, 7, 8 or 0Ah, before which keys that wait are forgotten."""
    monitor = _monitor()
    while monitor.key_waiting():
        monitor.read_key()
    if r.h.al in READERS:
        READERS[r.h.al](r, s)


# Writing


def _show(code: int) -> None:
    """Write a character; a tab is blanks, line feed goes down only."""
    crt = current.crt or current.console()
    codes = bytes([code])
    if codes == b"\t":
        crt.print(codes)
    else:
        crt.teletype(codes)


def write_character(r: REGS, s: SREGS) -> None:
    """DL: the character."""
    _show(r.h.dl)
    r.h.al = r.h.dl


def read_or_write(r: REGS, s: SREGS) -> None:
    """DL: a character to write. FFh reads one into AL; the zero flag says that none waits."""
    if r.h.dl != ASKS:
        (current.crt or current.console()).teletype(bytes([r.h.dl]))
        r.h.al = r.h.dl
        return
    waits = _monitor().key_waiting()
    r.flag(ZERO, not waits)
    r.h.al = _next_key(stops=False) if waits else 0


def write_text(r: REGS, s: SREGS) -> None:
    """DS: the text, up to a dollar sign."""
    if not isinstance(s.ds, (str, bytes, bytearray)):
        raise ValueError(f"ds must lead to a text, not to {brief(s.ds)}")
    text = s.ds if isinstance(s.ds, str) else bytes(s.ds)
    for code in encode(text).partition(b"$")[0]:
        _show(code)
    r.h.al = ord("$")


# The clock, and the end


def get_date(r: REGS, s: SREGS) -> None:
    """Returns CX, DH, DL: year, month and day; AL: the day of the week, 0 for Sunday."""
    today = moment.local(current.now())
    r.x.cx, r.h.dh, r.h.dl = today.tm_year, today.tm_mon, today.tm_mday
    r.h.al = (today.tm_wday + 1) % 7


def get_time(r: REGS, s: SREGS) -> None:
    """Returns CH, CL, DH, DL: hours, minutes, seconds and hundredths."""
    now = current.now()
    clock = moment.local(now)
    r.h.ch, r.h.cl, r.h.dh, r.h.dl = clock.tm_hour, clock.tm_min, clock.tm_sec, int(now % 1 * 100)


def get_version(r: REGS, s: SREGS) -> None:
    """Returns AL, AH: 5 and 0, the version of DOS."""
    r.x.ax = 5


def end(r: REGS, s: SREGS) -> NoReturn:
    """AL: the exit status. Raises SystemExit, as exit() does."""
    raise SystemExit(r.h.al)


def abort(r: REGS, s: SREGS) -> NoReturn:
    """End with status 0."""
    raise SystemExit(0)


READERS: dict[int, Function] = {
    0x01: read_and_show,
    0x06: read_or_write,
    0x07: read_raw,
    0x08: read_unseen,
    0x0A: read_text,
}

FUNCTIONS: dict[int, Function] = {
    0x00: abort,
    **READERS,
    0x02: write_character,
    0x09: write_text,
    0x0B: key_waits,
    0x0C: forget_keys,
    0x2A: get_date,
    0x2C: get_time,
    0x30: get_version,
    0x4C: end,
}
