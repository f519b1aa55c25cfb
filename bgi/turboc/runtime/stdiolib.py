"""stdio.h and the words of conio.h: what is printed and read, on the screen and in files."""

from __future__ import annotations

import re
import struct
from typing import Any

from bgi.clib.printf import format as formatted
from bgi.clib.reading import WHITE, Reader, StringSource
from bgi.clib.scanf import parts_of
from bgi.turboc.runtime.binding import characters
from bgi.turboc.runtime.files import EOF, Characters, File, Keyboard, ScreenFile
from bgi.turboc.runtime.memory import Pointer, write_bytes, write_text
from bgi.turboc.runtime.session import Session
from bgi.turboc.runtime.trace import low

DECLARATIONS = """
int printf(text format, ...); int cprintf(text format, ...); int puts(text s); int cputs(text s);
int putchar(int c); int fputchar(int c); int putch(int c);
int sprintf(char *to, text format, ...); int fprintf(FILE *stream, text format, ...);
int vprintf(text format, va_list more); int vfprintf(FILE *stream, text format, va_list more);
int vsprintf(char *to, text format, va_list more); int vscanf(text format, va_list more);
int vsscanf(text from, text format, va_list more);
int vfscanf(FILE *stream, text format, va_list more);
int scanf(text format, ...); int cscanf(text format, ...);
int sscanf(text from, text format, ...); int fscanf(FILE *stream, text format, ...);
char *gets(char *to); char *fgets(char *to, int n, FILE *stream); char *cgets(char *to);
char *getpass(text prompt); int getchar(void); int fgetchar(void); int fgetc(FILE *stream);
int getc(FILE *stream); int ungetc(int c, FILE *stream); int getw(FILE *stream);
int putw(int w, FILE *stream); int fputs(text s, FILE *stream); int fputc(int c, FILE *stream);
int putc(int c, FILE *stream); void perror(text s); char *strerror(int number);
char *_strerror(text s);
"""

NAMES = {
    **dict.fromkeys(("stdin", "stdout", "stderr", "stdaux", "stdprn"), "FILE *@"),
    **{"errno": "int @", "_doserrno": "int @"},
}

TYPES = {"FILE": "struct @ { int kind; };"}

LONGEST_LINE = 999


_CONVERSION = re.compile(rb"%[-+ #0]*(\*|\d*)\.?(\*|\d*)[hlLFN]*(.)")
_ADDRESS = re.compile(rb"(%[-0-9]*)[FN]?p")


def _formatted(format: bytes, values: Any) -> str:
    """What printf() writes."""
    given = [characters(one) if isinstance(one, Pointer) else one for one in values]
    if _ADDRESS.search(format):
        format, given = _ADDRESS.sub(rb"\1Np", format), _fitted(format, given)
    try:
        return formatted(format, *given)
    except TypeError:
        return formatted(format, *_fitted(format, given))


def _fitted(format: bytes, given: list[Any]) -> list[Any]:
    """Arguments as a format wants them: what is of another kind, and an address, is 0.

    In C it would be what happens to lie in memory.
    """
    letters = b"".join([b"".join(parts) for parts in _CONVERSION.findall(format)])
    wanted = re.sub(rb"[\d%]", b"", letters)
    values = list(given)
    for place, letter in enumerate(wanted[: len(given)]):
        texts = isinstance(values[place], bytes)
        if letter == ord("s"):
            values[place] = values[place] if texts else None
        elif texts or letter == ord("p"):
            values[place] = 0
    return values


