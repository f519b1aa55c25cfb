"""The screen to draw on: its mode by its size and its colors, and whether anybody sees it."""

import os

from bgi import IBM8514, IBM8514HI, IBM8514LO, VGA, VGAHI, initgraph, initwindow
from bgi.machine import display_exists

Size = tuple[int, int]
USUAL: Size = (640, 480)

MODES: dict[tuple[Size, bool], tuple[int, int]] = {
    ((640, 480), False): (IBM8514, IBM8514LO),
    ((1024, 768), False): (IBM8514, IBM8514HI),
    ((640, 480), True): (VGA, VGAHI),
}
"""Sizes that a card had a mode for, in 256 colors or, for dithering, in 16."""


def open_screen(size: Size = USUAL, dither: bool = False) -> None:
    """Open a screen of that size: a mode of a card if one has it, else a window."""
    mode = MODES.get((size, dither))
    if mode:
        initgraph(*mode)
    else:
        initwindow(*size, "surfaces")


def attended() -> bool:
    """Whether there is a display, so that somebody may press keys and move the mouse."""
    return os.environ.get("BGI_MONITOR") != "none" and display_exists()
