"""iostream.h and iomanip.h: cout, cin, and what they are told about form."""

from __future__ import annotations

from typing import Any

from bgi.clib.reading import Reader, read_real, read_whole
from bgi.turboc.runtime.binding import characters
from bgi.turboc.runtime.memory import Pointer, Record, write_text
from bgi.turboc.runtime.stdiolib import StdioLibrary, TypedRecord

LEFT, RIGHT, DEC, OCT, HEX, BASE_SHOWN, POINT, UPPER, PLUS = 2, 4, 16, 32, 64, 128, 256, 512, 1024
SCIENTIFIC, FIXED = 2048, 4096
FIELDS = {LEFT: 14, RIGHT: 14, DEC: 112, OCT: 112, HEX: 112, SCIENTIFIC: 6144, FIXED: 6144}

_NUMBERS = ("int", "unsigned", "long", "unsigned long")
_KINDS = (*_NUMBERS, "char", "unsigned char", "double", "float", "long double", "char *", "void *")

_COMMON = """int width(int n); int precision(int n); char fill(char c); long setf(long flags);
long setf(long flags, long mask); long unsetf(long flags); int good(); int fail(); int eof();
int bad(); void clear();"""

TYPES = {
    "manipulator": "struct @ { int kind, value; };",
    "ostream": "class @ { public: "
    + " ".join(f"ostream &operator<<({kind} v);" for kind in _KINDS)
    + " ostream &operator<<(manipulator v); ostream &flush(); ostream &put(char c);"
    + f" ostream &write(char *s, int n); {_COMMON} }};",
    "istream": "class @ { public: "
    + " ".join(f"istream &operator>>({kind} &v);" for kind in _KINDS if "*" not in kind)
    + " istream &operator>>(char *s); istream &operator>>(manipulator v); int get();"
    + " istream &get(char &c); istream &getline(char *s, int n); istream &ignore(int n, int c);"
    + f" istream &ignore(int n); istream &ignore(); int peek(); {_COMMON} }};",
}

NAMES = {
    **{"cout": "ostream @", "cerr": "ostream @", "clog": "ostream @", "cin": "istream @"},
    **dict.fromkeys(("endl", "ends", "flush", "hex", "dec", "oct", "ws"), "manipulator @"),
}

DECLARATIONS = """
manipulator setw(int n); manipulator setprecision(int n); manipulator setfill(int c);
manipulator setiosflags(long flags); manipulator resetiosflags(long flags);
manipulator setbase(int n);
"""

CONSTANTS = {
    **{"ios::left": LEFT, "ios::right": RIGHT, "ios::dec": DEC, "ios::oct": OCT, "ios::hex": HEX},
    **{"ios::showbase": BASE_SHOWN, "ios::showpoint": POINT, "ios::uppercase": UPPER},
    **{"ios::showpos": PLUS, "ios::scientific": SCIENTIFIC, "ios::fixed": FIXED, "ios::in": 1},
    **{"ios::out": 2, "ios::ate": 4, "ios::app": 8, "ios::trunc": 16, "ios::nocreate": 32},
    **{"ios::binary": 128, "ios::adjustfield": 14, "ios::basefield": 112, "ios::floatfield": 6144},
}


class manipulator(Record):
    """What is told to a stream: a kind and a value."""

    __slots__ = ("kind", "value")
    MEMBERS = ("kind", "value")

    def __init__(self, kind: str = "", value: int = 0) -> None:
        self.kind = kind
        self.value = value


def _maker(kind: str) -> Any:
    return lambda value: manipulator(kind, value)


MANIPULATORS: dict[str, Any] = {
    **{"endl": manipulator("write", 10), "ends": manipulator("write", 0)},
    **{"flush": manipulator(), "ws": manipulator("ws")},
    **{"dec": manipulator("base", DEC), "oct": manipulator("base", OCT)},
    **{"hex": manipulator("base", HEX), "setw": _maker("width")},
    **{"setprecision": _maker("precision"), "setfill": _maker("fill")},
    **{"setiosflags": _maker("set"), "resetiosflags": _maker("reset")},
    "setbase": lambda n: manipulator("base", {8: OCT, 16: HEX}.get(n, DEC)),
}


class _Formatted:
    """The form of numbers, and whether all went well."""

    def __init__(self, library: StdioLibrary) -> None:
        self._library = library
        self._flags, self._width, self._precision, self._fill = 1, 0, 6, 32
        self._failed = False

    def width(self, n: int) -> int:
        before, self._width = self._width, n
        return before

    def precision(self, n: int) -> int:
        before, self._precision = self._precision, n
        return before

    def fill(self, c: int) -> int:
        before, self._fill = self._fill, c & 0xFF
        return before

    def setf(self, flags: int, mask: int = 0) -> int:
        before = self._flags
        self._flags = before & ~mask | flags
        return before

    def unsetf(self, flags: int) -> int:
        before, self._flags = self._flags, self._flags & ~flags
        return before

    def good(self) -> int:
        return int(not self._failed)

    def fail(self) -> int:
        return int(self._failed)

    bad = eof = fail

    def clear(self) -> None:
        self._failed = False

    def obey(self, told: manipulator) -> None:
        """What a manipulator says."""
        match told.kind:
            case "width" | "precision" | "fill":
                getattr(self, told.kind)(told.value)
            case "base":
                self.setf(told.value, 112)
            case "set":
                self.setf(told.value)
            case "reset":
                self.unsetf(told.value)


