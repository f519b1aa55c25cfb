"""iostream.h: cout and cin, and what streams of files share with them."""

from __future__ import annotations

from typing import Any

from bgi.clib.reading import Reader, read_real, read_whole
from bgi.turboc.runtime.binding import characters
from bgi.turboc.runtime.files import EOF, Characters, File
from bgi.turboc.runtime.manipulators import (
    BAD,
    BASE_SHOWN,
    END,
    FAILED,
    FIXED,
    HEX,
    LEFT,
    OCT,
    PLUS,
    POINT,
    SCIENTIFIC,
    UPPER,
    manipulator,
)
from bgi.turboc.runtime.memory import Pointer, write_text
from bgi.turboc.runtime.plaindata import Plain
from bgi.turboc.runtime.stdiolib import StdioLibrary
from bgi.turboc.runtime.streambase import STATE, ios

_NUMBERS = ("int", "unsigned", "long", "unsigned long")
_KINDS = (*_NUMBERS, "char", "unsigned char", "double", "float", "long double")
_POINTERS = ("char *", "unsigned char *", "void *")

WRITING = (
    " ".join(f"@ &operator<<({kind} v);" for kind in (*_KINDS, *_POINTERS))
    + "@ &operator<<(manipulator v); @ &operator<<(streambuf *v); @ &flush(); @ &put(char c);"
    "@ &write(data s, int n); @ &seekp(long p); @ &seekp(long p, int from); long tellp();"
)

READING = (
    " ".join(f"@ &operator>>({kind} &v);" for kind in _KINDS)
    + """@ &operator>>(char *s); @ &operator>>(unsigned char *s); @ &operator>>(manipulator v);
    int get(); @ &get(char &c); @ &get(unsigned char &c); @ &get(char *s, int n);
    @ &get(char *s, int n, int end); @ &getline(char *s, int n);
    @ &getline(char *s, int n, int end); @ &ignore(); @ &ignore(int n);
    @ &ignore(int n, int c); @ &read(data s, int n); int peek();
    @ &putback(char c); int gcount(); int sync(); @ &seekg(long p); @ &seekg(long p, int from);
    long tellg();"""
)

TYPES = {
    "streambuf": "struct @ { int kind; };",
    "ios": f"class @ {{ public: {STATE} }};",
    "ostream": f"class @ : public ios {{ public: {WRITING.replace('@', 'ostream')} }};",
    "istream": f"class @ : public ios {{ public: {READING.replace('@', 'istream')} }};",
}

NAMES = {
    **dict.fromkeys(("cout", "cerr", "clog"), "ostream @"),
    "cin": "istream @",
}

MOST_OF_A_WORD = 256


class ostream(ios):
    """Where `<<` writes."""

    __slots__ = ()

    def _written(self, data: bytes) -> Any:
        if self.file is None or not self.file.write(data):
            self._state |= BAD
        return self

    def _padded(self, data: bytes) -> Any:
        fill = bytes([self._fill]) * (self._width - len(data))
        self._width = 0
        return self._written(data + fill if self._flags & LEFT else fill + data)

    def shift_left_int(self, v: int, bits: int = 16) -> Any:
        if self._flags & (HEX | OCT):
            digits = f"{v & (1 << bits) - 1:{'x' if self._flags & HEX else 'o'}}"
            digits = digits.upper() if self._flags & UPPER else digits
            shown = ("0x" if self._flags & HEX else "0") if self._flags & BASE_SHOWN else ""
            return self._padded((shown + digits).encode())
        return self._padded(f"{v:{'+' if self._flags & PLUS else ''}d}".encode())

    shift_left_unsigned = shift_left_int

    def shift_left_long(self, v: int) -> Any:
        return self.shift_left_int(v, 32)

    shift_left_unsigned_long = shift_left_long

    def shift_left_char(self, v: int) -> Any:
        return self._padded(bytes([v & 0xFF]))

    shift_left_unsigned_char = shift_left_char

    def shift_left_double(self, v: float) -> Any:
        precision, flags = self._precision, self._flags
        if precision == 0 and not flags & (SCIENTIFIC | FIXED):
            precision = 6
        letter = "f" if flags & FIXED else "e" if flags & SCIENTIFIC else "g"
        mark = ("+" if flags & PLUS else "") + ("#" if flags & POINT and letter == "g" else "")
        return self._padded(f"{f'%{mark}.{precision}{letter}' % v}".encode())

    shift_left_float = shift_left_long_double = shift_left_double

    def shift_left_char_pointer(self, v: Any) -> Any:
        return self._padded(characters(v))

    shift_left_unsigned_char_pointer = shift_left_char_pointer

    def shift_left_void_pointer(self, v: Any) -> Any:
        return self._padded(b"0x0000")

    def shift_left_manipulator(self, v: manipulator) -> Any:
        if v.kind == "write":
            self._written(bytes([v.value]))
        self.obey(v)
        return self

    def shift_left_streambuf_pointer(self, v: Pointer) -> Any:
        """All of a file."""
        file = v.memory[v.at]
        while file is not None and (data := file.read(4096)):
            self._written(data)
        return self

    def put(self, c: int) -> Any:
        return self._written(bytes([c & 0xFF]))

    def write(self, s: Plain, n: int) -> Any:
        return self._written(s.get(n))

    def flush(self) -> Any:
        return self

    def seekp(self, place: int, whence: int = 0) -> Any:
        return self._seek(place, whence)

    def tellp(self) -> int:
        return self._tell()


