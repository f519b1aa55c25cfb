"""The keyboard: keys one by one, as conio.h asks for them."""

from __future__ import annotations

import warnings

from bgi import current
from bgi.errors import BGIWarning, brief
from bgi.kernel.arguments import Number, whole

__all__ = ["EOF", "getch", "kbhit", "ungetch"]

EOF = -1
"""What ungetch() returns when it cannot."""


def kbhit() -> int:
    """Tell whether a key waits to be read: 1 or 0.

    The second byte of an extended key waits too, until getch() has fetched it. Before
    initgraph it opens a text window. Raises WindowClosed once the user has closed the window.
    Source: conio.h.
    """
    return int(current.screen.monitor.key_waiting())


def getch() -> int:
    """Wait for a key and return its code, without showing it.

    A key without a character (arrows, F1..F10, Home, Alt-letters, ...) returns 0 first; the next
    call returns its scan code: 72, 80, 75, 77 for up, down, left, right. Enter is 13, Esc 27;
    characters beyond ASCII have their codes of code page 437. Before initgraph it opens a text
    window. Raises WindowClosed if the window is closed meanwhile, and NobodyThere, a kind of it,
    without a window once the scripted keys (BGI_KEYS) are used up. Source: conio.h.
    """
    return _KEYS[current.screen.monitor.read_key()]


class Key(int):
    """The code of a key: a number, but it warns whoever compares it with a text."""

    __slots__ = ()
    __hash__ = int.__hash__

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):
            _warn(other)
        return int.__eq__(self, other)

    def __ne__(self, other: object) -> bool:
        if isinstance(other, str):
            _warn(other)
        return int.__ne__(self, other)


_KEYS = [Key(code) for code in range(256)]


def _warn(text: str) -> None:
    """Point at the line of the program that compares a key with a text."""
    number = f"ord({text!r})" if len(text) == 1 else "the number of one, such as ord('q')"
    warnings.warn(f"getch() returns a number; compare with {number}", BGIWarning, stacklevel=3)


def ungetch(c: Number) -> int:
    """Give a character back, so that the next getch() returns it.

    Args:
        c: its code, 0 to 255.

    Returns it, or EOF (-1), and does nothing, if one has been given back already, or if half an
    extended key waits there. ValueError for any other number. Source: conio.h.
    """
    code = whole("c", c)
    if not 0 <= code <= 255:
        raise ValueError(f"c must be a code from 0 to 255, not {brief(code)}")
    return code if current.screen.monitor.keys.put_back(code) else EOF
