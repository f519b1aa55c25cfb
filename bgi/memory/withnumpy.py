"""The part of `bgi.memory.backend` that numpy has, for a Python without pygame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bgi.memory import bmpfile, pngfile
from bgi.raster import lines

_KIND: dict[int, str] = {1: "u1", 4: "<u4"}

Box = tuple[int, int, int, int]
"""left, top, width, height."""
Point = tuple[int, int]


class Bitmap:
    """What a pygame surface is to a page."""

    def __init__(self, memory: memoryview, width: int, height: int, pixel_bytes: int) -> None:
        self.width = width
        self.flat = np.frombuffer(memory, _KIND[pixel_bytes])
        self.array = self.flat.reshape(height, width)

    def fill(self, color: int, box: Box) -> None:
        """A box within the page."""
        left, top, width, height = box
        self.array[top : top + height, left : left + width] = color


surface = Bitmap


def draw_line(surface: Bitmap, color: int, end: Point, start: Point, width: int = 1) -> None:
    """A line within the page, by Bresenham's algorithm from `start` on; of width 1 or 3."""
    if width == 3:
        for x1, y1, x2, y2 in lines.strands(*start, *end):
            draw_line(surface, color, (x2, y2), (x1, y1))
        return
    (x1, y1), (x2, y2) = start, end
    n, m = abs(x2 - x1), abs(y2 - y1)
    along, across = 1 if x2 >= x1 else -1, surface.width if y2 >= y1 else -surface.width
    if n < m:
        n, m, along, across = m, n, across, along
    first = y1 * surface.width + x1
    if m:
        surface.flat[lines.places((first, n, m, along, across))] = color
    else:  # level or upright
        surface.flat[first::along][: n + 1] = color


def draw_box(surface: Bitmap, color: int, box: Box, width: int = 1) -> None:
    """The outline of a box within the page, one pixel wide."""
    left, top, across, down = box
    right, bottom = left + across - 1, top + down - 1
    pixels = surface.array
    pixels[top, left : right + 1] = pixels[bottom, left : right + 1] = color
    pixels[top : bottom + 1, left] = pixels[top : bottom + 1, right] = color


_WRITERS = {"png": pngfile.write, "bmp": bmpfile.write}
_READERS = {"png": pngfile.read, "bmp": bmpfile.read}


def write_picture(pixels: NDArray[np.uint8], palette: NDArray[np.uint8] | None, form: str) -> bytes:
    """A file, "png" or "bmp", of indices (height, width) or colours (height, width, 3)."""
    _check(form)
    return _WRITERS[form](pixels, palette)


def read_picture(data: bytes, form: str) -> tuple[NDArray[np.uint8], NDArray[np.uint8] | None]:
    """Indices (height, width) and their colours (256, 4), or RGBA (height, width, 4) and None.

    ValueError says what is wrong with the file.
    """
    _check(form)
    return _READERS[form](data)


def _check(form: str) -> None:
    if form not in _READERS:
        raise ValueError("a JPEG needs pygame, which is not installed; choose a .png or .bmp")
