"""conio.h, dos.h, bios.h, time.h, and the mouse driver by interrupt 33h."""

from __future__ import annotations

import time as _time
from typing import Any, NoReturn

from bgi import conio, current, dos
from bgi.turboc.runtime.binding import Function, string
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.scripted import Scripted
from bgi.turboc.runtime.session import ProgramEnd, Session

DIRECT = """
void clrscr(void); void clreol(void); void insline(void); void delline(void);
void gotoxy(int x, int y); int wherex(void); int wherey(void); void textcolor(int color);
void textbackground(int color); void textattr(int attribute); void textmode(int mode);
void window(int left, int top, int right, int bottom); void highvideo(void);
void lowvideo(void); void normvideo(void); void _setcursortype(int kind);
"""

TRACED = """
int getch(void); int kbhit(void); int bioskey(int command); void delay(unsigned ms);
void sleep(unsigned s); void sound(unsigned hertz); void nosound(void); long clock(void);
int inportb(int port); int inport(int port); void outportb(int port, int value);
void outport(int port, int value);
"""

OTHERS = """
int getche(void); int ungetch(int c); long time(long *to); long biostime(int command, long to);
void randomize(void); void gettime(time *to); void getdate(date *to); void exit(int status);
void abort(void); int atexit(void *function); int int86(int number, REGS *in, REGS *out);
int int86x(int number, REGS *in, REGS *out, SREGS *segments); int system(text command);
void Sleep(unsigned ms); void segread(SREGS *segments); void _exit(int status);
int intdos(REGS *in, REGS *out); double difftime(long a, long b); char *ctime(long *seconds);
"""

TYPES = {
    "time": "struct @ { unsigned char ti_min, ti_hour, ti_hund, ti_sec; };",
    "date": "struct @ { int da_year; char da_day, da_mon; };",
    "WORDREGS": "struct @ { unsigned ax, bx, cx, dx, si, di, cflag, flags; };",
    "BYTEREGS": "struct @ { unsigned char al, ah, bl, bh, cl, ch, dl, dh; };",
    "REGS": "struct @ { WORDREGS x; BYTEREGS h; };",
    "SREGS": "struct @ { unsigned es, cs, ss, ds; };",
}

TICKS = 18.2
"""Of the timer in a second."""

MIDNIGHT = 86_400


