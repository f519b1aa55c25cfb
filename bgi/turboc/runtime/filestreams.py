"""fstream.h, strstrea.h and constrea.h: streams of files, of strings, and of the text screen."""

from __future__ import annotations

from typing import Any, ClassVar

from bgi import conio
from bgi.turboc.runtime.filelib import FileLibrary
from bgi.turboc.runtime.files import EOF, File
from bgi.turboc.runtime.manipulators import APPEND, AT_END, EMPTY, FAILED, IN, NO_CREATE, OUT
from bgi.turboc.runtime.memory import Pointer
from bgi.turboc.runtime.stdiolib import StdioLibrary
from bgi.turboc.runtime.streambase import ios
from bgi.turboc.runtime.streams import READING, WRITING, istream, ostream

_OPENING = """@(); @(text name); @(text name, int mode); @(text name, int mode, int access);
void open(text name); void open(text name, int mode); void open(text name, int mode, int access);
void close(); int is_open(); ~@();"""

_BOTH = READING.replace("@", "iostream") + WRITING.replace("@", "iostream")

TYPES = {
    "iostream": f"class @ : public ios {{ public: {_BOTH} }};",
    "ifstream": f"class @ : public istream {{ public: {_OPENING} }};",
    "ofstream": f"class @ : public ostream {{ public: {_OPENING} }};",
    "fstream": f"class @ : public iostream {{ public: {_OPENING} }};",
    "istrstream": "class @ : public istream { public: @(char *s); @(char *s, int n); };",
    "ostrstream": """class @ : public ostream { public: @(); @(char *s, int n);
        @(char *s, int n, int mode); char *str(); int pcount(); void freeze(int on); };""",
    "constream": """class @ : public ostream { public: @(); void clrscr();
        void window(int left, int top, int right, int bottom); void textmode(int mode); };""",
}


class iostream(istream, ostream):
    """Both at once."""

    __slots__ = ()


class _Opened(ios):
    """What streams of files have: a file by name."""

    __slots__ = ()
    MODE = 0
    files: ClassVar[FileLibrary]

    def open(self, name: Any, mode: int = 0, access: int = 0) -> None:
        mode |= self.MODE
        both = mode & IN and mode & OUT
        how = ("w+b" if mode & EMPTY else "r+b") if both else "wb" if mode & OUT else "rb"
        self.file = self.files.fopen(name, b"ab" if mode & APPEND else how.encode())
        if self.file is None and both and not mode & (NO_CREATE | APPEND):
            self.file = self.files.fopen(name, b"w+b")
        self.clear(FAILED if self.file is None else 0)
        if self.file is not None and mode & AT_END:
            self.file.seek(0, 2)

    def construct(self, *given: Any) -> Any:
        """The constructor of C++."""
        if given:
            self.open(*given)
        return self

    ifstream = ofstream = fstream = construct

    def close(self) -> None:
        self.files.fclose(self.file)
        self.file = None

    destroy_ = close

    def is_open(self) -> int:
        return int(self.file is not None)


class ifstream(_Opened, istream):
    """A file to read."""

    __slots__ = ()
    MODE = IN


class ofstream(_Opened, ostream):
    """A file to write."""

    __slots__ = ()
    MODE = OUT


class fstream(_Opened, iostream):
    """A file to read and write."""

    __slots__ = ()


class StringFile(File):
    """Characters in the memory of the program."""

    def __init__(self, to: Pointer, room: int) -> None:
        super().__init__()
        self._memory, self._begin, self.place, self._room = to.memory, to.at, 0, room

    def next(self) -> int:
        """The next character."""
        if self.place >= self._room:
            return EOF
        self.place += 1
        return int(self._memory[self._begin + self.place - 1])

    def write(self, data: bytes) -> bool:
        """Write as many as there is room for."""
        for code in data:
            if self.place < self._room:
                self._memory[self._begin + self.place] = code
                self.place += 1
        return self.place < self._room


class istrstream(istream):
    """Reads from a string."""

    __slots__ = ()

    def istrstream(self, s: Pointer, n: int = 0) -> Any:
        """The constructor of C++."""
        end = s.memory.find(0, s.at)
        whole = (end if end >= 0 else len(s.memory)) - s.at
        self.file = StringFile(s, n if n > 0 else whole)
        return self


class ostrstream(ostream):
    """Writes into a string."""

    __slots__ = ("_to",)
    GROWN = 4096
    """Bytes of one that has none given."""

    def ostrstream(self, s: Pointer | None = None, n: int = GROWN, mode: int = 0) -> Any:
        """The constructor of C++."""
        self._to = s if s is not None else Pointer(bytearray(n))
        self.file = StringFile(self._to, n)
        return self

    def str(self) -> Pointer:
        return self._to

    def pcount(self) -> int:
        assert isinstance(self.file, StringFile)
        return self.file.place

    def freeze(self, on: int) -> None:
        """It stays where it is."""


class constream(ostream):
    """The text screen."""

    __slots__ = ()

    def constream(self) -> Any:
        """The constructor of C++."""
        self.file = self.library.screen
        return self

    clrscr = staticmethod(conio.clrscr)
    window = staticmethod(conio.window)
    textmode = staticmethod(conio.textmode)


_CLASSES = (ifstream, ofstream, fstream, istrstream, ostrstream, constream)


def classes(stdio: StdioLibrary, files: FileLibrary) -> dict[str, Any]:
    """The classes for one program, by what its Python calls them."""

    def made(cls: type) -> type:
        def begin(self: Any) -> None:
            cls.__init__(self, stdio)  # type: ignore[misc]

        return type(cls.__name__, (cls,), {"__slots__": (), "__init__": begin, "files": files})

    return {f"struct_{cls.__name__}": made(cls) for cls in _CLASSES}
