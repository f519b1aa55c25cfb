"""Boxes of pixels, and what lies in them."""

import numpy as np
from numpy.typing import NDArray

from bgi.raster.lines import Box, Ints

Part = tuple[slice, slice]
"""Rows and columns of an array."""


def overlap(x: int, y: int, shape: tuple[int, ...], box: Box) -> tuple[Part, Part] | None:
    """Where a picture of that shape at x, y meets a box: on the page, and in the picture."""
    left, top = max(x, box[0]), max(y, box[1])
    right, bottom = min(x + shape[1], box[2] + 1), min(y + shape[0], box[3] + 1)
    if left >= right or top >= bottom:
        return None
    there = slice(top - y, bottom - y), slice(left - x, right - x)
    return (slice(top, bottom), slice(left, right)), there


def within(x: Ints, y: Ints, box: Box) -> NDArray[np.bool_]:
    """Which of some pixels lie in a box."""
    left, top, right, bottom = box
    inside: NDArray[np.bool_] = (x >= left) & (x <= right) & (y >= top) & (y <= bottom)
    return inside
