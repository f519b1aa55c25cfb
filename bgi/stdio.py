"""printf(), scanf() and their like on the screen of the PC: stdio.h.

In a text mode they write as DOS does, at the cursor, over the whole screen, in the attributes that
the cells have. Over a picture they write letters of the adapter's ROM, in light grey on black, and
the picture scrolls at its last row; `bgi.conio.gotoxy` says where. What is typed is shown there,
Backspace takes it back, and Enter ends it. The first call opens a text window where there is none.

`with on_screen():` sends Python's own words there: print(), input(), and what an error says.
"""

from __future__ import annotations

import io
import os
import sys
import traceback
from types import TracebackType
from typing import Any

from bgi import current
from bgi.clib import printf as _printf
from bgi.clib import scanf as _scanf
from bgi.clib.scanf import EOF, sscanf
from bgi.console.lineinput import read_line
from bgi.errors import BGIError, WindowClosed, brief
from bgi.fonts.codepage import encode
from bgi.kernel.arguments import Number, whole
from bgi.kernel.state import KERNEL

# fmt: off
__all__ = [
    "printf", "puts", "putchar", "fprintf", "fputs", "perror", "sprintf",
    "scanf", "gets", "getchar", "fflush", "sscanf",
    "on_screen", "EOF", "stdin", "stdout", "stderr",
]
# fmt: on

END_OF_FILE = "\x1a"
"""Ctrl-Z: what ends the input in DOS."""


