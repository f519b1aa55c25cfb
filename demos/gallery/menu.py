"""The gallery's menu, drawn and asked with the calls that the demos show."""

from functools import cache
from textwrap import wrap

import numpy as np
from numpy.typing import NDArray

from bgi import (
    BLACK,
    BLUE,
    DARKGRAY,
    LIGHTCYAN,
    LIGHTGRAY,
    SOLID_FILL,
    VGA,
    VGAHI,
    WHITE,
    YELLOW,
    bar,
    cleardevice,
    getch,
    getmaxx,
    getmaxy,
    getpixel,
    graphdefaults,
    initgraph,
    outtextxy,
    putpixel,
    rectangle,
    setactivepage,
    setcolor,
    setfillstyle,
    swapbuffers,
)
from gallery.catalogue import NAMES, Demo, load

ENTER, ESC, UP, DOWN, HOME, END = 13, 27, 72, 80, 71, 79
MARGIN, TOP = 16, 72
ROW = min(42, 384 // len(NAMES))
LIST_WIDTH = 264
PREVIEW_LEFT, PREVIEW_WIDTH, PREVIEW_HEIGHT = 303, 320, 240
LABELS = "123456789abcdefghijklmnopqrstuvwxyz"
KEYS = "↑ ↓ choose    Enter, or its key, start    Esc end"


def choose(selected: int) -> int | None:
    """Show the menu until a demo is chosen; returns its place in NAMES, or None for the end."""
    initgraph(VGA, VGAHI)
    setactivepage(1)
    while True:
        _draw(selected)
        swapbuffers()
        key = getch()
        if key == ESC:
            return None
        if key == ENTER:
            return selected
        if 0 <= LABELS.find(chr(key)) < len(NAMES):
            return LABELS.find(chr(key))
        if key == 0:  # an arrow: its second half follows
            moves = {UP: selected - 1, DOWN: selected + 1, HOME: 0, END: len(NAMES) - 1}
            selected = moves.get(getch(), selected) % len(NAMES)


def _draw(selected: int) -> None:
    demo = load(NAMES[selected])
    thumbnail = _preview(demo)
    title = _large("graphics.h", 3)
    graphdefaults()
    cleardevice()
    below, right = np.nonzero(title)
    putpixel(MARGIN + 2 + right, 24 + below, BLUE)
    putpixel(MARGIN + right, 22 + below, YELLOW)
    _write(PREVIEW_LEFT, 36, "Borland's graphics library in Python", LIGHTGRAY)
    for place in range(len(NAMES)):
        _entry(place, place == selected)
    y, x = np.indices(thumbnail.shape)
    putpixel(PREVIEW_LEFT + x, TOP + y, thumbnail)
    rectangle(
        PREVIEW_LEFT - 1, TOP - 1, PREVIEW_LEFT + PREVIEW_WIDTH, TOP + PREVIEW_HEIGHT, DARKGRAY
    )
    texts = [(WHITE, text) for text in wrap(demo.summary, PREVIEW_WIDTH // 8)]
    texts += [(LIGHTGRAY, text) for text in wrap(demo.lesson, PREVIEW_WIDTH // 8)]
    for number, (color, text) in enumerate(texts):
        _write(PREVIEW_LEFT, TOP + PREVIEW_HEIGHT + 14 + 12 * number, text, color)
    setfillstyle(SOLID_FILL, LIGHTGRAY)
    bar(0, getmaxy() - 19, getmaxx(), getmaxy())
    _write(MARGIN, getmaxy() - 13, KEYS, BLACK)


def _entry(place: int, is_selected: bool) -> None:
    """One line of the list: the key that starts the demo, and its name."""
    left, top = MARGIN, TOP + place * ROW
    if is_selected:
        setfillstyle(SOLID_FILL, BLUE)
        bar(left, top, left + LIST_WIDTH - 1, top + ROW - 7)
        rectangle(left, top, left + LIST_WIDTH - 1, top + ROW - 7, LIGHTCYAN)
    middle = top + ROW // 2 - 7
    _write(left + 12, middle, LABELS[place], YELLOW)
    _write(left + 36, middle, NAMES[place], WHITE if is_selected else LIGHTGRAY)


def _write(x: int, y: int, text: str, color: int) -> None:
    setcolor(color)
    outtextxy(x, y, text)


@cache
def _preview(demo: Demo) -> NDArray[np.uint8]:
    """A demo's picture at half its size; of four pixels the one with the highest colour stays."""
    cleardevice()
    demo.draw()
    graphdefaults()  # the demo may have left a viewport
    height, width = PREVIEW_HEIGHT, PREVIEW_WIDTH
    y, x = np.indices((2 * height, 2 * width))
    pixels: NDArray[np.uint8] = getpixel(x, y)
    smaller: NDArray[np.uint8] = pixels.reshape(height, 2, width, 2).max(axis=(1, 3))
    return smaller


@cache
def _large(text: str, size: int) -> NDArray[np.uint8]:
    """A text in letters of so many times their size, as pixels: 0 is background."""
    cleardevice()
    outtextxy(0, 0, text)
    y, x = np.indices((8, 8 * len(text)))
    pixels: NDArray[np.uint8] = getpixel(x, y)
    return pixels.repeat(size, axis=0).repeat(size, axis=1)
