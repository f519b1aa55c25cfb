"""The loop: draw, show, wait for a key or the mouse."""

from typing import Any

import numpy as np

from bgi import delay, kbhit, setactivepage, swapbuffers
from surfaces.explorer.dials import TURN
from surfaces.explorer.explorer import EXAMPLES, Explorer
from surfaces.explorer.keys import read_key
from surfaces.explorer.options import Options
from surfaces.explorer.screen import USUAL, Size, attended, open_window
from surfaces.systems.characters import Text

SMALLEST: Size = (480, 240)
"""What the lines below the picture need."""
REST = 10
"""Milliseconds between two looks at the mouse."""
SPIN = 0.2
"""Steps of the turn from picture to picture while the surface spins: one degree."""


def explore(formula: str = EXAMPLES[0], size: Size = USUAL, **options: Any) -> None:
    """Walk round the surface of a formula, by keys and mouse, until Esc.

    Args:
        formula: z as a formula of x and y, such as "sin(x*y)/2".
        size: the window's width and height in pixels.
        options: how the picture begins, by the names of `Options`: x=(0, 5), turn=30, axes=True.

    The window stays open; closegraph() closes it. ValueError, before it opens, if there is no
    surface to see, BGIError if there is no display; WindowClosed when the user closes it.
    """
    beginning = Options(**options)
    with np.errstate(all="ignore"):
        beginning.draw(formula, on=Text())
    if any(given < least for given, least in zip(size, SMALLEST, strict=True)):
        raise ValueError("a window to explore in must be at least {} x {} pixels".format(*SMALLEST))
    open_window(size, beginning.dither)
    setactivepage(1)
    explorer = Explorer(formula, beginning)
    while explorer.running:
        explorer.draw()
        swapbuffers()
        wait(explorer)


def wait(explorer: Explorer) -> None:
    """Until a key or the mouse asks for a new picture; a spinning surface does not wait."""
    watched = attended()
    while watched and not (kbhit() or explorer.follow() or explorer.spinning):
        delay(REST)
    if explorer.spinning:
        explorer.turn(TURN, SPIN)
    if kbhit() or not (watched or explorer.spinning):  # without a display there are only keys
        explorer.press(read_key())
