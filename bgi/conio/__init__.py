"""The text screen and the keyboard of the PC: conio.h.

The first call that writes opens a text window of 80 columns and 25 rows, if there is no window yet.
After initgraph() the text screen is hidden behind the picture, as on the PC: what `cprintf` and its
like write is not seen, unless `directvideo` is 0; `bgi.stdio` writes over the picture. closegraph()
leads back. Columns and rows are counted from 1, column first. Text is in code page 437.
"""

from __future__ import annotations

from typing import Any

from bgi import current
from bgi.conio.keys import EOF, getch, kbhit, ungetch
from bgi.conio.textscreen import (
    _setcursortype,
    clreol,
    clrscr,
    gettext,
    gettextinfo,
    gotoxy,
    highvideo,
    lowvideo,
    movetext,
    normvideo,
    puttext,
    textattr,
    textbackground,
    textcolor,
    textmode,
    wherex,
    wherey,
    window,
)
from bgi.console.lineinput import LONGEST, read_line
from bgi.constants import (
    _NOCURSOR,
    _NORMALCURSOR,
    _SOLIDCURSOR,
    BLACK,
    BLINK,
    BLUE,
    BROWN,
    BW40,
    BW80,
    C40,
    C80,
    C4350,
    CYAN,
    DARKGRAY,
    GREEN,
    LASTMODE,
    LIGHTBLUE,
    LIGHTCYAN,
    LIGHTGRAY,
    LIGHTGREEN,
    LIGHTMAGENTA,
    LIGHTRED,
    MAGENTA,
    MONO,
    RED,
    WHITE,
    YELLOW,
)
from bgi.errors import brief
from bgi.fonts.codepage import encode
from bgi.kernel.arguments import Number, whole
from bgi.settings import text_info

# fmt: off
__all__ = [
    # The screen
    "textmode", "window", "clrscr", "clreol", "insline", "delline", "gotoxy", "wherex", "wherey",
    "textattr", "textcolor", "textbackground", "highvideo", "lowvideo", "normvideo",
    "gettextinfo", "gettext", "puttext", "movetext", "_setcursortype", "text_info",
    # Writing
    "cprintf", "cputs", "putch",
    # The keyboard
    "EOF", "getch", "getche", "kbhit", "ungetch", "cgets", "cscanf", "getpass",
    # Text modes, cursors, colours
    "LASTMODE", "BW40", "C40", "BW80", "C80", "MONO", "C4350",
    "_NOCURSOR", "_SOLIDCURSOR", "_NORMALCURSOR",
    "BLACK", "BLUE", "GREEN", "CYAN", "RED", "MAGENTA", "BROWN", "LIGHTGRAY", "DARKGRAY",
    "LIGHTBLUE", "LIGHTGREEN", "LIGHTCYAN", "LIGHTRED", "LIGHTMAGENTA", "YELLOW", "WHITE", "BLINK",
]
# fmt: on

directvideo = 1
"""Whether text goes straight into the memory of the text screen; 0: through the BIOS, which writes
over a picture, too. Set it as `bgi.conio.directvideo = 0`."""

_wscroll = 1
"""Whether the window scrolls at its end; 0: its last row is written anew. Set it as
`bgi.conio._wscroll = 0`."""


def insline() -> None:
    """Insert an empty row where the cursor is; those below move down. Source: conio.h."""
    (current.crt or current.console()).shift_lines(-1, directvideo)


def delline() -> None:
    """Delete the cursor's row; those below move up. Source: conio.h."""
    (current.crt or current.console()).shift_lines(1, directvideo)


def putch(c: Number | str) -> int:
    """Write one character at the cursor, in the attribute of now, and return its code.

    Args:
        c: the character, or its code, of which the low byte counts. 10 goes down only, 13 to the
            left edge, 8 one to the left, 7 is silent.

    Wraps at the window's edge and scrolls at its end. Source: conio.h.
    """
    code = c if type(c) is int else _code(c)
    (current.crt or current.console()).put(code & 0xFF, _wscroll, directvideo)
    return code


