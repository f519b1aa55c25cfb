"""What a ported program brings with it, if it needs that: what C has and Python has not."""

from __future__ import annotations

from bgi.turboc.checker.scopes import Namer
from bgi.turboc.port.pycode import Code

_TEXTS = {
    "Pointer": '''
class Pointer:
    """A place in a list, as a pointer of C: p + 1 is the next one."""

    def __init__(self, items, at=0):
        self.items = items
        self.at = at

    def __getitem__(self, index):
        return self.items[self.at + index]

    def __setitem__(self, index, value):
        self.items[self.at + index] = value

    def __add__(self, count):
        return Pointer(self.items, self.at + count)

    def __sub__(self, other):
        if isinstance(other, Pointer):
            return self.at - other.at
        return Pointer(self.items, self.at - other)

    def __eq__(self, other):
        return other is not None and self.items is other.items and self.at == other.at

    def __lt__(self, other):
        return self.at < other.at

    def __le__(self, other):
        return self.at <= other.at

    def __gt__(self, other):
        return self.at > other.at

    def __ge__(self, other):
        return self.at >= other.at
''',
    "text": '''
def text(characters):
    """The string in an array of characters, up to the zero that ends it."""
    if hasattr(characters, "items"):
        characters = characters.items[characters.at :]
    return bytes(code & 0xFF for code in characters).partition(b"\\0")[0].decode("cp437")
''',
    "store_text": '''
def store_text(characters, string):
    """Write a string into an array of characters, with a zero behind it."""
    codes = string.encode("cp437") + b"\\0"
    start = getattr(characters, "at", 0)
    items = characters.items if hasattr(characters, "items") else characters
    items[start : start + len(codes)] = codes
''',
    "char_at": '''
def char_at(string, index):
    """The code of a character; 0 behind the last one, as in C."""
    return ord(string[index]) if index < len(string) else 0
''',
    "compare": '''
def compare(a, b):
    """Which of two strings comes first: below 0, 0 or above 0, as strcmp() says it."""
    return (a > b) - (a < b)
''',
    "int16": '''
def int16(number):
    """A number as an int of 16 bits holds it: 32,768 is -32,768."""
    return (number + 0x8000) % 0x10000 - 0x8000
''',
    "open_file": '''
def open_file(name, mode):
    """A file of this folder; None if it cannot be opened."""
    name = name.replace("\\\\", "/").rpartition("/")[2]
    try:
        return open(name, mode, encoding=None if "b" in mode else "cp437")
    except OSError:
        return None
''',
    "open_or_empty": '''
def open_or_empty(name, mode):
    """A file of this folder; an empty one in memory if it cannot be opened."""
    name = name.replace("\\\\", "/").rpartition("/")[2]
    try:
        return open(name, mode, encoding=None if "b" in mode else "cp437")
    except OSError:
        return BytesIO() if "b" in mode else StringIO()
''',
    "next_code": '''
def next_code(file):
    """The code of the next character of a file; -1 at its end, as in C."""
    letter = file.read(1)
    return ord(letter) if letter else -1
''',
    "next_int": '''
def next_int(file):
    """The next 16 bits of a file as an int; -1 at its end, as in C."""
    data = file.read(2)
    return struct.unpack("<h", data)[0] if len(data) == 2 else -1
''',
    "busy": '''
def busy(turns):
    """Wait as long as a PC of 1990 took for an empty loop of so many turns."""
    sleep(max(turns, 0) * 8 / 33e6)
''',
    "float32": '''
def float32(number):
    """A number as a float of C holds it: in 32 bits, with some 7 digits."""
    return struct.unpack("f", struct.pack("f", number))[0]
''',
    "rounded": '''
def rounded(number):
    """The nearest whole number; a half goes away from 0, as in C."""
    return int(number + 0.5) if number >= 0 else -int(0.5 - number)
''',
}

_MODULES = {"float32": "struct", "next_int": "struct"}
"""The modules that they need."""

_FILES = "Files are opened in the folder that the program is started in; of a path the name counts."

_NOTES = {
    "busy": "Loops that did nothing but wait are busy() here; delay() would say how long.",
    "int16": "Where int16() stands, C may have cut a number off at 32,767.",
    "float32": "Where float32() stands, C lost digits that are seen, if only some steps later.",
    **dict.fromkeys(("open_file", "open_or_empty"), _FILES),
    "Pointer": "Pointers that walk through arrays are a class here, Pointer.",
}
"""What a reader has to know of what changed."""


class Helpers:
    """The helpers of one program."""

    def __init__(self, namer: Namer) -> None:
        self._namer = namer
        self._names: dict[str, str] = {}

    def use(self, name: str) -> Code:
        """A helper's name, which then is defined."""
        if name not in self._names:
            self._names[name] = self._namer.name(name)
        return Code(self._names[name])

    @property
    def modules(self) -> set[str]:
        """The modules that they need."""
        return {_MODULES[name] for name in self._names if name in _MODULES}

    def notes(self) -> list[str]:
        """What the head of the program tells of them."""
        return [note for name, note in _NOTES.items() if name in self._names]

    def lines(self) -> list[str]:
        """Their definitions, each with two blank lines before it."""
        found: list[str] = []
        for name, wanted in self._names.items():
            text = _TEXTS[name]
            if wanted != name:
                text = text.replace(f" {name}(", f" {wanted}(").replace(f"{name}:", f"{wanted}:")
            found += ["", *text.rstrip().split("\n")]
        return found
