"""The magnifier, a picture laid over the window's: an array of colours here, without any window.

It is for whoever learns how pixels are set, or looks for a wrong one. A page in a browser has one
of its own (web/page/lens.js), which looks the same.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bgi.fonts.codepage import encode
from bgi.fonts.rom import glyphs
from bgi.memory import rgb
from bgi.memory.matching import shown

Pixels = NDArray[Any]
Colors = NDArray[np.uint8]
Place = tuple[int, int]

TIMES = (0, 8, 16, 32)
"""How many times the key enlarges, one after the other; 0: not at all."""
SIZE = 336, 240
"""Of the enlarged part, about, in pixels of the window."""
ROW = 16
"""The height of a line of text."""

LEAST = 4
"""Times that leave room for a grid."""
GRID = np.array((64, 64, 64), np.uint8)
PAPER = np.array((0, 0, 128), np.uint8)
INK = np.array((255, 255, 255), np.uint8)
FRAMES = np.array(((255, 255, 255), (0, 0, 0)), np.uint8)
"""Around the pixel in the middle: one of them is seen on any colour."""


NAMES = [
    *("BLACK", "BLUE", "GREEN", "CYAN", "RED", "MAGENTA", "BROWN", "LIGHTGRAY", "DARKGRAY"),
    *("LIGHTBLUE", "LIGHTGREEN", "LIGHTCYAN", "LIGHTRED", "LIGHTMAGENTA", "YELLOW", "WHITE"),
]
"""Of COLORS, which are indices."""


class Lens(NamedTuple):
    """How the magnifier stands: how many times, 0 for none, and what it follows."""

    times: int = 0
    follows_pixels: bool = False
    """Whether it follows the last pixel that was set, and not the mouse."""

    def next(self) -> Lens:
        """As the key asks for: larger, and at last gone."""
        larger = [times for times in TIMES if times > self.times]
        return self._replace(times=larger[0] if larger else 0)


def name_of(number: int) -> str:
    """A colour as the lens writes it: its number, and its name if it has one."""
    if number >> 24:
        return "RGB {} {} {}".format(*rgb.split(number))
    return f"{number} {NAMES[number]}" if number < len(NAMES) else str(number)


def last_changed(before: Pixels, after: Pixels) -> Place | None:
    """The last place, row by row, where two pictures differ; None if nothing did."""
    if before.shape != after.shape:
        return None
    changed = np.flatnonzero(before != after)
    if not len(changed):
        return None
    y, x = divmod(int(changed[-1]), after.shape[1])
    return x, y


def magnified(pixels: Pixels, palette: Colors, place: Place, times: int, tall: float) -> Colors:
    """The surroundings of a pixel, enlarged, with a grid; a line of text tells what it is.

    Args:
        pixels: the numbers of the picture's pixels, shape (height, width).
        palette: the colours of the indices, shape (256, 3).
        place: x, y of the pixel in the middle, which is framed.
        times: how wide a pixel becomes.
        tall: how high it is for its width.

    Returns colours, shape (height, width, 3). Beyond the picture it is the grid's colour.
    """
    x, y = place
    high = max(round(times * tall), 1)
    across, down = SIZE[0] // times // 2, max(SIZE[1] // high // 2, 1)
    columns, rows = np.arange(x - across, x + across + 1), np.arange(y - down, y + down + 1)
    height, width = pixels.shape
    part = pixels.take(rows, 0, mode="clip").take(columns, 1, mode="clip")
    colors = shown(part, palette).copy()
    colors[(rows < 0) | (rows >= height)] = GRID
    colors[:, (columns < 0) | (columns >= width)] = GRID
    large = colors.repeat(high, 0).repeat(times, 1)
    if times >= LEAST:
        large[::high] = large[:, ::times] = GRID
    left, top = across * times, down * high
    for inset, color in enumerate(FRAMES):
        box = large[top + inset : top + high + 1 - inset, left + inset : left + times + 1 - inset]
        box[[0, -1]] = box[:, [0, -1]] = color
    said = f"x {x}  y {y}  color {name_of(int(pixels[y, x]))}"
    return np.concatenate([large, written(said, large.shape[1])])


def written(text: str, width: int) -> Colors:
    """A line of text, as wide as asked for; what does not fit is cut off."""
    row = np.tile(PAPER, (ROW, width, 1))
    codes = np.frombuffer(encode(text), np.uint8)[: width // 8]
    ink = np.concatenate([glyphs(ROW)[code] for code in codes], axis=1)
    row[:, : ink.shape[1]][ink] = INK
    return row
