"""The first picture of a GIF file, read here: the reader in SDL's image library can crash.

A GIF is a screen with a palette, then blocks. A picture lies somewhere on that screen, has perhaps
a palette of its own and is packed by LZW (Welch 1984): codes of growing width, each standing for a
string of pixels seen before. Source: the specification GIF89a.
"""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

_TRANSPARENT = 1  # a bit of the graphic control extension
_OWN_PALETTE, _INTERLACED = 0x80, 0x40  # bits of a picture's head
_PASSES = ((0, 8), (4, 8), (2, 4), (1, 2))  # first row and step of an interlaced picture's passes
_WIDEST = 12  # bits of a code...
_MOST_CODES = 1 << _WIDEST  # ... of which there are so many


def size(data: bytes) -> tuple[int, int]:
    """Width and height of the screen; ValueError if the head is cut short."""
    if len(data) < 13:
        raise ValueError("it ends too soon")
    width, height = struct.unpack_from("<HH", data, 6)
    return width, height


def read(data: bytes) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """The first picture: indices (height, width) of the screen, and colours (256, 4) with alpha.

    What the picture does not cover is transparent. ValueError if the data are no such file.
    """
    width, height = size(data)
    at = 13
    palette, at = _palette(data, at, data[10])
    transparent = None
    while True:
        kind, at = _byte(data, at), at + 1
        if kind == 0x21:  # an extension
            label, at = _byte(data, at), at + 1
            body, at = _blocks(data, at)
            if label == 0xF9 and len(body) >= 4:
                transparent = body[3] if body[0] & _TRANSPARENT else None
        elif kind == 0x2C:
            break
        else:
            raise ValueError("it holds no picture")
    if len(data) < at + 10:
        raise ValueError("it ends too soon")
    left, top, wide, high, flags = struct.unpack_from("<HHHHB", data, at)
    if not (wide and high and left + wide <= width and top + high <= height):
        raise ValueError("its picture does not lie on its screen")
    own, at = _palette(data, at + 9, flags)
    colors = palette if own is None else own
    body, _ = _blocks(data, at + 1)
    packed = _unpacked(body, _byte(data, at), wide * high)
    rows = np.frombuffer(packed, np.uint8).reshape(high, wide)
    if flags & _INTERLACED:
        order = [row for first, step in _PASSES for row in range(first, high, step)]
        rows = rows[np.argsort(order)]
    return _on_screen(rows, left, top, (height, width), colors, transparent)


def _on_screen(
    rows: NDArray[np.uint8],
    left: int,
    top: int,
    shape: tuple[int, int],
    palette: NDArray[np.uint8] | None,
    transparent: int | None,
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    if palette is None:
        raise ValueError("it has no palette")
    colors = np.full((256, 4), 255, np.uint8)
    colors[:, :3] = 0
    colors[: len(palette), :3] = palette
    if transparent is not None:
        colors[transparent, 3] = 0
    if rows.shape == shape:
        return rows, colors
    unused = np.setdiff1d(np.arange(256), rows)
    if not len(unused):
        raise ValueError("it uses all colours, and covers a part of its screen")
    colors[unused[0], 3] = 0
    screen = np.full(shape, unused[0], np.uint8)
    screen[top : top + rows.shape[0], left : left + rows.shape[1]] = rows
    return screen, colors


def _byte(data: bytes, at: int) -> int:
    if at >= len(data):
        raise ValueError("it ends too soon")
    return data[at]


def _palette(data: bytes, at: int, flags: int) -> tuple[NDArray[np.uint8] | None, int]:
    """The palette that begins here if the flags say so, and where it ends."""
    if not flags & _OWN_PALETTE:
        return None, at
    end = at + 3 * (2 << (flags & 7))
    if end > len(data):
        raise ValueError("it ends too soon")
    return np.frombuffer(data[at:end], np.uint8).reshape(-1, 3), end


def _blocks(data: bytes, at: int) -> tuple[bytes, int]:
    """The contents of a chain of blocks, each after its length, up to an empty one."""
    parts = []
    while length := _byte(data, at):
        parts.append(data[at + 1 : at + 1 + length])
        at += 1 + length
    return b"".join(parts), at + 1


def _unpacked(packed: bytes, bits: int, wanted: int) -> bytes:
    """Undo LZW: exactly so many pixels.

    Codes are read the lowest bit first. They are as wide as the table needs, one bit more than
    pixels at first; the two after the pixels begin a new table and end the picture.
    """
    if not 1 <= bits <= 8:
        raise ValueError("its pixels are packed in an unknown way")
    clear, end = 1 << bits, (1 << bits) + 1
    first = [bytes([value]) for value in range(clear)] + [b"", b""]
    table, before, width = first.copy(), b"", bits + 1
    parts: list[bytes] = []
    length = held = count = 0
    for byte in packed:
        held |= byte << count
        count += 8
        while count >= width:
            code = held & (1 << width) - 1
            held >>= width
            count -= width
            if code == clear:
                table, before, width = first.copy(), b"", bits + 1
                continue
            if code == end:
                raise ValueError("it ends too soon")
            string = _string(table, code, before)
            if before and len(table) < _MOST_CODES:
                table.append(before + string[:1])
                width += len(table) == 1 << width and width < _WIDEST
            before = string
            parts.append(string)
            length += len(string)
            if length >= wanted:
                return b"".join(parts)[:wanted]
    raise ValueError("it ends too soon")


def _string(table: list[bytes], code: int, before: bytes) -> bytes:
    """What a code stands for, after the string `before`; it may be the one about to be added."""
    string = b""
    if code < len(table):
        string = table[code]
    elif code == len(table):
        string = before + before[:1]
    if not string:
        raise ValueError("its pixels make no sense")
    return string
