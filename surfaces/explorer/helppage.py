"""The help page: all the keys, on the whole screen."""

from bgi import LIGHTGRAY, YELLOW, cleardevice, getmaxy, outtextxy, setcolor
from surfaces.explorer.keys import HELP
from surfaces.explorer.panel import CHARACTER, MARGIN

INDENT = 12
"""Characters that the names of the keys have room for."""
ROW = 18
"""Pixels from line to line, where there are so many."""


def show_help() -> None:
    """Draw it."""
    cleardevice()
    row = min(ROW, (getmaxy() + 1) // (len(HELP) + 1))
    top = (getmaxy() + 1 - row * len(HELP)) // 2
    for number, (keys, meaning) in enumerate(HELP):
        setcolor(YELLOW)
        outtextxy(MARGIN, top + number * row, keys)
        setcolor(LIGHTGRAY)
        outtextxy(MARGIN + INDENT * CHARACTER, top + number * row, meaning)
