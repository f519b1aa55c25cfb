"""The screen to draw on: its mode by its size and its colours, and whether anybody sees it."""

import os

from bgi import IBM8514, IBM8514HI, IBM8514LO, VGA, VGAHI, BGIError, initgraph, initwindow
from bgi.machine import display_exists

Size = tuple[int, int]
USUAL: Size = (640, 480)
NO_DISPLAY = (
    "no display to open a window on; a file needs none: python -m surfaces FORMULA -o picture.png"
)

MODES: dict[tuple[Size, bool], tuple[int, int]] = {
    ((640, 480), False): (IBM8514, IBM8514LO),
    ((1024, 768), False): (IBM8514, IBM8514HI),
    ((640, 480), True): (VGA, VGAHI),
}
"""Sizes that a card had a mode for, in 256 colours or, for dithering, in 16."""


def open_screen(size: Size = USUAL, dither: bool = False) -> None:
    """Open a screen of that size: a mode of a card if one has it, else a window.

    ValueError if there are no 16 colours to dither with.
    """
    if (size, dither) in MODES:
        initgraph(*MODES[size, dither])
    elif dither:
        raise ValueError("dithering is for the 16 colours of a VGA, which has 640 x 480 pixels")
    else:
        initwindow(*size, "surfaces")


def open_window(size: Size = USUAL, dither: bool = False) -> None:
    """Open a screen that somebody sees, or the one that BGI_MONITOR asks for; else BGIError."""
    if os.environ.get("BGI_MONITOR"):
        open_screen(size, dither)
        return
    if not display_exists():
        raise BGIError(NO_DISPLAY)
    os.environ["BGI_MONITOR"] = "window"  # or an error: on no other monitor a key ever comes
    try:
        open_screen(size, dither)
    finally:
        del os.environ["BGI_MONITOR"]


def attended() -> bool:
    """Whether there is a display, so that somebody may press keys and move the mouse."""
    return os.environ.get("BGI_MONITOR") != "none" and display_exists()
