"""The built-in 8x8 font: 256 glyphs of code page 437 as the graphics driver shows them.

`data/font8x8.bin` holds eight bytes a glyph, top row first, the highest bit leftmost.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from bgi.fonts import read

CELL = 8
"""Width and height of a glyph at size 1, in pixels."""


@lru_cache(maxsize=2)
def _rows(turned: bool) -> NDArray[np.uint64]:
    """All glyphs, shape (CELL, 256): eight pixels, a byte each, are one number."""
    data = read("font8x8.bin")
    glyphs = np.unpackbits(np.frombuffer(data, np.uint8).reshape(256, CELL, 1), axis=2)
    if turned:
        glyphs = np.rot90(glyphs, axes=(1, 2))
    return np.ascontiguousarray(glyphs.transpose(1, 0, 2)).view(np.uint64)[..., 0]


_REMEMBERED = 1 << 16
"""Pixels of a mask that is kept: larger ones rarely come again."""


def mask(text: bytes, across: int, down: int, turned: bool = False) -> NDArray[np.bool_]:
    """The pixels of a string: True where it is drawn; every glyph pixel is across x down.

    Turned: each glyph lies on its back, in its own place.
    """
    small = len(text) * CELL * CELL * across * down <= _REMEMBERED
    return (_remembered if small else _mask)(text, across, down, turned)


def _mask(text: bytes, across: int, down: int, turned: bool) -> NDArray[np.bool_]:
    line = _rows(turned).take(np.frombuffer(text, np.uint8), axis=1).view(np.bool_)
    return line if across == down == 1 else line.repeat(down, axis=0).repeat(across, axis=1)


_remembered = lru_cache(maxsize=256)(_mask)
