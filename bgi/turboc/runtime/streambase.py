"""The base of all streams: a file, the form of numbers, and whether all went well."""

from __future__ import annotations

from typing import Any

from bgi import conio
from bgi.turboc.runtime.files import File
from bgi.turboc.runtime.manipulators import BAD, BASE, END, FAILED, SKIP, manipulator
from bgi.turboc.runtime.memory import Pointer, Record
from bgi.turboc.runtime.stdiolib import StdioLibrary

STATE = """int width(); int width(int n); int precision(); int precision(int n); char fill();
char fill(char c); long flags(); long flags(long f); long setf(long f);
long setf(long f, long mask); long unsetf(long f); int good(); int fail(); int eof(); int bad();
int rdstate(); void clear(); void clear(int state); int operator!(); int operator==(int null);
int operator!=(int null); int operator<(char *s); int operator>(char *s); streambuf *rdbuf();
void tie(void *other); void sync_with_stdio();"""


class ios(Record):
    """A stream's file, the form of its numbers, and whether all went well."""

    __slots__ = ("_fill", "_flags", "_precision", "_state", "_width", "file", "library")

    def __init__(self, library: StdioLibrary, file: File | None = None) -> None:
        self.library, self.file = library, file
        self._flags, self._width, self._precision, self._fill = SKIP, 0, 6, 32
        self._state = 0

    def copy(self) -> Any:
        """The same: a stream is one, wherever it is given."""
        return self

    def width(self, n: int | None = None) -> int:
        before = self._width
        self._width = before if n is None else n
        return before

    def precision(self, n: int | None = None) -> int:
        before = self._precision
        self._precision = before if n is None else n
        return before

    def fill(self, c: int | None = None) -> int:
        before = self._fill
        self._fill = before if c is None else c & 0xFF
        return before

    def flags(self, f: int | None = None) -> int:
        before = self._flags
        self._flags = before if f is None else f
        return before

    def setf(self, flags: int, mask: int | None = None) -> int:
        before = self._flags
        self._flags = before | flags if mask is None else before & ~mask | flags & mask
        return before

    def unsetf(self, flags: int) -> int:
        before, self._flags = self._flags, self._flags & ~flags
        return before

    def rdstate(self) -> int:
        return self._state

    def good(self) -> int:
        return int(not self._state)

    def fail(self) -> int:
        return self._state & (FAILED | BAD)

    def bad(self) -> int:
        return self._state & BAD

    def eof(self) -> int:
        return self._state & END

    def clear(self, state: int = 0) -> None:
        self._state = state

    def fails(self) -> int:
        return int(bool(self.fail()))

    def equals_int(self, null: int) -> int:
        return self.fails()

    def differs_int(self, null: int) -> int:
        return int(not self.fails())

    def less_char_pointer(self, s: Any) -> int:
        """`cout < "text"` compares addresses, and prints nothing."""
        return 0

    greater_char_pointer = less_char_pointer

    def rdbuf(self) -> Pointer:
        return Pointer([self.file])

    def tie(self, other: Any) -> None:
        """Both are the same screen."""

    sync_with_stdio = tie

    def obey(self, told: manipulator) -> None:
        """What a manipulator says."""
        match told.kind:
            case "width" | "precision" | "fill":
                getattr(self, told.kind)(told.value)
            case "base":
                self.setf(told.value, BASE)
            case "set":
                self.setf(told.value)
            case "reset":
                self.unsetf(told.value)
            case "gotoxy":
                conio.gotoxy(*told.value)
            case "textcolor" | "textbackground" | "textattr" | "_setcursortype":
                getattr(conio, told.kind)(told.value)

    def _seek(self, place: int, whence: int) -> Any:
        self._state = 0
        if self.file is None or not self.file.seek(place, whence):
            self._state = FAILED
        return self

    def _tell(self) -> int:
        return self.file.tell() if self.file is not None else -1
