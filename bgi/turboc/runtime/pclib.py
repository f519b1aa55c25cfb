"""conio.h, the keyboard and the speaker, and what begins and ends programs."""

from __future__ import annotations

import sys
from typing import Any, NoReturn

from bgi import conio, current, dos
from bgi.turboc.runtime.binding import Function, characters
from bgi.turboc.runtime.limits import numbers
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.session import ProgramEnd, Session

DIRECT = """
void clrscr(void); void clreol(void); void insline(void); void delline(void);
void gotoxy(int x, int y); int wherex(void); int wherey(void); void textcolor(int color);
void textbackground(int color); void textattr(int attribute); void textmode(int mode);
void window(int left, int top, int right, int bottom); void highvideo(void);
void lowvideo(void); void normvideo(void); void _setcursortype(int kind);
"""

TRACED = """
int getch(void); int kbhit(void); int bioskey(int command); void sound(unsigned hertz);
void nosound(void);
"""

OTHERS = """
int getche(void); int ungetch(int c); unsigned _bios_keybrd(unsigned command);
int movetext(int left, int top, int right, int bottom, int x, int y);
int gettext(int left, int top, int right, int bottom, data to);
int puttext(int left, int top, int right, int bottom, data from); void gettextinfo(text_info *to);
int biosequip(void); int biosmemory(void); unsigned _bios_equiplist(void);
unsigned _bios_memsize(void); int biosdisk(int cmd, int d, int h, int t, int s, int n, void *b);
int biosprint(int cmd, int byte, int port); int bioscom(int cmd, char byte, int port);
void exit(int status); void abort(void); void _exit(int status); int atexit(void *function);
void _cexit(void); void _c_exit(void); int getpid(void); int system(text command);
int spawnl(int mode, text path, ...); int spawnlp(int mode, text path, ...);
int spawnle(int mode, text path, ...); int spawnv(int mode, text path, ...);
int spawnvp(int mode, text path, ...); int execl(text path, ...); int execlp(text path, ...);
int execle(text path, ...); int execv(text path, ...); int execvp(text path, ...);
int execlpe(text path, ...); int execve(text path, ...); int execvpe(text path, ...);
int spawnlpe(int mode, text path, ...); int spawnve(int mode, text path, ...);
int spawnvpe(int mode, text path, ...); int _bios_disk(int command, void *info);
int _bios_printer(int command, int port, int byte); int _bios_serialcom(int c, int port, char b);
int _assertion(text condition, text file, int line); void *signal(int number, void *handler);
void *set_new_handler(void *handler); char *setlocale(int kind, text name);
"""

TYPES = {
    "text_info": """struct @ { unsigned char winleft, wintop, winright, winbottom, attribute,
        normattr, currmode, screenheight, screenwidth, curx, cury; };""",
}

NAMES = {
    **{"directvideo": "int @", "_wscroll": "int @", "_argc": "int @", "_argv": "char **@"},
    **{"environ": "char **@", "_osmajor": "unsigned char @", "_osminor": "unsigned char @"},
    **{"_version": "unsigned @", "_psp": "unsigned @", "_stklen": "unsigned @"},
    **{"_heaplen": "unsigned @", "_fmode": "int @", "sys_nerr": "int @"},
}
"""Variables of the headers."""

VALUES: dict[str, Any] = {
    **{"directvideo": 1, "_wscroll": 1, "_argc": 1, "_argv": Pointer([None]), "_osmajor": 5},
    **{"environ": Pointer([None]), "_osminor": 0, "_version": 5, "_psp": 0, "_stklen": 4096},
    **{"_heaplen": 0, "_fmode": 0x4000, "sys_nerr": 0},
}
"""What is in them."""

_BIOS = """
_DISK_RESET 0 _DISK_STATUS 1 _DISK_READ 2 _DISK_WRITE 3 _DISK_VERIFY 4 _DISK_FORMAT 5
_PRINTER_WRITE 0 _PRINTER_INIT 1 _PRINTER_STATUS 2 _COM_INIT 0 _COM_SEND 1 _COM_RECEIVE 2
_COM_STATUS 3 _COM_CHR7 2 _COM_CHR8 3 _COM_STOP1 0 _COM_STOP2 4 _COM_NOPARITY 0
_COM_EVENPARITY 24 _COM_ODDPARITY 8 _COM_1200 128 _COM_2400 160 _COM_4800 192 _COM_9600 224
"""

CONSTANTS = {
    **numbers(_BIOS),
    **{"SIGUSR1": 16, "SIGUSR2": 17, "SIGUSR3": 20, "P_NOWAITO": 3, "LC_TIME": 5},
    **{"P_WAIT": 0, "P_NOWAIT": 1, "P_OVERLAY": 2, "SIGBREAK": 21},
    **{"SIGABRT": 22, "SIGFPE": 8, "SIGILL": 4, "SIGINT": 2, "SIGSEGV": 11, "SIGTERM": 15},
    **{"_KEYBRD_READ": 0, "_KEYBRD_READY": 1, "_KEYBRD_SHIFTSTATUS": 2},
    **{"_NKEYBRD_READ": 0x10, "_NKEYBRD_READY": 0x11, "_NKEYBRD_SHIFTSTATUS": 0x12},
    **{"LC_ALL": 0, "LC_COLLATE": 1, "LC_CTYPE": 2, "LC_MONETARY": 3, "LC_NUMERIC": 4},
}

_EQUIPMENT, _KILOBYTES = 0x4221, 640
_ENDS = {22: "abort", 8: "divide", 4: "crash", 11: "crash"}
"""How a signal that nobody handles ends a program."""


