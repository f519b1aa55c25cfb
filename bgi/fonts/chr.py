"""Borland's stroked fonts, `.CHR` files: letters as pen strokes, so that they scale.

A file begins with `PK`, 08h 08h and a line for people that ends with 1Ah. A header names the font
and says where its block starts. The block holds the number of characters, the code of the first,
the heights of capitals and descenders, then three tables: where each character's strokes begin, how
wide each character is, and the strokes. A stroke is two bytes, `axxxxxxx byyyyyyy`: with bits
ab = 10 the pen moves to x, y; with 11 it draws there; 00 ends the character; 01 is never needed.
The coordinates are signed, y grows upward, and the letters stand on y = 0.
"""

import struct
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from bgi.constants import grInvalidFont

MAX_BYTES = 1 << 16
"""No font file is longer: its offsets have 16 bits."""

_SIGNATURE = b"PK\x08\x08"
_HEADER_SIZE = 0x80
_MAX_OPERATIONS = 1 << 15  # of all characters: a file may let many of them share one long tail
_HEADER = struct.Struct("<H4sH4B")  # header size, name, bytes after it, font and driver version
_BLOCK = struct.Struct("<cHxBHBbbb5x")  # '+', count, first, strokes' offset, scan, cap, base, dec


class FontError(ValueError):
    """A font cannot be loaded: `code` is Borland's error number."""

    def __init__(self, text: str, code: int = grInvalidFont) -> None:
        super().__init__(text)
        self.code = code


class Operation(NamedTuple):
    """One movement of the pen: to x, y, drawing or not."""

    draw: bool
    x: int
    y: int


@dataclass(frozen=True, eq=False)  # a font is equal to itself only: a quick key for caches
class StrokedFont:
    """A stroked font in its own units, which are pixels at size 4; y grows upward.

    `widths` and `strokes` begin with the character of code `first`; `cap` is the height above the
    baseline, `dec` the depth below it (negative).
    """

    name: str
    first: int
    cap: int
    dec: int
    widths: tuple[int, ...]
    strokes: tuple[tuple[Operation, ...], ...]

    @cached_property
    def every_width(self) -> tuple[int, ...]:
        """How far the pen advances after each of 256 characters; 0 outside the font."""
        return ((0,) * self.first + self.widths + (0,) * 256)[:256]

    def operations(self, code: int) -> tuple[Operation, ...]:
        """The character's strokes; none outside the font."""
        place = code - self.first
        return self.strokes[place] if 0 <= place < len(self.strokes) else ()

    @cached_property
    def longest(self) -> int:
        """The strokes of the character that has the most."""
        return max(map(len, self.strokes), default=0)


def parse(data: bytes) -> StrokedFont:
    """Read the bytes of a `.CHR` file; FontError says what is wrong with them."""
    _check(data[:4] == _SIGNATURE, "does not begin as a Borland font does")
    _check(len(data) <= MAX_BYTES, f"is longer than {MAX_BYTES} bytes")
    text_end = data.find(b"\x1a")
    _check(text_end >= 0, "has no header")
    _check(text_end + 1 + _HEADER.size <= len(data), "ends inside its header")
    start, name, size, *_ = _HEADER.unpack_from(data, text_end + 1)
    _check(start > text_end, "places its characters before its header")
    block = data[start : start + size]
    _check(len(block) == size and size >= _BLOCK.size, "ends before its characters do")

    kind, count, first, strokes_at, _, cap, _, dec = _BLOCK.unpack_from(block)
    _check(kind == b"+", "does not hold strokes")
    _check(0 < count <= 256 - first, f"claims {count} characters from code {first}")
    _check(cap > dec, f"has no height: {cap} above the line, {dec} below")
    tables_end = _BLOCK.size + 3 * count
    _check(tables_end <= strokes_at <= size, "places its strokes outside itself")
    offsets = struct.unpack_from(f"<{count}H", block, _BLOCK.size)
    return StrokedFont(
        name=name.rstrip(b"\0 ").decode("cp437"),
        first=first,
        cap=cap,
        dec=dec,
        widths=tuple(block[tables_end - count : tables_end]),
        strokes=_all_strokes(block[strokes_at:], offsets),
    )


def _check(good: bool, fault: str) -> None:
    if not good:
        raise FontError(f"The font file {fault}.")


def _all_strokes(data: bytes, offsets: tuple[int, ...]) -> tuple[tuple[Operation, ...], ...]:
    total = 0
    found: dict[int, tuple[Operation, ...]] = {}
    for offset in offsets:
        if offset not in found:
            found[offset] = _strokes(data, offset)
            total += len(found[offset])
            _check(total <= _MAX_OPERATIONS, f"has more than {_MAX_OPERATIONS} strokes")
    return tuple(found[offset] for offset in offsets)


def _strokes(data: bytes, offset: int) -> tuple[Operation, ...]:
    operations = []
    for place in range(offset, len(data) - 1, 2):
        first, second = data[place], data[place + 1]
        if first >> 7:
            operations.append(Operation(bool(second >> 7), _signed(first), _signed(second)))
        elif not second >> 7:
            return tuple(operations)
    raise FontError("The font file ends inside a character.")


def _signed(byte: int) -> int:
    """The number in the lower seven bits, -64..63."""
    return ((byte & 0x7F) ^ 0x40) - 0x40


def encode(font: StrokedFont, notice: str = "") -> bytes:
    """Write a font as a `.CHR` file; `notice` is a line for people in its beginning.

    Coordinates must lie within -64..63, widths within 0..255; the name has at most 4 characters.
    ValueError if something does not fit.
    """
    strokes, offsets = bytearray(), []
    for operations in font.strokes:
        offsets.append(len(strokes))
        for draw, x, y in operations:
            if not (-64 <= x <= 63 and -64 <= y <= 63):
                raise ValueError(f"{font.name}: {x}, {y} does not fit a stroke")
            strokes += bytes((0x80 | x & 0x7F, draw << 7 | y & 0x7F))
        strokes += b"\0\0"
    count = len(font.widths)
    strokes_at = _BLOCK.size + 3 * count
    block = _BLOCK.pack(b"+", count, font.first, strokes_at, 0, font.cap, 0, font.dec)
    if len(offsets) != count or _HEADER_SIZE + strokes_at + len(strokes) > MAX_BYTES:
        raise ValueError(f"{font.name}: too many strokes, or not a width for each character")
    block += struct.pack(f"<{count}H", *offsets) + bytes(font.widths) + strokes
    name = font.name.encode("cp437")
    header = _SIGNATURE + f"BGI Stroked Font V1.1\r\n{notice}\r\n".encode("ascii") + b"\x1a"
    header += _HEADER.pack(_HEADER_SIZE, name, len(block), 1, 0, 1, 0)
    if len(header) > _HEADER_SIZE or len(name) > 4:
        raise ValueError(f"{font.name}: the name or the notice is too long")
    return header.ljust(_HEADER_SIZE, b"\0") + block
