"""From the numbers of pixels to colours, and back to the numbers that come nearest."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.memory import rgb

INDICES = 16
"""A pixel of four bytes that is smaller is an index into the palette."""
_CHUNK = 1 << 14  # colours at a time: bounds the memory


def true_colors(pixels: NDArray[Any], palette: NDArray[np.uint8]) -> NDArray[Any]:
    """Pixels of four bytes with a colour, red lowest, in place of every index."""
    table = palette[:INDICES].astype("<u4") @ np.array([1, 1 << 8, 1 << 16], "<u4")
    colors: NDArray[Any] = np.where(pixels < INDICES, table.take(pixels, mode="clip"), pixels)
    return colors


def shown(pixels: NDArray[Any], palette: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What pixels of either kind look like, shape (height, width, 3)."""
    if pixels.dtype == np.uint8:
        colors: NDArray[np.uint8] = palette[pixels]
        return colors
    numbers = np.ascontiguousarray(true_colors(pixels, palette), "<u4")
    return numbers.view(np.uint8).reshape(*pixels.shape, 4)[..., :3]


def nearest(colors: NDArray[np.uint8], palette: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The palette indices whose colours come nearest to colours (..., 3), the first of equals.

    |c - p|^2 is |p|^2 - 2 c.p, and |c|^2, which is the same for every p. Whole numbers below 2^24,
    so float32 holds them exactly.
    """
    unique, places = np.unique(colors.reshape(-1, 3), axis=0, return_inverse=True)
    known = palette.astype(np.float32)
    lengths = (known**2).sum(axis=1)
    found = np.empty(len(unique), np.uint8)
    for start in range(0, len(unique), _CHUNK):
        part = unique[start : start + _CHUNK].astype(np.float32)
        found[start : start + _CHUNK] = (lengths - 2 * part @ known.T).argmin(axis=1)
    return found[places.reshape(colors.shape[:-1])]


def tagged(colors: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """Colours (..., 3) as a window's pixels hold them."""
    red, green, blue = np.moveaxis(colors.astype(np.uint32), -1, 0)
    mixed: NDArray[np.uint32] = blue << 16 | green << 8 | red | np.uint32(rgb.TAG)
    return mixed