class PCLibrary:
    """The functions of TRACED and OTHERS for one program."""

    def __init__(self, program: Session) -> None:
        self._program = program
        self._pc = program.pc
        self._handlers: dict[int, Any] = {}

    def _note(self, name: str, given: tuple[Any, ...] = (), answer: Any = ...) -> None:
        if self._program.trace:
            self._program.trace.call(name, given, answer)

    # The keyboard

    def getch(self) -> int:
        return self._pc.getch()

    def kbhit(self) -> int:
        return self._pc.kbhit()

    def bioskey(self, command: int) -> int:
        return self._pc.bioskey(command)

    def _bios_keybrd(self, command: int) -> int:
        word = self._pc.bioskey(command)
        self._note("bioskey", (command & 0xF,), word)
        return word & 0xFFFF

    def getche(self) -> int:
        code = self._pc.getch()
        self._note("getche", (), code)
        self._program.put(bytes([code]))
        return code

    def ungetch(self, code: int) -> int:
        self._pc.ungetch(code)
        self._note("ungetch", (code,))
        return code

    # The text screen

    def gettext(self, left: int, top: int, right: int, bottom: int, to: Any) -> int:
        self._note("gettext", (left, top, right, bottom))
        cells = conio.gettext(left, top, right, bottom)
        to.put(cells)
        return int(bool(cells))

    def puttext(self, left: int, top: int, right: int, bottom: int, source: Any) -> int:
        self._note("puttext", (left, top, right, bottom))
        count = 2 * max(right - left + 1, 0) * max(bottom - top + 1, 0)
        return int(conio.puttext(left, top, right, bottom, source.get(count)))

    def movetext(self, left: int, top: int, right: int, bottom: int, x: int, y: int) -> int:
        self._note("movetext", (left, top, right, bottom, x, y))
        return int(conio.movetext(left, top, right, bottom, x, y))

    def gettextinfo(self, to: Pointer) -> None:
        self._note("gettextinfo")
        found = conio.gettextinfo()
        target = to.memory[to.at]
        for name in target.MEMBERS:
            setattr(target, name, getattr(found, name) & 0xFF)

    # The speaker, and what the BIOS knows

    def sound(self, hertz: int) -> None:
        if current.is_open():
            dos.sound(hertz & 0xFFFF)

    def nosound(self) -> None:
        dos.nosound()

    def biosequip(self) -> int:
        return _EQUIPMENT

    def biosmemory(self) -> int:
        return _KILOBYTES

    _bios_equiplist, _bios_memsize = biosequip, biosmemory

    def biosdisk(self, *given: Any) -> int:
        """No disk answers."""
        return 0x80

    _bios_disk = biosdisk

    def _bios_printer(self, command: int, port: int, byte: int) -> int:
        """No printer answers."""
        return 1

    def biosprint(self, command: int, byte: int, port: int) -> int:
        """No printer answers."""
        return 1

    def bioscom(self, command: int, byte: int, port: int) -> int:
        """No serial port answers."""
        return -0x8000

    def _bios_serialcom(self, command: int, port: int, byte: int) -> int:
        """No serial port answers."""
        return -0x8000

    # Processes: no other program is started

    def system(self, command: Any) -> int:
        asked = characters(command)
        self._note("system", (asked,))
        if not self._program.scripted:
            self._do(asked.decode("cp437").strip().lower())
        return 0

    def _do(self, command: str) -> None:
        """What a program asks the shell of its system for, as far as it is known here."""
        word = command.partition(" ")[0]
        if word in ("cls", "clear"):
            conio.clrscr()
        elif word == "pause":
            self._program.print(b"Press any key to continue . . . ")
            self._pc.getch()
            self._program.print(b"\n")
        elif word not in ("color", "title", "mode", "echo", "date", "time", ""):
            print(f"bgi: the program may not start {command!r}", file=sys.stderr)

    def _started(self, name: str, path: Any) -> int:
        self._note(name, (characters(path),))
        return -1

    def spawnl(self, mode: int, path: Any, *given: Any) -> int:
        return self._started("spawn", path)

    spawnlp = spawnle = spawnlpe = spawnv = spawnve = spawnvp = spawnvpe = spawnl

    def execl(self, path: Any, *given: Any) -> int:
        return self._started("exec", path)

    execlp = execle = execlpe = execv = execve = execvp = execvpe = execl

    def getpid(self) -> int:
        return 1

    # The end

    def exit(self, status: int) -> NoReturn:
        raise ProgramEnd("exit", status & 0xFF)

    _exit = exit

    def abort(self) -> NoReturn:
        raise ProgramEnd("abort", 3)

    def atexit(self, function: Any) -> int:
        self._program.at_exit.append(function)
        return 0

    def _cexit(self) -> None:
        """Everything is written already."""

    _c_exit = _cexit

    def _assertion(self, condition: Any, file: Any, line: int) -> NoReturn:
        where = b"%s, file %s, line %d\n" % (characters(condition), characters(file), line)
        self._program.print(b"Assertion failed: " + where)
        self.abort()

    def signal(self, number: int, handler: Any) -> Any:
        before = self._handlers.get(number)
        self._handlers[number] = handler
        return before

    def raise_(self, number: int) -> int:
        handler = self._handlers.get(number)
        if callable(handler):
            handler(number)
        elif number in (*_ENDS, 2, 15):
            raise ProgramEnd(_ENDS.get(number, "exit"), 3)
        return 0

    def set_new_handler(self, handler: Any) -> None:
        """Memory ends far behind what a program needs."""

    def setlocale(self, kind: int, name: Any) -> Pointer:
        return Pointer(bytearray(b"C\0"))


def direct(name: str) -> Function:
    """A function of conio.h."""
    return getattr(conio, name)  # type: ignore[no-any-return]
