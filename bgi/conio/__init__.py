"""The text screen and the keyboard of the PC: conio.h.

The first call that writes opens a text window of 80 columns and 25 rows, if there is no window yet.
After initgraph() the text screen is hidden behind the picture, as on the PC: what `cprintf` and its
like write is not seen, unless `directvideo` is 0; `bgi.stdio` writes over the picture. closegraph()
leads back. Columns and rows are counted from 1, column first. Text is in code page 437.
"""

from __future__ import annotations

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
    "cputs", "putch",
    # The keyboard
    "EOF", "getch", "getche", "kbhit", "ungetch",
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


def putch(c: Number) -> int:
    """Write one character at the cursor, in the attribute of now, and return its code.

    Args:
        c: its code, 0..255; the low byte counts. 10 goes down only, 13 to the left edge, 8 one to
            the left, 7 is silent.

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


def getche() -> int:
    """Wait for a key, show it at the cursor and return its code.

    Otherwise like getch(); it is shown as putch() shows it. Source: conio.h.
    """
    return putch(getch())
