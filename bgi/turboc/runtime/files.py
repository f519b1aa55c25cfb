"""C's files: the keyboard, the screen, and files of the program's folder; all a byte at a time."""

from __future__ import annotations

from typing import IO, Any

from bgi.turboc.runtime.session import Session

EOF = -1
CTRL_Z = 26
"""Ends a text of DOS."""


class File:
    """What can be read or written; here nothing can."""

    typed = False
    """Whether it is read as it is typed."""

    def __init__(self) -> None:
        self._back: list[int] = []
        self.ended = False
        """Whether somebody has read beyond the end."""
        self.failed = False

    def getc(self) -> int:
        """The next byte, or EOF."""
        if self._back:
            return self._back.pop()
        code = self.next()
        self.ended = self.ended or code == EOF
        return code

    def ungetc(self, code: int) -> int:
        """Let a byte come again."""
        if code != EOF:
            self._back.append(code & 0xFF)
        return code

    def next(self) -> int:
        """The next byte of where they come from, or EOF."""
        return EOF

    def read(self, count: int) -> bytes:
        """So many bytes, fewer at the end."""
        data = bytearray()
        while len(data) < count and (code := self.getc()) != EOF:
            data.append(code)
        return bytes(data)

    def write(self, data: bytes) -> bool:
        """Write bytes; whether that was possible."""
        self.failed = True
        return False

    def seek(self, offset: int, whence: int) -> bool:
        """Go to a place; whether that was possible."""
        return False

    def tell(self) -> int:
        """The place, or -1."""
        return -1

    def size(self) -> int:
        """How many bytes there are, or -1."""
        return -1

    def clear(self) -> None:
        """Forget the end, and what has failed."""
        self.ended = self.failed = False

    def close(self) -> bool:
        """Close it; whether it was open."""
        return True


class Keyboard(File):
    """What is typed."""

    typed = True

    def __init__(self, program: Session) -> None:
        super().__init__()
        self._pc = program.pc

    def next(self) -> int:
        """The next byte that is typed."""
        character = self._pc.getc()
        return character.encode("cp437")[0] if character else EOF


class ScreenFile(File):
    """The screen: standard output, errors, and the printer."""

    def __init__(self, program: Session) -> None:
        super().__init__()
        self._program = program

    def write(self, data: bytes) -> bool:
        """Print bytes."""
        self._program.print(data)
        return True


class DiskFile(File):
    """An open file of the program's folder."""

    def __init__(self, data: IO[bytes], text: bool, reads: bool, writes: bool, adds: bool) -> None:
        """
        Args:
            data: its bytes.
            text: whether lines end with CR LF there, which a program sees as LF.
            reads, writes: what may be done.
            adds: whether all that is written goes to the end.
        """
        super().__init__()
        self._data, self._text, self._adds = data, text, adds
        self._reads, self._writes = reads, writes
        self._writing = False
        data.seek(0, 2 if adds else 0)

    def _switch(self, writing: bool) -> bool:
        """Between reading and writing; whether the file is open for that."""
        if self._data.closed or not (self._writes if writing else self._reads):
            self.failed = True
            return False
        if writing != self._writing:
            self._data.seek(self.tell())
            self._back.clear()
            self._writing = writing
        return True

    def next(self) -> int:
        """The next byte."""
        if not self._switch(False):
            return EOF
        code = self._data.read(1)
        if not self._text or code not in (b"\r", b"\x1a"):
            return code[0] if code else EOF
        if code == b"\x1a":
            self._data.seek(-1, 1)
            return EOF
        after = self._data.read(1)
        if after and after != b"\n":
            self._data.seek(-1, 1)
        return 10 if after == b"\n" else 13

    def read(self, count: int) -> bytes:
        """So many bytes, fewer at the end."""
        if self._text or self._back or not self._switch(False):
            return super().read(count)
        data = self._data.read(count)
        self.ended = self.ended or len(data) < count
        return data

    def write(self, data: bytes) -> bool:
        """Write bytes; whether that was possible."""
        if not self._switch(True):
            return False
        if self._adds:
            self._data.seek(0, 2)
        self._data.write(data)
        return True

    def seek(self, offset: int, whence: int) -> bool:
        """Go to a place; whether that was possible."""
        if self._data.closed:
            return False
        start = (0, self.tell(), self.size())[whence] if 0 <= whence <= 2 else -1
        if start < 0 or start + offset < 0:
            return False
        self._back.clear()
        self.ended = False
        self._data.seek(start + offset)
        return True

    def tell(self) -> int:
        """The place, or -1."""
        return -1 if self._data.closed else self._data.tell() - len(self._back)

    def size(self) -> int:
        """How many bytes there are, or -1."""
        if self._data.closed:
            return -1
        here = self._data.tell()
        size = self._data.seek(0, 2)
        self._data.seek(here)
        return size

    def close(self) -> bool:
        """Close it; whether it was open."""
        if self._data.closed:
            return False
        self._data.close()
        return True


class Characters:
    """A file's characters, for what reads fields of them; `text` is what was taken."""

    def __init__(self, file: Any) -> None:
        self._file = file
        self.text = ""

    def getc(self) -> str:
        """The next character, or an empty str at the end."""
        code = self._file.getc()
        if code == EOF:
            return ""
        character = bytes([code]).decode("cp437")
        self.text += character
        return character

    def ungetc(self, character: str) -> None:
        """Take the last character back."""
        self._file.ungetc(character.encode("cp437")[0])
        self.text = self.text[:-1]