class StdioLibrary:
    """The functions for one program."""

    def __init__(self, program: Session) -> None:
        self._program = program
        self.keyboard: File = Keyboard(program)
        self.screen: File = ScreenFile(program)

    # Writing

    def vfprintf(self, stream: File | None, format: Any, values: Any) -> int:
        made = _formatted(characters(format), values)
        data = made.encode("cp437", "replace")
        if stream is not None:
            stream.write(data)
        return len(data)

    def fprintf(self, stream: File | None, format: Any, *values: Any) -> int:
        return self.vfprintf(stream, format, values)

    def printf(self, format: Any, *values: Any) -> int:
        return self.vfprintf(self.screen, format, values)

    def cprintf(self, format: Any, *values: Any) -> int:
        made = _formatted(characters(format), values)
        self._program.put(made.encode("cp437", "replace"))
        return len(made)

    def vprintf(self, format: Any, values: Any) -> int:
        return self.vfprintf(self.screen, format, values)

    def vsprintf(self, to: Pointer, format: Any, values: Any) -> int:
        made = _formatted(characters(format), values)
        write_text(to, made.encode("cp437", "replace"))
        return len(made)

    def sprintf(self, to: Pointer, format: Any, *values: Any) -> int:
        return self.vsprintf(to, format, values)

    def puts(self, s: Any) -> int:
        self.screen.write(characters(s) + b"\n")
        return 0

    def fputs(self, s: Any, stream: File | None) -> int:
        if stream is not None:
            stream.write(characters(s))
        return 0

    def cputs(self, s: Any) -> int:
        data = characters(s)
        self._program.put(data)
        return data[-1] if data else 0

    def fputc(self, c: int, stream: File | None) -> int:
        written = stream is not None and stream.write(bytes([c & 0xFF]))
        return c & 0xFF if written else EOF

    putc = fputc

    def putchar(self, c: int) -> int:
        self.screen.write(bytes([c & 0xFF]))
        return c

    fputchar = putchar

    def putch(self, c: int) -> int:
        self._program.put(bytes([c & 0xFF]))
        return c

    def putw(self, w: int, stream: File | None) -> int:
        return w if stream is not None and stream.write(struct.pack("<h", low(w))) else EOF

    def perror(self, s: Any) -> None:
        self.screen.write(characters(s) + b": Error\n")

    def strerror(self, number: int) -> Pointer:
        return Pointer(bytearray(b"Error\n\0"))

    _strerror = strerror

    # Reading by a format

    def vfscanf(self, stream: File | None, format: Any, to: Any) -> int:
        if stream is None:
            return EOF
        return self.scan(Characters(stream), characters(format), to, stream.typed)

    def fscanf(self, stream: File | None, format: Any, *to: Any) -> int:
        return self.vfscanf(stream, format, to)

    def scanf(self, format: Any, *to: Any) -> int:
        return self.vfscanf(self.keyboard, format, to)

    cscanf = scanf

    def vscanf(self, format: Any, to: Any) -> int:
        return self.vfscanf(self.keyboard, format, to)

    def vsscanf(self, source: Any, format: Any, to: Any) -> int:
        text = Recorded(StringSource(characters(source).decode("cp437")))
        return self.scan(text, characters(format), to)

    def sscanf(self, source: Any, format: Any, *to: Any) -> int:
        return self.vsscanf(source, format, to)

    def scan(self, source: Any, format: bytes, to: Any, typed: bool = False) -> int:
        """Read by a format; how many values were stored."""
        reader = Reader(source)
        stored = 0
        targets = iter(to)
        for part in parts_of(format.decode("cp437")):
            source.text = ""
            value = part.read(reader)
            if value is None:
                return EOF if stored == 0 and reader.ended and not reader.taken else stored
            if part.stores:
                text = source.text if part.letter in "c[" else source.text.lstrip(WHITE)
                _store(next(targets, None), part.letter, part.size, value)
                stored += part.letter != "n"
                if typed:
                    self.note_read(text)
        return stored

    def note_read(self, text: str) -> None:
        """Note what was read of the typed text."""
        self._program.read(text.encode("cp437"))

    # Reading lines and characters

    def line(self, stream: File, most: int, end: int = 10, keep: bool = False) -> bytes | None:
        """A line of so many characters at most; None at the end."""
        data = bytearray()
        found = False
        while len(data) < most and (code := stream.getc()) != EOF:
            found = True
            if code != end or keep:
                data.append(code)
            if code == end:
                break
        if found and stream.typed:
            self._program.read(bytes(data))
        return bytes(data) if found else None

    def gets(self, to: Pointer) -> Pointer | None:
        data = self.line(self.keyboard, LONGEST_LINE)
        if data is None:
            return None
        write_text(to, data)
        return to

    def fgets(self, to: Pointer, n: int, stream: File | None) -> Pointer | None:
        data = self.line(stream, n - 1, keep=True) if stream is not None else None
        if data is None:
            return None
        write_text(to, data)
        return to

    def cgets(self, to: Pointer) -> Pointer:
        data = self.line(self.keyboard, to.memory[to.at] - 1) or b""
        to.memory[to.at + 1] = len(data)
        write_text(to + 2, data)
        return to + 2

    def getpass(self, prompt: Any) -> Pointer:
        self.screen.write(characters(prompt))
        return Pointer(bytearray((self.line(self.keyboard, 8) or b"") + b"\0"))

    def fgetc(self, stream: File | None) -> int:
        code = stream.getc() if stream is not None else EOF
        if code != EOF and stream is not None and stream.typed:
            self._program.read(bytes([code]))
        return code

    getc = fgetc

    def getchar(self) -> int:
        return self.fgetc(self.keyboard)

    fgetchar = getchar

    def ungetc(self, c: int, stream: File | None) -> int:
        return stream.ungetc(c) if stream is not None else c

    def getw(self, stream: File | None) -> int:
        data = stream.read(2) if stream is not None else b""
        return int(struct.unpack("<h", data)[0]) if len(data) == 2 else EOF


class Recorded:
    """Passes characters on, and keeps them in `text`."""

    def __init__(self, source: Any) -> None:
        self._source = source
        self.text = ""

    def getc(self) -> str:
        """The next character."""
        character: str = self._source.getc()
        self.text += character
        return character

    def ungetc(self, character: str) -> None:
        """Take it back."""
        self._source.ungetc(character)
        self.text = self.text[:-1]


def _store(to: Any, letter: str, size: str, value: Any) -> None:
    """Store what a conversion has read."""
    if not isinstance(to, Pointer):
        raise ValueError("scanf needs the address of a variable, as in &x")
    if letter in "s[":
        write_text(to, value.encode("cp437"))
    elif letter == "c":
        for place, code in enumerate(value.encode("cp437")):
            to.memory[to.at + place] = code
    elif letter in "feEgG":
        data = struct.pack("<d" if size else "<f", float(value))
        if isinstance(to.memory, bytearray):  # of another type, which gets the bytes
            write_bytes(to, data)
        else:
            to.memory[to.at] = struct.unpack("<d" if size else "<f", data)[0]
    elif "l" in size or letter == "D":
        to.memory[to.at] = (int(value) & 0xFFFFFFFF ^ 0x80000000) - 0x80000000
    elif isinstance(to.memory, bytearray):
        to.memory[to.at] = int(value) & 0xFF
    else:
        to.memory[to.at] = int(value) & 0xFFFF if letter in "uxXo" else low(value)