class ostream(_Formatted):
    """Where `<<` writes."""

    def _padded(self, data: bytes) -> ostream:
        fill = bytes([self._fill]) * (self._width - len(data))
        self._width = 0
        self._library._program.print(data + fill if self._flags & LEFT else fill + data)
        return self

    def shift_left_int(self, v: int, bits: int = 16) -> ostream:
        if self._flags & (HEX | OCT):
            digits = f"{v & (1 << bits) - 1:{'x' if self._flags & HEX else 'o'}}"
            digits = digits.upper() if self._flags & UPPER else digits
            shown = ("0x" if self._flags & HEX else "0") if self._flags & BASE_SHOWN else ""
            return self._padded((shown + digits).encode())
        return self._padded(f"{v:{'+' if self._flags & PLUS else ''}d}".encode())

    shift_left_unsigned = shift_left_int

    def shift_left_long(self, v: int) -> ostream:
        return self.shift_left_int(v, 32)

    shift_left_unsigned_long = shift_left_long

    def shift_left_char(self, v: int) -> ostream:
        return self._padded(bytes([v & 0xFF]))

    shift_left_unsigned_char = shift_left_char

    def shift_left_double(self, v: float) -> ostream:
        precision, flags = self._precision, self._flags
        if precision == 0 and not flags & (SCIENTIFIC | FIXED):
            precision = 6
        letter = "f" if flags & FIXED else "e" if flags & SCIENTIFIC else "g"
        mark = ("+" if flags & PLUS else "") + ("#" if flags & POINT and letter == "g" else "")
        return self._padded(f"{f'%{mark}.{precision}{letter}' % v}".encode())

    shift_left_float = shift_left_long_double = shift_left_double

    def shift_left_char_pointer(self, v: Any) -> ostream:
        return self._padded(characters(v))

    shift_left_char__pointer = shift_left_char_pointer

    def shift_left_void_pointer(self, v: Any) -> ostream:
        return self._padded(b"0x0000")

    shift_left_void__pointer = shift_left_void_pointer

    def shift_left_manipulator(self, v: manipulator) -> ostream:
        if v.kind == "write":
            self._library._program.print(bytes([v.value]))
        self.obey(v)
        return self

    def put(self, c: int) -> ostream:
        self._library._program.print(bytes([c & 0xFF]))
        return self

    def write(self, s: Pointer, n: int) -> ostream:
        self._library._program.print(bytes(s.memory[s.at : s.at + n]))
        return self

    def flush(self) -> ostream:
        return self


class istream(_Formatted):
    """Where `>>` reads; a target is a memory of one."""

    def _take(self, read: Any) -> Any:
        if self._failed:
            return None
        recorder = TypedRecord(self._library._pc)
        reader = Reader(recorder)
        reader.skip_white()
        recorder.text = ""
        reader.begin(80)
        value = read(reader)
        if value is None:
            self._failed = True
        else:
            self._library._program.read(recorder.text.encode("cp437"))
        return value

    def _number(self, to: Pointer, low: int, bits: int) -> istream:
        base = 16 if self._flags & HEX else 8 if self._flags & OCT else 10
        value = self._take(lambda reader: read_whole(reader, base))
        if value is not None:
            to.memory[to.at] = (value - low & (1 << bits) - 1) + low
        return self

    def shift_right_int_reference(self, to: Pointer) -> istream:
        return self._number(to, -0x8000, 16)

    def shift_right_unsigned_reference(self, to: Pointer) -> istream:
        return self._number(to, 0, 16)

    def shift_right_long_reference(self, to: Pointer) -> istream:
        return self._number(to, -0x80000000, 32)

    def shift_right_unsigned_long_reference(self, to: Pointer) -> istream:
        return self._number(to, 0, 32)

    def shift_right_double_reference(self, to: Pointer) -> istream:
        value = self._take(read_real)
        if value is not None:
            to.memory[to.at] = value
        return self

    shift_right_float_reference = shift_right_double_reference
    shift_right_long_double_reference = shift_right_double_reference

    def shift_right_char_reference(self, to: Pointer) -> istream:
        value = self._take(lambda reader: reader.take(lambda c: True) or None)
        if value is not None:
            to.memory[to.at] = value.encode("cp437")[0]
        return self

    shift_right_unsigned_char_reference = shift_right_char_reference

    def shift_right_char_pointer(self, to: Pointer) -> istream:
        value = self._take(lambda reader: reader.take_all(lambda c: not c.isspace()) or None)
        if value is not None:
            write_text(to, value.encode("cp437"))
        return self

    shift_right_char__pointer = shift_right_char_pointer

    def shift_right_manipulator(self, v: manipulator) -> istream:
        self.obey(v)
        return self

    def get(self, to: Pointer | None = None) -> Any:
        code = self._library.getchar()
        if to is None:
            return code
        to.memory[to.at] = code & 0xFF
        return self

    def getline(self, s: Pointer, n: int) -> istream:
        write_text(s, self._library.line(n - 1))
        return self

    def ignore(self, n: int = 1, c: int = -1) -> istream:
        for _ in range(n):
            if self._library.getchar() in (c, -1):
                break
        return self

    def peek(self) -> int:
        character = self._library._pc.getc()
        self._library._pc.ungetc(character)
        return character.encode("cp437")[0] if character else -1
