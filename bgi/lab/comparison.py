"""The picture of a mistake: what was drawn, what was expected, and how they differ, magnified."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bgi.constants import (
    BLACK,
    DARKGRAY,
    IBM8514,
    IBM8514HI,
    LIGHTBLUE,
    LIGHTGRAY,
    LIGHTRED,
    SOLID_FILL,
    WHITE,
    YELLOW,
)
from bgi.graphics import Graphics
from bgi.kernel.modes import find
from bgi.memory.image import Image

Pixels = NDArray[np.uint8]
Box = tuple[int, int, int, int]

PANEL = 288
"""Pixels across a panel, and down."""
LARGEST, SMALLEST = 16, 2
"""How many times a pixel is enlarged."""
ROOM = 10
"""Pixels around differences in a picture that is too large to be shown."""
GRID = 5
"""From there on there are grid lines."""
EDGE, HEAD, FOOT = 12, 20, 36
"""Pixels around the panels, above them for their titles, and below for the legend."""
MISSING, TOO_MANY, RECOLORED = LIGHTRED, LIGHTBLUE, YELLOW


def difference(got: Pixels, expected: Pixels, ground: Pixels) -> Pixels:
    """Where they differ, in the colours of the legend; the rest of what was drawn is gray."""
    found = np.where(expected != ground, np.uint8(DARKGRAY), np.uint8(BLACK))
    wrong = got != expected
    found[wrong] = RECOLORED
    found[wrong & (got == ground)] = MISSING
    found[wrong & (expected == ground)] = TOO_MANY
    return found


def side_by_side(got: Pixels, expected: Pixels, ground: Pixels) -> Image:
    """The part where they differ, three times: yours, expected, difference.

    `ground` is what was on the screen before.
    """
    left, top, right, bottom = box = _part(got, expected, ground)
    times = max(SMALLEST, min(LARGEST, PANEL // max(right - left, bottom - top)))
    width, height = (right - left) * times + 1, (bottom - top) * times + 1
    across = max(width, 100)
    mode = find(IBM8514, IBM8514HI)
    assert mode is not None
    screen = Graphics(mode)
    screen.setfillstyle(SOLID_FILL, BLACK)
    panels = {
        "yours": got,
        "expected": expected,
        "difference": difference(got, expected, ground),
    }
    for number, (title, pixels) in enumerate(panels.items()):
        x = EDGE + number * (across + EDGE)
        screen.setcolor(WHITE)
        screen.outtextxy(x, EDGE // 2, title)
        _panel(screen, x, HEAD, times, pixels[top:bottom, left:right])
    _legend(screen, box, HEAD + height)
    return screen.getimage(0, 0, 3 * across + 4 * EDGE - 1, HEAD + height + FOOT + EDGE - 1)


def _part(got: Pixels, expected: Pixels, ground: Pixels) -> Box:
    """What is shown: all that was drawn or expected, or as much of it around the differences."""
    down, across = np.nonzero((got != ground) | (expected != ground))
    wrong_down, wrong_across = np.nonzero(got != expected)
    left, right = _side(across, wrong_across, got.shape[1])
    top, bottom = _side(down, wrong_down, got.shape[0])
    return left, top, right, bottom


def _side(places: Any, wrong: Any, size: int) -> tuple[int, int]:
    """Where a side of the part begins, and where it ends (excluded): a pixel of room around.

    A side that is too long is cut: to the differences, if they lie together, and else to the first.
    """
    first, last = max(int(places.min()) - 1, 0), min(int(places.max()) + 2, size)
    most = PANEL // SMALLEST
    if last - first > most:
        spread = int(wrong.max() - wrong.min()) + 1
        middle = int(wrong.min()) + spread // 2 if spread + 2 * ROOM <= most else int(wrong[0])
        most = min(spread + 2 * ROOM, most)
        first = min(max(middle - most // 2, first), last - most)
        last = first + most
    return first, last


def _panel(screen: Graphics, x: int, y: int, times: int, pixels: Pixels) -> None:
    """One of the three."""
    height, width = pixels.shape
    down, across = (side.ravel() for side in np.mgrid[:height, :width])
    left, top = x + across * times, y + down * times
    grid = 1 if times >= GRID else 0
    screen.bar(left + grid, top + grid, left + times - 1, top + times - 1, pixels.ravel())
    screen.setcolor(DARKGRAY)
    if grid:
        for column in range(width + 1):
            screen.line(x + column * times, y, x + column * times, y + height * times)
        for row in range(height + 1):
            screen.line(x, y + row * times, x + width * times, y + row * times)
    else:
        screen.rectangle(x - 1, y - 1, x + width * times, y + height * times)


def _legend(screen: Graphics, box: Box, y: int) -> None:
    """Which part of the screen it is, and what the colours of the difference mean."""
    left, top, right, bottom = box
    screen.setcolor(LIGHTGRAY)
    screen.outtextxy(EDGE, y + 8, f"x {left}..{right - 1}, y {top}..{bottom - 1}")
    x = EDGE
    for color, words in ((MISSING, "missing"), (TOO_MANY, "too much"), (RECOLORED, "other colour")):
        screen.setfillstyle(SOLID_FILL, color)
        screen.bar(x, y + 22, x + 7, y + 29)
        screen.outtextxy(x + 12, y + 22, words)
        x += 20 + 8 * len(words) + EDGE
