"""stdio.h: what is printed and read."""

from __future__ import annotations

import struct
from typing import Any

from bgi.clib.printf import format as formatted
from bgi.clib.reading import WHITE, Reader, StringSource
from bgi.clib.scanf import EOF, parts_of
from bgi.turboc.runtime.binding import characters
from bgi.turboc.runtime.memory import Pointer, write_text
from bgi.turboc.runtime.session import Session
from bgi.turboc.runtime.trace import low

DECLARATIONS = """
int printf(text format, ...); int cprintf(text format, ...); int puts(text s); int cputs(text s);
int putchar(int c); int putch(int c); int sprintf(char *to, text format, ...);
int scanf(text format, ...); int cscanf(text format, ...);
int sscanf(text from, text format, ...); char *gets(char *to); int getchar(void);
int fflush(FILE *stream); int flushall(void); int fprintf(FILE *stream, text format, ...);
int fputs(text s, FILE *stream); int fputc(int c, FILE *stream); int putc(int c, FILE *stream);
char *fgets(char *to, int n, FILE *stream); int fgetc(FILE *stream); int getc(FILE *stream);
FILE *fopen(text name, text mode); int fclose(FILE *stream); int feof(FILE *stream);
int fscanf(FILE *stream, text format, ...); char *cgets(char *to); void perror(text s);
"""

NAMES = {"stdin": "FILE *@", "stdout": "FILE *@", "stderr": "FILE *@", "stdprn": "FILE *@"}

TYPES = {"FILE": "struct @ { int kind; };"}


class TypedRecord:
    """Passes characters on, and keeps them."""

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


def _shown(value: Any) -> Any:
    return characters(value) if isinstance(value, Pointer) else value


class StdioLibrary:
    """The functions for one program."""

    def __init__(self, program: Session) -> None:
        self._program = program
        self._pc = program.pc

    # Writing

    def printf(self, format: Any, *values: Any) -> int:
        data = self._format(format, values)
        self._program.print(data)
        return len(data)

    def cprintf(self, format: Any, *values: Any) -> int:
        data = self._format(format, values)
        self._program.put(data)
        return len(data)

    def _format(self, format: Any, values: tuple[Any, ...]) -> bytes:
        made = formatted(characters(format), *map(_shown, values))
        return made.encode("cp437", "replace")

    def sprintf(self, to: Pointer, format: Any, *values: Any) -> int:
        data = self._format(format, values)
        write_text(to, data)
        return len(data)

    def fprintf(self, stream: Any, format: Any, *values: Any) -> int:
        return self.printf(format, *values)

    def puts(self, s: Any) -> int:
        self._program.print(characters(s) + b"\n")
        return 0

    def cputs(self, s: Any) -> int:
        data = characters(s)
        self._program.put(data)
        return data[-1] if data else 0

    def fputs(self, s: Any, stream: Any) -> int:
        self._program.print(characters(s))
        return 0

    def putchar(self, c: int) -> int:
        self._program.print(bytes([c & 0xFF]))
        return c

    def putch(self, c: int) -> int:
        self._program.put(bytes([c & 0xFF]))
        return c

    def fputc(self, c: int, stream: Any) -> int:
        return self.putchar(c) & 0xFF

    putc = fputc

    def perror(self, s: Any) -> None:
        self._program.print(characters(s) + b": Error\n")

    # Reading

    def scanf(self, format: Any, *to: Any) -> int:
        return self.scan(self._pc, characters(format), to, typed=True)

    cscanf = scanf

    def fscanf(self, stream: Any, format: Any, *to: Any) -> int:
        return self.scanf(format, *to) if stream is not None else EOF

    def sscanf(self, source: Any, format: Any, *to: Any) -> int:
        text = StringSource(characters(source).decode("cp437"))
        return self.scan(text, characters(format), to)

    def scan(self, source: Any, format: bytes, to: tuple[Any, ...], typed: bool = False) -> int:
        """Read by a format; how many values were stored."""
        recorder = TypedRecord(source)
        reader = Reader(recorder)
        stored = 0
        targets = iter(to)
        for part in parts_of(format.decode("cp437")):
            recorder.text = ""
            value = part.read(reader)
            if value is None:
                return EOF if stored == 0 and reader.ended and not reader.taken else stored
            if part.stores:
                text = recorder.text if part.letter in "c[" else recorder.text.lstrip(WHITE)
                _store(next(targets), part.letter, part.size, value)
                stored += part.letter != "n"
                if typed:
                    self._program.read(text.encode("cp437"))
        return stored

    def line(self, most: int, end: str = "\n", keep: bool = False) -> bytes:
        """A typed line of so many characters at most."""
        data = b""
        while len(data) < most:
            character = self._pc.getc()
            if not character or (character == end and not keep):
                break
            data += character.encode("cp437")
            if character == end:
                break
        self._program.read(data)
        return data

    def gets(self, to: Pointer) -> Pointer:
        write_text(to, self.line(999))
        return to

    def cgets(self, to: Pointer) -> Pointer:
        data = self.line(to.memory[to.at] - 1)
        to.memory[to.at + 1] = len(data)
        write_text(to + 2, data)
        return to + 2

    def fgets(self, to: Pointer, n: int, stream: Any) -> Pointer | None:
        if stream is None:
            return None
        write_text(to, self.line(n - 1, keep=True))
        return to

    def getchar(self) -> int:
        character = self._pc.getc()
        if not character:
            return EOF
        code = character.encode("cp437")
        self._program.read(code)
        return code[0]

    def fgetc(self, stream: Any) -> int:
        return self.getchar() if stream is not None else EOF

    getc = fgetc

    # Files

    def fflush(self, stream: Any) -> int:
        return 0

    def flushall(self) -> int:
        return 5

    def fopen(self, name: Any, mode: Any) -> None:
        """No file is opened yet: as if there were none."""
        if self._program.trace:
            self._program.trace.call("fopen", (characters(name), characters(mode)), 0)

    def fclose(self, stream: Any) -> int:
        return 0 if stream is not None else -1

    def feof(self, stream: Any) -> int:
        return int(stream is None)


def _store(to: Pointer, letter: str, size: str, value: Any) -> None:
    """Store what a conversion has read."""
    if letter in "s[":
        write_text(to, value.encode("cp437"))
    elif letter == "c":
        for place, code in enumerate(value.encode("cp437")):
            to.memory[to.at + place] = code
    elif letter in "feEgG":
        real = float(value)
        to.memory[to.at] = real if size else struct.unpack("f", struct.pack("f", real))[0]
    elif "l" in size or letter == "D":
        to.memory[to.at] = (int(value) & 0xFFFFFFFF ^ 0x80000000) - 0x80000000
    elif isinstance(to.memory, bytearray):
        to.memory[to.at] = int(value) & 0xFF
    else:
        to.memory[to.at] = int(value) & 0xFFFF if letter in "uxXo" else low(value)


__all__ = ["DECLARATIONS", "NAMES", "TYPES", "StdioLibrary"]