class _Stream:
    """One of C's streams, as an argument: all of them are the screen and the keyboard."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __repr__(self) -> str:
        return self._name


stdin = _Stream("stdin")
"""The keyboard, for fflush()."""
stdout = _Stream("stdout")
"""The screen, for fprintf() and fputs()."""
stderr = _Stream("stderr")
"""The screen, too: in DOS it is where errors are said."""


# Writing


def printf(format: str | bytes, *args: Any) -> int:
    """Write numbers and texts on the screen by a format, as in `printf("%d + %d\\\\n", 1, 2)`.

    Args:
        format: the text, with a conversion such as `%d` or `%-10s` for each argument: all of Turbo
            C's, with flags, width and precision. "\\\\n" begins a new line.
        args: what the conversions show: numbers and texts.

    Returns how many characters were written. TypeError for an argument that is missing or of the
    wrong kind, ValueError for one out of range: nothing is written then. Source: stdio.h.
    """
    return _write(_printf.format(format, *args))


def puts(s: str | bytes) -> int:
    """Write a text on the screen and begin a new line; returns 10, that line's code.

    Args:
        s: the text.

    Source: stdio.h.
    """
    (current.crt or current.console()).print(encode(s) + b"\n")
    return 10


def putchar(c: Number | str) -> int:
    """Write one character on the screen and return its code.

    Args:
        c: the character, or its code.

    Source: stdio.h.
    """
    code = encode(c)[0] if isinstance(c, (str, bytes)) and len(c) == 1 else whole("c", c) & 0xFF
    (current.crt or current.console()).print(bytes([code]))
    return code


def fprintf(stream: _Stream, format: str | bytes, *args: Any) -> int:
    """Write on the screen as printf() does.

    Args:
        stream: stdout or stderr, which are both the screen.
        format, args: as for printf().

    Source: stdio.h.
    """
    _check_output(stream)
    return _write(_printf.format(format, *args))


def fputs(s: str | bytes, stream: _Stream) -> int:
    """Write a text on the screen as it is; returns its last character's code, or 0.

    Args:
        s: the text; no new line is added.
        stream: stdout or stderr, which are both the screen.

    Source: stdio.h.
    """
    _check_output(stream)
    codes = encode(s)
    (current.crt or current.console()).print(codes)
    return codes[-1] if codes else 0


def perror(s: str) -> None:
    """Write a text and what the last error was: the exception that is being handled.

    Args:
        s: the text, followed by a colon. `Error 0` stands for no error.

    Source: stdio.h.
    """
    error = sys.exception()
    number = error.errno if isinstance(error, OSError) else None
    words = str(error) if error and number is None else os.strerror(number) if number else "Error 0"
    _write(f"{s}: {words}\n")


def sprintf(format: str | bytes, *args: Any) -> str:
    """Return what printf() would write.

    Args:
        format, args: as for printf().

    Source: stdio.h.
    """
    return _printf.format(format, *args)


def _write(text: str) -> int:
    (current.crt or current.console()).print(encode(text))
    return len(text)


def _check_output(stream: _Stream) -> None:
    if stream not in (stdout, stderr):
        raise TypeError(f"stream must be stdout or stderr, not {brief(stream)}")


# Reading


class _Typed:
    """What is typed, a line at a time; the rest of a line waits for the next call."""

    def getc(self) -> str:
        """The next character, or "" where Ctrl-Z ends the input."""
        if not KERNEL.typed:
            KERNEL.typed = _typed_line() + "\n"
        first, KERNEL.typed = KERNEL.typed[0], KERNEL.typed[1:]
        if first != END_OF_FILE:
            return first
        KERNEL.typed = ""
        return ""

    def ungetc(self, character: str) -> None:
        """Take the last character back."""
        KERNEL.typed = character + KERNEL.typed

    def line(self) -> str:
        """The rest of the line, with its end; "" at the end of the input."""
        line = self.getc()
        while line and not line.endswith("\n"):
            after = self.getc()
            if not after:
                break
            line += after
        return line


TYPED = _Typed()


def _typed_line() -> str:
    """A line from the keyboard, shown as it is typed."""
    crt = current.crt or current.console()
    line = read_line(current.screen.monitor.read_keystroke, crt.teletype, crt.erase)
    crt.print(b"\n")
    return line.decode("cp437")


def scanf(format: str | bytes) -> Any:
    """Read numbers and words that are typed: `x, y = scanf("%d%d")`.

    Args:
        format: what to read, a conversion such as `%d`, `%f` or `%s` for each value: all of Turbo
            C's, with width, `*` and sets such as `%[a-z]`.

    Returns what C stores through pointers: the value where the format has one conversion, as in
    `n = scanf("%d")`, otherwise a tuple of as many values as it has; None for what was not typed.
    The rest of the line waits for the next call: `fflush(stdin)` forgets it. Raises what getch()
    does, and KeyboardInterrupt at Ctrl-C. Source: stdio.h.
    """
    return _scanf.scan(TYPED, format).returned()


def gets() -> str | None:
    """Read a line that is typed, without its end; None if Ctrl-Z ends the input.

    Source: stdio.h.
    """
    line = TYPED.line()
    return line.removesuffix("\n") if line else None


def getchar() -> int:
    """Read one character of what is typed and return its code; EOF (-1) at Ctrl-Z.

    It waits for Enter, as in C; getch() does not. Source: stdio.h.
    """
    found = TYPED.getc()
    return encode(found)[0] if found else EOF


def fflush(stream: _Stream) -> int:
    """Forget the rest of what has been typed, with `fflush(stdin)`; returns 0.

    Args:
        stream: stdin; of stdout and stderr everything is written at once.

    Source: stdio.h.
    """
    if stream is stdin:
        KERNEL.typed = ""
    else:
        _check_output(stream)
    return 0


# Python's own words


class _ScreenOutput(io.TextIOBase):
    """Takes the place of sys.stdout: writes on the screen, or on `before` once that is gone."""

    def __init__(self, before: Any) -> None:
        self._before = before
        self._busy = False

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        if not self._busy:  # opening the screen, bgi may have something to say itself
            self._busy = True
            try:
                return _write(text)
            except BGIError:
                pass
            finally:
                self._busy = False
        if self._before is not None:
            self._before.write(text)
        return len(text)


class _ScreenInput(io.TextIOBase):
    """Takes the place of sys.stdin: reads what is typed."""

    def readable(self) -> bool:
        return True

    def readline(self, size: int | None = -1) -> str:  # type: ignore[override]
        return TYPED.line()

    def read(self, size: int | None = -1) -> str:
        return "".join(iter(self.readline, ""))


class on_screen:
    """Send Python's own words to the screen: `with on_screen(): print("Hello")`.

    print() and input(), sys.stdout, sys.stderr and sys.stdin are the screen and the keyboard until
    the block ends, in a text mode or over a picture; what an error says that ends the block is
    written there, too. `python -m bgi --console PROGRAM.py` does it for a whole program. Source:
    this package.
    """

    def __enter__(self) -> on_screen:
        self._before = sys.stdin, sys.stdout, sys.stderr
        sys.stdin = _ScreenInput()
        sys.stdout, sys.stderr = (_ScreenOutput(stream) for stream in self._before[1:])
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        where: TracebackType | None,
    ) -> None:
        if isinstance(error, Exception) and not isinstance(error, WindowClosed):
            traceback.print_exception(error)
        sys.stdin, sys.stdout, sys.stderr = self._before
