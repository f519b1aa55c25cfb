"""The fonts in the adapter's ROM, 8 pixels wide and 8, 14 or 16 high: those of the text screen.

`data/rom8x14.bin` and its like hold the rows of 256 glyphs of code page 437, top row first, the
highest bit leftmost; `data/ROM.txt` says where they come from. The 8x8 one is not the graphics
driver's own (`bgi.fonts.bitmap`), whose letters are broader.
"""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from bgi.fonts import read

HEIGHTS = 8, 14, 16
"""The heights that there are."""


@cache
def glyphs(height: int) -> NDArray[np.bool_]:
    """The pixels of all glyphs, shape (256, height, 8)."""
    rows = np.frombuffer(read(f"rom8x{height}.bin"), np.uint8)
    return np.unpackbits(rows.reshape(256, height, 1), axis=2).astype(bool)
