"""The built-in 8x8 font: 256 glyphs of code page 437 as the graphics driver shows them.

`data/font8x8.bin` holds eight bytes a glyph, top row first, the highest bit leftmost.
"""

from functools import lru_cache
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

CELL = 8
"""Width and height of a glyph at size 1, in pixels."""

_DATA = (files("bgi.fonts") / "data" / "font8x8.bin").read_bytes()
_GLYPHS = np.unpackbits(np.frombuffer(_DATA, np.uint8).reshape(256, CELL, 1), axis=2).astype(bool)


@lru_cache(maxsize=256)
def mask(text: bytes, size: int) -> NDArray[np.bool_]:
    """The pixels of a string, every glyph pixel size x size."""
    line = _GLYPHS[np.frombuffer(text, np.uint8)].transpose(1, 0, 2).reshape(CELL, -1)
    return line.repeat(size, axis=0).repeat(size, axis=1)
