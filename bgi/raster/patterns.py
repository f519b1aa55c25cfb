"""Line styles and fill patterns: Borland's tables, and how their bits are read.

A line pattern is sixteen bits, one for each step along the line, read from the lowest bit upward. A
fill pattern is eight rows of eight bits, the highest bit leftmost, anchored to the screen: the bit
for a pixel is row `y & 7`, bit `0x80 >> (x & 7)` of its absolute coordinates, so that neighbouring
fills join without a seam. (Of some drivers the first bit of a line is the highest, and the fills of
some modes begin in the middle of a byte: then the bits are rearranged before they come here.)
"""

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

LINE_PATTERNS = [0xFFFF, 0xCCCC, 0xFC78, 0xF8F8]
"""SOLID_LINE, DOTTED_LINE, CENTER_LINE, DASHED_LINE; USERBIT_LINE brings its own."""
SOLID_BITS = LINE_PATTERNS[0]

FILL_PATTERNS = [
    bytes.fromhex(rows)
    for rows in (
        "00 00 00 00 00 00 00 00",  # EMPTY_FILL
        "FF FF FF FF FF FF FF FF",  # SOLID_FILL
        "FF FF 00 00 FF FF 00 00",  # LINE_FILL
        "01 02 04 08 10 20 40 80",  # LTSLASH_FILL
        "E0 C1 83 07 0E 1C 38 70",  # SLASH_FILL
        "F0 78 3C 1E 0F 87 C3 E1",  # BKSLASH_FILL
        "A5 D2 69 B4 5A 2D 96 4B",  # LTBKSLASH_FILL: not the mirror image of LTSLASH_FILL
        "FF 88 88 88 FF 88 88 88",  # HATCH_FILL
        "81 42 24 18 18 24 42 81",  # XHATCH_FILL
        "CC 33 CC 33 CC 33 CC 33",  # INTERLEAVE_FILL
        "80 00 08 00 80 00 08 00",  # WIDE_DOT_FILL
        "88 00 22 00 88 00 22 00",  # CLOSE_DOT_FILL
    )
]


EMPTY_ROWS = FILL_PATTERNS[0]
SOLID_ROWS = FILL_PATTERNS[1]

_MAX_LENGTH = 1 << 12
"""Pixels: as many as a line can have on any page."""


def highest_first(pattern: int) -> int:
    """The line pattern whose bits come in the other order."""
    return int(f"{pattern:016b}"[::-1], 2)


def shifted_half(rows: bytes) -> bytes:
    """The fill pattern that begins four columns later."""
    return bytes(row << 4 & 0xF0 | row >> 4 for row in rows)


class Dashes(NamedTuple):
    """A line pattern, spelt out for the longest line there is."""

    bits: int
    drawn: NDArray[np.bool_]
    """Whether a step draws, counted from the line's beginning."""
    steps: NDArray[np.int64]
    """The steps that draw."""
    counts: memoryview
    """How many draw up to a step, itself included."""

    def upto(self, last: int) -> NDArray[np.int64]:
        """The steps that draw, up to the last one of a line."""
        return self.steps[: self.counts[last]]


@lru_cache(maxsize=64)
def dashes(bits: int) -> Dashes:
    """A line pattern by its bits."""
    drawn = np.tile((bits >> np.arange(16) & 1).astype(bool), _MAX_LENGTH // 16)
    return Dashes(bits, drawn, np.flatnonzero(drawn), drawn.cumsum(dtype=np.uint16).data)


SOLID = dashes(SOLID_BITS)


class Ink(NamedTuple):
    """A fill pattern in one colour, as wide as a page: what a fill copies."""

    block: NDArray[Any]
    """Its eight rows, twice: from each of them on eight follow one another."""
    rows: list[memoryview]
    """The eight rows, each in memory of its own."""


def ink(pattern: bytes, color: int, width: int, pixel: np.dtype[Any]) -> Ink:
    """A fill pattern in a colour, index 0 in its gaps."""
    bits = np.unpackbits(np.frombuffer(pattern, np.uint8).reshape(8, 1), axis=1)
    block = np.tile(bits, (2, -(-width // 8)))[:, :width].astype(pixel) * pixel.type(color)
    return Ink(block, [row.data for row in block[:8]])
