"""Lines wider than Borland's thick ones: drawn with a round brush, as rows of pixels.

The brush is a disc as wide as the line, so a line is equally wide in every direction and corners
are round. A brush of an even width has its middle between two pixels, and reaches one pixel further
to the right and down.
"""

from functools import cache
from math import isqrt

import numpy as np

from bgi.raster import lines
from bgi.raster.lines import Box, Segment

_FAR = 1 << 40  # beyond every pixel


@cache
def reaches(width: int) -> list[tuple[int, int]]:
    """How far the brush reaches to the left and right in each of its rows, from the top down."""
    even = 1 - width % 2
    rows = range(-((width - 1) // 2), width // 2 + 1)
    right = [(isqrt(width * width - (2 * row - even) ** 2) + even) // 2 for row in rows]
    return [(even - reach, reach) for reach in right]


def rows(x1: int, y1: int, x2: int, y2: int, width: int, box: Box) -> list[Segment]:
    """The rows that a line covers, as level lines that do not overlap; those far away are left out.

    A row that a brush covers while it moves has no gap: the line's pixels touch each other.
    """
    left, top, right, bottom = box
    around = left - width, top - width, right + width, bottom + width
    near = lines.clip(x1, y1, x2, y2, around)
    if near is None:
        return []
    x1s, y1s, x2s, y2s = np.array(near).reshape(4, 1)
    x, y, _, _ = lines.trace_many((x1s, y1s, x2s, y2s))
    highest = int(y.min())
    count = int(y.max()) - highest + 1
    first, last = np.full(count, _FAR), np.full(count, -_FAR)
    np.minimum.at(first, y - highest, x)
    np.maximum.at(last, y - highest, x)
    starts = np.full(count + width - 1, _FAR)
    stops = np.full(count + width - 1, -_FAR)
    for row, (before, after) in enumerate(reaches(width)):
        part = slice(row, row + count)
        np.minimum(starts[part], first + before, out=starts[part])
        np.maximum(stops[part], last + after, out=stops[part])
    level = np.arange(len(starts)) + (highest - (width - 1) // 2)
    shown = (level >= top) & (level <= bottom)
    return list(zip(*(a[shown].tolist() for a in (starts, level, stops, level)), strict=True))