class PCLibrary:
    """The functions of TRACED and OTHERS for one program."""

    def __init__(self, program: Session) -> None:
        self._program = program
        self._pc = program.pc

    def _note(self, name: str, given: tuple[Any, ...] = (), answer: Any = ...) -> None:
        if self._program.trace:
            self._program.trace.call(name, given, answer)

    def getch(self) -> int:
        return self._pc.getch()

    def kbhit(self) -> int:
        return self._pc.kbhit()

    def bioskey(self, command: int) -> int:
        return self._pc.bioskey(command)

    def getche(self) -> int:
        code = self._pc.getch()
        self._note("getche", (), code)
        self._program.put(bytes([code]))
        return code

    def ungetch(self, code: int) -> int:
        self._pc.ungetch(code)
        self._note("ungetch", (code,))
        return code

    # Time

    def delay(self, milliseconds: int) -> None:
        self._pc.pass_time(milliseconds & 0xFFFF)

    Sleep = delay

    def sleep(self, seconds: int) -> None:
        self._pc.pass_time((seconds & 0xFFFF) * 1000)

    def sound(self, hertz: int) -> None:
        if current.is_open():
            dos.sound(hertz & 0xFFFF)

    def nosound(self) -> None:
        dos.nosound()

    def clock(self) -> int:
        return self._pc.milliseconds() * 182 // 10000

    def time(self, to: Any) -> int:
        now = int(self._pc.now())
        self._note("time")
        if to is not None:
            to.memory[to.at] = now
        return now

    def difftime(self, later: int, earlier: int) -> float:
        return float(later - earlier)

    def ctime(self, seconds: Pointer) -> Pointer:
        return string(_time.asctime(_time.gmtime(seconds.memory[seconds.at])) + "\n")

    def biostime(self, command: int, to: int) -> int:
        now = round(self._pc.now() % MIDNIGHT * 1000) * 182 // 10000
        self._note("biostime", (command,))
        return now

    def randomize(self) -> None:
        seed = self._pc.seed()
        if seed >= 0:
            dos.srand(seed & 0xFFFF)

    def gettime(self, to: Pointer) -> None:
        now, when = self._moment()
        values = when.tm_hour, when.tm_min, when.tm_sec, round(now % 1 * 1000) // 10
        for name, value in zip(("ti_hour", "ti_min", "ti_sec", "ti_hund"), values, strict=True):
            setattr(to.memory[to.at], name, value)
        self._note("gettime", (), values)

    def getdate(self, to: Pointer) -> None:
        when = self._moment()[1]
        values = when.tm_year, when.tm_mon, when.tm_mday
        for name, value in zip(("da_year", "da_mon", "da_day"), values, strict=True):
            setattr(to.memory[to.at], name, value)
        self._note("getdate", (), values)

    def _moment(self) -> tuple[float, _time.struct_time]:
        now = self._pc.now()
        scripted = isinstance(self._pc, Scripted)
        return now, (_time.gmtime if scripted else _time.localtime)(now)

    # Ports and interrupts

    def inportb(self, port: int) -> int:
        return self._pc.port(port & 0xFFFF)

    def inport(self, port: int) -> int:
        return 0

    def outportb(self, port: int, value: int) -> None:
        """Nothing hears it."""

    outport = outportb

    def int86(self, number: int, given: Pointer, out: Pointer) -> int:
        """An interrupt: those of the mouse and the keyboard answer."""
        before, after = given.memory[given.at].x, out.memory[out.at].x
        ax, bx, cx, dx = before.ax, before.bx, before.cx, before.dx
        result = self._interrupt(number & 0xFF, ax, bx, cx, dx)
        for name in ("si", "di", "cflag", "flags"):
            setattr(after, name, getattr(before, name))
        for name, value in zip(("ax", "bx", "cx", "dx"), result, strict=True):
            setattr(after, name, value & 0xFFFF)
        self._note("int86", (number, ax, bx, cx, dx), tuple(result))
        return (result[0] & 0xFFFF ^ 0x8000) - 0x8000

    def _interrupt(self, number: int, ax: int, bx: int, cx: int, dx: int) -> list[int]:
        if number == 0x33:
            return self._mouse(ax, bx, cx, dx)
        if number == 0x16 and ax >> 8 & 0xF < 2:
            key = self._pc.bioskey(ax >> 8 & 0xF)
            return [key or ax, bx, cx, dx]
        if number == 0x1A and ax >> 8 == 0:
            ticks = round(self._pc.now() % MIDNIGHT * 1000) * 182 // 10000
            return [ax & 0xFF00, bx, ticks >> 16, ticks & 0xFFFF]
        return [ax, bx, cx, dx]

    def _mouse(self, ax: int, bx: int, cx: int, dx: int) -> list[int]:
        if ax == 0:
            return [0xFFFF, 2, cx, dx]
        if ax == 3:
            return [ax, *self._pc.mouse()]
        if ax in (5, 6):
            buttons, x, y = self._pc.mouse()
            return [buttons, int(buttons == (2 if bx else 1)), x, y]
        return [ax, bx, 3, 2] if ax == 0xB else [ax, bx, cx, dx]

    def int86x(self, number: int, given: Pointer, out: Pointer, segments: Pointer) -> int:
        return self.int86(number, given, out)

    def intdos(self, given: Pointer, out: Pointer) -> int:
        return self.int86(0x21, given, out)

    def segread(self, segments: Pointer) -> None:
        """There are none."""

    # Processes

    def system(self, command: bytes) -> int:
        """No other program is started."""
        self._note("system", (command,))
        return 0

    def exit(self, status: int) -> NoReturn:
        raise ProgramEnd("exit", status & 0xFF)

    _exit = exit

    def abort(self) -> NoReturn:
        raise ProgramEnd("abort", 3)

    def atexit(self, function: Any) -> int:
        self._program.at_exit.append(function)
        return 0


def direct(name: str) -> Function:
    """A function of conio.h."""
    return getattr(conio, name)  # type: ignore[no-any-return]


__all__ = ["DIRECT", "OTHERS", "TRACED", "TYPES", "PCLibrary", "direct"]
