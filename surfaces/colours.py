"""Colours for heights: blue for the lowest, then cyan, green and yellow, red for the highest.

A mode of 256 colours has room for a smooth ramp: entries 16 to 255 are loaded with it, and the
sixteen everyday colours stay as they are.  A mode of 16 has eight of these colours ready made; the
heights fall into eight bands, or, dithered, into fifteen: where a height lies between two bands the
cells take the two colours in turn, like a chessboard.  A mode of 4 gives three bands.  With 2
colours bands alternate between dark and light, as on a map.
"""

import numpy as np
from numpy.typing import NDArray

from surfaces.transforms import FloatArray

# Colours of the screen -> palette indices from the lowest height to the highest.
RAMPS: dict[int, NDArray[np.int64]] = {
    2: np.array((1, 0, 1, 0, 1, 0, 1)),
    4: np.arange(1, 4),
    # BLUE LIGHTBLUE CYAN LIGHTCYAN LIGHTGREEN YELLOW LIGHTRED RED
    16: np.array((1, 9, 3, 11, 10, 14, 12, 4)),
    256: np.arange(16, 256),
}

# Red, green and blue of the ramp's five corners: blue, cyan, green, yellow, red.
CORNERS = np.array(((0, 0, 255), (0, 255, 255), (0, 255, 0), (255, 255, 0), (255, 0, 0)))


def ramp_rgb(n: int) -> NDArray[np.int64]:
    """n colours from blue to red: an (n, 3) array of red, green and blue, each 0..255."""
    at = np.linspace(0, len(CORNERS) - 1, n)
    corner = np.arange(len(CORNERS))
    rgb = np.stack([np.interp(at, corner, channel) for channel in CORNERS.T], axis=1)
    return np.asarray(np.rint(rgb), dtype=np.int64)


def shades(part: FloatArray, colours: int, dither: bool = False) -> NDArray[np.int64]:
    """The palette index of every cell, on a screen of ``colours`` colours.

    ``part``, shape (nx, ny), says how high each cell lies: 0 for the lowest, which gets the first
    colour of the ramp, to 1 for the highest, which gets the last; NaN gets the first.
    """
    ramp = RAMPS[colours]
    height = np.nan_to_num(part)
    if dither:
        i, j = np.indices(height.shape)
        band = np.floor(height * (len(ramp) - 1) + 0.25 + 0.5 * ((i + j) & 1))
    else:
        band = np.floor(height * len(ramp))
    return ramp[np.minimum(band, len(ramp) - 1).astype(np.int64)]
