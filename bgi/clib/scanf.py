"""scanf's format language as Turbo C++ 3.0 had it.

White space in a format skips any in the input; `%[*][width][size]letter` reads a field, which goes
nowhere with a `*`; any other character must come next. Sizes are `h l L F N`, letters `d D i I o O
u U x X e E f g G s c p n`, and a set such as `[a-z]` or `[^,]`; `%%` stands for a percent sign.

A format says how many values there are, whatever the input is. What could not be read is None.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from bgi.clib.bits import signed, unsigned
from bgi.clib.reading import WHITE, Reader, Source, StringSource, read_real, read_whole
from bgi.clib.strings import c_string

EOF = -1
"""What C returns when the input has ended before anything was read."""

LONGEST = 32767
"""The largest width, and that of a field which says none: an int of Turbo C."""

_DIRECTIVE = re.compile(
    r"(?P<white>[ \t\n\v\f\r]++)"
    r"|(?P<literal>[^%]|%%)"
    r"|%(?P<star>\*?)(?P<width>[0-9]*+)(?P<size>[hlLFN]*+)"
    r"(?:(?P<letter>[dDiIoOuUxXeEfgGscpn])|(?P<set>\[\^?+\]?+[^\]]*+\]))"
)


class Scanned(NamedTuple):
    """What a call of scanf has read."""

    values: tuple[Any, ...]
    """One for each conversion that stores one; None for those that were not reached."""
    stored: int
    """What C returns: how many conversions were stored, those of %n apart; or EOF."""

    def returned(self) -> Any:
        """What Python returns: the value if a format has one, otherwise all of them."""
        return self.values[0] if len(self.values) == 1 else self.values


def sscanf(text: str | bytes, format_string: str | bytes) -> Any:
    """Read numbers and words from a text, by a format: `x, y = sscanf("3 4", "%d%d")`.

    Args:
        text: where to read; bytes are in code page 437.
        format_string: what to read, a conversion such as `%d` or `%s` for each value.

    Returns what C stores through pointers: a tuple of as many values as the format has conversions,
    or the value itself where it has one, as in `n = sscanf("42", "%d")`. What could not be read is
    None, because the text has ended or something else stands there.

    Numbers are int or float, all others str. A `%d` may be of any size, a `%hd` keeps 16 bits, and
    so does a `%u`, `%x` or `%o` below zero, which loses its sign. TypeError for anything but texts,
    ValueError for what is no format.
    """
    source = StringSource(c_string("the text", text))
    return scan(source, format_string).returned()


def scan(source: Source, format_string: str | bytes) -> Scanned:
    """Read from wherever characters come from.

    Args:
        source: gives one character at a time, and takes the last one back.
        format_string: as for sscanf().
    """
    directives = parts_of(c_string("the format", format_string))
    reader = Reader(source)
    values: list[Any] = []
    stored = 0
    for directive in directives:
        value = directive.read(reader)
        if value is None:
            if stored == 0 and reader.ended and not reader.taken:
                stored = EOF
            break
        if directive.stores:
            values.append(value)
            stored += directive.letter != "n"
    missing = sum(directive.stores for directive in directives) - len(values)
    return Scanned((*values, *[None] * missing), stored)


@dataclass
class _Directive:
    """A part of a format: a field, white space, or a character that must come."""

    letter: str
    """Of a conversion; `[` for a set, a space for white space, `%` for a character."""
    characters: str = ""
    """The character, or the set as it is written."""
    stores: bool = False
    width: int = LONGEST
    size: str = ""

    def read(self, reader: Reader) -> Any:
        """Its value, or None if the input has something else."""
        if self.letter not in "c[n%":
            reader.skip_white()
        reader.begin(self.width)
        return _READERS[self.letter](self, reader)


def parts_of(format_string: str) -> list[_Directive]:
    """The parts of a format; ValueError if it has others."""
    found: list[_Directive] = []
    position = 0
    while position < len(format_string):
        part = _DIRECTIVE.match(format_string, position)
        if part is None:
            raise ValueError(
                f"{format_string[position:][:20]!r} begins with no conversion of scanf"
            )
        found.append(_directive(part))
        position = part.end()
    return found


def _directive(part: re.Match[str]) -> _Directive:
    if part["white"]:
        return _Directive(" ")
    if part["literal"]:
        return _Directive("%", part["literal"][0])
    letter = part["letter"] or "["
    width = 1 if letter == "c" else LONGEST
    if part["width"]:
        digits = part["width"].lstrip("0")
        width = int(digits) if 0 < len(digits) < 6 else 0
        if not 0 < width <= LONGEST:
            raise ValueError(f"the width of {part[0]:.40} must be 1 to {LONGEST:,}")
    size = part["size"] + "l" * (letter in "DIOU")
    return _Directive(letter, part["set"] or "", not part["star"], width, size)


# What reads the fields


def _white(directive: _Directive, reader: Reader) -> str:
    """White space, of which there may be none."""
    return ""


def _literal(directive: _Directive, reader: Reader) -> str | None:
    """A character that must come."""
    return reader.take(directive.characters.__eq__) or None


def _decimal(directive: _Directive, reader: Reader) -> int | None:
    """%d and %i."""
    number = read_whole(reader, 0 if directive.letter in "iI" else 10)
    return signed(number, 16) if number is not None and "h" in directive.size else number


def _unsigned(directive: _Directive, reader: Reader) -> int | None:
    """%u, %o and %x."""
    number = read_whole(reader, {"u": 10, "o": 8, "x": 16}[directive.letter.lower()])
    if number is None:
        return None
    number = unsigned(number, 32 if "l" in directive.size else 16)
    return number & 0xFFFF if "h" in directive.size else number


def _real(directive: _Directive, reader: Reader) -> float | None:
    """%f, %e and %g."""
    return read_real(reader)


def _word(directive: _Directive, reader: Reader) -> str | None:
    """%s: up to white space."""
    return reader.take_all(lambda character: character not in WHITE) or None


def _characters(directive: _Directive, reader: Reader) -> str | None:
    """%c: so many characters, whatever they are."""
    found = reader.take_all(lambda character: True)
    return found if len(found) == directive.width else None


def _set(directive: _Directive, reader: Reader) -> str | None:
    """%[...]: characters of a set, or with ^ of all others."""
    inside = directive.characters[1:-1]
    others = inside.startswith("^")
    members = _members(inside[others:])
    return reader.take_all(lambda character: (character in members) != others) or None


def _members(written: str) -> set[str]:
    """The characters of a set; `a-z` is a range if it ascends."""
    found: set[str] = set()
    for part in re.findall(r"(?s).-.|.", written):
        ascends = len(part) == 3 and part[0] <= part[2]
        found.update(map(chr, range(ord(part[0]), ord(part[2]) + 1)) if ascends else part)
    return found


def _pointer(directive: _Directive, reader: Reader) -> int | None:
    """%p: an address as printf writes it, far or near."""
    number = read_whole(reader, 16)
    if number is not None and reader.take(":".__eq__):
        number = (number << 16) + (read_whole(reader, 16) or 0)
    return number


def _count(directive: _Directive, reader: Reader) -> int:
    """%n: how many characters have been read."""
    return reader.count


_READERS: dict[str, Callable[[_Directive, Reader], Any]] = {
    " ": _white,
    "%": _literal,
    **dict.fromkeys("dDiI", _decimal),
    **dict.fromkeys("uUoOxX", _unsigned),
    **dict.fromkeys("eEfgG", _real),
    "s": _word,
    "c": _characters,
    "[": _set,
    "p": _pointer,
    "n": _count,
}
