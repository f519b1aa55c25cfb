"""All that the plotter needs of graphics.h: arrays in, lines and polygons out.

The paper asks for no more than "primitive 2-D graphics functions".  This file holds the plotter to
it: nothing else in ``surfaces`` may import ``bgi``, and it uses nothing but the public calls.
"""

import numpy as np
from numpy.typing import NDArray

import bgi
from surfaces.colours import RAMPS, ramp_rgb
from surfaces.transforms import FloatArray

IntArray = NDArray[np.int64]

# Beyond any screen, yet small enough that the products of two coordinates fit into 64 bits.
FAR = 2**24


def size() -> tuple[int, int]:
    """Width and height of the place to draw in, in pixels."""
    return bgi.getmaxx() + 1, bgi.getmaxy() + 1


def aspect() -> float:
    """The width of a pixel divided by its height: 1 on a VGA, less on older cards.

    Whatever the mode, the screen that shows it is four units wide and three high.
    """
    width, height = size()
    return 4 * height / (3 * width)


def colours() -> int:
    """How many colours the screen has."""
    return bgi.getmaxcolor() + 1


def colour() -> int:
    """The current drawing colour."""
    return bgi.getcolor()


def pixels(points: FloatArray) -> IntArray:
    """Round screen points to the nearest pixels.  (graphics.h would cut the fraction off.)"""
    return np.floor(np.clip(points, -FAR, FAR) + 0.5).astype(np.int64)


def load_ramp() -> None:
    """Load the ramp of heights into the palette, where there is room for it."""
    if colours() == 256:
        entries = RAMPS[256]
        for entry, (r, g, b) in zip(entries.tolist(), ramp_rgb(len(entries)).tolist(), strict=True):
            bgi.setrgbpalette(entry, r, g, b)


def lines(starts: IntArray, ends: IntArray) -> None:
    """Lines from starts to ends, both (n, 2), in the current colour and line style."""
    bgi.line(starts[:, 0], starts[:, 1], ends[:, 0], ends[:, 1])


def polygons(corners: IntArray, fills: IntArray | int, outlines: int) -> None:
    """Solid polygons, corners (n, k, 2), one after another; an outline of colour 0 is not drawn."""
    bgi.fillpoly(corners, fill=fills, color=outlines)