class istream(ios):
    """Where `>>` reads; a target is a memory of one."""

    __slots__ = ("_count",)

    def __init__(self, library: StdioLibrary, file: File | None = None) -> None:
        super().__init__(library, file)
        self._count = 0

    def _ended(self) -> Any:
        self._state |= END | FAILED
        return self

    def _take(self, read: Any, width: int = 80) -> Any:
        """A field; None if there is none."""
        file = self.file
        if self._state or file is None:
            self._state |= FAILED
            return None
        source = Characters(file)
        reader = Reader(source)
        reader.skip_white()
        source.text = ""
        reader.begin(width)
        value = read(reader)
        if value is None:
            self._state |= FAILED | (END if file.ended else 0)
        elif file.typed:
            self.library.note_read(source.text)
        return value

    def _number(self, to: Pointer, low: int, bits: int) -> Any:
        base = 16 if self._flags & HEX else 8 if self._flags & OCT else 10
        value = self._take(lambda reader: read_whole(reader, base))
        if value is not None:
            to.memory[to.at] = (value - low & (1 << bits) - 1) + low
        return self

    def shift_right_int_reference(self, to: Pointer) -> Any:
        return self._number(to, -0x8000, 16)

    def shift_right_unsigned_reference(self, to: Pointer) -> Any:
        return self._number(to, 0, 16)

    def shift_right_long_reference(self, to: Pointer) -> Any:
        return self._number(to, -0x80000000, 32)

    def shift_right_unsigned_long_reference(self, to: Pointer) -> Any:
        return self._number(to, 0, 32)

    def shift_right_double_reference(self, to: Pointer) -> Any:
        value = self._take(read_real)
        if value is not None:
            to.memory[to.at] = value
        return self

    shift_right_float_reference = shift_right_double_reference
    shift_right_long_double_reference = shift_right_double_reference

    def shift_right_char_reference(self, to: Pointer) -> Any:
        value = self._take(lambda reader: reader.take(lambda c: True) or None)
        if value is not None:
            to.memory[to.at] = value.encode("cp437")[0]
        return self

    shift_right_unsigned_char_reference = shift_right_char_reference

    def shift_right_char_pointer(self, to: Pointer) -> Any:
        most, self._width = self._width - 1 if self._width > 0 else MOST_OF_A_WORD, 0
        value = self._take(lambda one: one.take_all(lambda c: not c.isspace()) or None, most)
        if value is not None:
            write_text(to, value.encode("cp437"))
        return self

    shift_right_unsigned_char_pointer = shift_right_char_pointer

    def shift_right_manipulator(self, v: manipulator) -> Any:
        if v.kind == "ws":
            self._skip_white()
        self.obey(v)
        return self

    def _skip_white(self) -> None:
        while self.file is not None and self.peek() in (9, 10, 11, 12, 13, 32):
            self.file.getc()

    def get(self, to: Pointer | None = None, n: int = 0, end: int = 10) -> Any:
        """A character, or with a count a line, whose end stays."""
        if n:
            assert to is not None
            self.getline(to, n, end)
            if self._count and self.file is not None:
                self.file.ungetc(end)
            return self
        code = self.library.fgetc(self.file)
        self._count = int(code != EOF)
        if code == EOF:
            self._ended()
        if to is None:
            return code
        if code != EOF:
            to.memory[to.at] = code
        return self

    def getline(self, s: Pointer, n: int, end: int = 10) -> Any:
        data = self.library.line(self.file, n - 1, end & 0xFF) if self.file is not None else None
        self._count = len(data) if data is not None else 0
        write_text(s, data or b"")
        return self if data is not None else self._ended()

    def ignore(self, n: int = 1, c: int = EOF) -> Any:
        for _ in range(n):
            code = self.library.fgetc(self.file)
            if code == EOF:
                self._state |= END
            if code in (c, EOF):
                break
        return self

    def read(self, s: Plain, n: int) -> Any:
        data = self.file.read(n) if self.file is not None else b""
        s.put(data)
        self._count = len(data)
        return self if len(data) == n else self._ended()

    def peek(self) -> int:
        code = self.library.fgetc(self.file)
        return self.file.ungetc(code) if self.file is not None else code

    def putback(self, c: int) -> Any:
        if self.file is not None:
            self.file.ungetc(c & 0xFF)
        return self

    def gcount(self) -> int:
        return self._count

    def sync(self) -> int:
        return 0

    def seekg(self, place: int, whence: int = 0) -> Any:
        return self._seek(place, whence)

    def tellg(self) -> int:
        return self._tell()
