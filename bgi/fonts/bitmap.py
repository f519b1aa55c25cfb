"""The built-in 8x8 font: 256 glyphs of code page 437 as the graphics driver shows them.

`data/font8x8.bin` holds eight bytes a glyph, top row first, the highest bit leftmost.
"""

from functools import lru_cache
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

CELL = 8
"""Width and height of a glyph at size 1, in pixels."""


@lru_cache(maxsize=1)
def _glyphs() -> NDArray[np.bool_]:
    """The pixels of all glyphs, shape (256, CELL, CELL)."""
    rows = (files("bgi.fonts") / "data" / "font8x8.bin").read_bytes()
    return np.unpackbits(np.frombuffer(rows, np.uint8).reshape(256, CELL, 1), axis=2).astype(bool)


@lru_cache(maxsize=256)
def mask(text: bytes, size: int) -> NDArray[np.bool_]:
    """The pixels of a string: True where it is drawn; every glyph pixel is size x size."""
    line = _glyphs()[np.frombuffer(text, np.uint8)].transpose(1, 0, 2).reshape(CELL, -1)
    return line.repeat(size, axis=0).repeat(size, axis=1)