def _code(c: object) -> int:
    """The code of a character, which may be given as a text of one."""
    if isinstance(c, (str, bytes)) and len(c) == 1:
        return encode(c)[0]
    return whole("c", c)


def cputs(text: str | bytes) -> int:
    """Write a text at the cursor, in the attribute of now; return its last character's code.

    Args:
        text: what to write. "\\r\\n" is a new line: "\\n" alone goes straight down.

    Wraps at the window's edge and scrolls at its end. Returns 0 for an empty text. Source: conio.h.
    """
    codes = encode(text)
    (current.crt or current.console()).write(codes, _wscroll, directvideo)
    return codes[-1] if codes else 0


def cprintf(format: str | bytes, *args: Any) -> int:
    """Write numbers and texts at the cursor by a format, in the attribute of now.

    Args:
        format: the text, with a conversion such as `%d` or `%-10s` for each argument, as in
            `bgi.stdio.printf`. "\\r\\n" is a new line: "\\n" alone goes straight down.
        args: what the conversions show.

    Wraps at the window's edge and scrolls at its end. Returns how many characters were written.
    TypeError for an argument that is missing or of the wrong kind, ValueError for one out of range:
    nothing is written then. Source: conio.h.
    """
    from bgi.clib import printf  # late, as most programs write by Python's own words

    codes = encode(printf.format(format, *args))
    (current.crt or current.console()).write(codes, _wscroll, directvideo)
    return len(codes)


# Reading


def getche() -> int:
    """Wait for a key, show it at the cursor and return its code.

    Otherwise like getch(); it is shown as putch() shows it. Source: conio.h.
    """
    return putch(getch())


def cgets(longest: Number = 126) -> str:
    """Read a line that is typed in the window, and return it without its end.

    Args:
        longest: how many characters there is room for, 1 to 254; C's function has that and one more
            in its first byte.

    Backspace takes back, Esc all of it. Raises what getch() does, and KeyboardInterrupt at Ctrl-C.
    Source: conio.h.
    """
    room = whole("longest", longest)
    if not 1 <= room <= 254:
        raise ValueError(f"longest must be 1 to 254, not {brief(room)}")
    return _line(room)


def cscanf(format: str | bytes) -> Any:
    """Read numbers and words that are typed in the window, from one line.

    Args:
        format: what to read, a conversion such as `%d` or `%s` for each value.

    Returns what `bgi.stdio.scanf` returns: the value where the format has one conversion, otherwise
    a tuple; None for what was not typed. Raises what getch() does, KeyboardInterrupt at Ctrl-C, and
    ValueError for what is no format, before anything is typed. Source: conio.h.
    """
    from bgi.clib import scanf

    return scanf.scan(_TypedLine(), format).returned()


class _TypedLine:
    """The characters of one line, which is typed when the first of them is asked for."""

    def __init__(self) -> None:
        self._rest: str | None = None

    def getc(self) -> str:
        """The next character, or "" at the end of the line."""
        if self._rest is None:
            self._rest = _line(LONGEST)
        first, self._rest = self._rest[:1], self._rest[1:]
        return first

    def ungetc(self, character: str) -> None:
        """Take the last character back."""
        self._rest = character + (self._rest or "")


def getpass(prompt: str | bytes) -> str:
    """Write a text and read a word that is typed unseen, of 8 characters at most.

    Args:
        prompt: the text.

    Raises what getch() does. Source: conio.h.
    """
    cputs(prompt)
    current.console()
    typed = read_line(current.screen.monitor.read_keystroke, lambda codes: None, lambda: None, 8)
    cputs(b"\r\n")
    return typed.decode("cp437")


def _line(longest: int) -> str:
    """A line that is typed, shown in the window."""
    current.console()
    next_key = current.screen.monitor.read_keystroke
    typed = read_line(next_key, cputs, lambda: cputs(b"\b \b"), longest)
    cputs(b"\r\n")
    return typed.decode("cp437")
