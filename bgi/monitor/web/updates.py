"""From one picture to the next, as messages of bytes: colours, and the rows that have changed.

A message of colours is the byte 1 and the palette: red, green, blue of each index. One of rows is
the byte 2, the bytes of a pixel (1 or 4), width, height, the first row and how many follow (numbers
of two bytes, little-endian), whether pixels are square, a zero, and the rows' pixels as the card
has them (`bgi.memory.card`). Each picture ends with a message of rows, if only of none.

The board (`bgi.monitor.board`) is the byte 3, a zero, its width and height (numbers of two bytes)
and red, green, blue of each of its pixels.
"""

import functools
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.memory.card import Frame
from bgi.monitor.picture import pixels

COLORS, ROWS, BOARD = 1, 2, 3
_HEADER = struct.Struct("<BB4HBx")
_BOARD_HEADER = struct.Struct("<Bx2H")


@dataclass(eq=False)
class Still:
    """What is to be seen at a moment."""

    frame: Frame
    palette: bytes

    @functools.cached_property
    def pixels(self) -> NDArray[Any]:
        """The numbers of its pixels, shape (height, width)."""
        return pixels(self.frame)

    @property
    def shape(self) -> tuple[int, int, int, bool]:
        """What makes a page forget all that it has."""
        height, width = self.pixels.shape
        return width, height, self.pixels.itemsize, self.frame.square


@functools.lru_cache(maxsize=4)  # many pages go from the same picture to the same
def between(old: Still | None, new: Still) -> tuple[bytes, ...]:
    """The messages that make `new` of `old`; of nothing, if there was no picture."""
    rows = _rows(new, *_changed(old, new))
    if old is not None and old.palette == new.palette:
        return (rows,)
    return bytes((COLORS,)) + new.palette, rows


def _changed(old: Still | None, new: Still) -> tuple[int, int]:
    """The first row that has changed, and the first after the last one."""
    if old is None or old.shape != new.shape:
        return 0, len(new.pixels)
    touched = np.flatnonzero((old.pixels != new.pixels).any(axis=1))
    return (int(touched[0]), int(touched[-1]) + 1) if len(touched) else (0, 0)


def _rows(picture: Still, first: int, end: int) -> bytes:
    width, height, size, square = picture.shape
    header = _HEADER.pack(ROWS, size, width, height, first, end - first, square)
    return header + picture.pixels[first:end].tobytes()


def board_message(picture: NDArray[np.uint8]) -> bytes:
    """The message that shows the board."""
    height, width, _ = picture.shape
    return _BOARD_HEADER.pack(BOARD, width, height) + picture.tobytes()
