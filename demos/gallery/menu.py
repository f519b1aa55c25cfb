"""The gallery's menu, drawn and asked with the calls that the demos show."""

from functools import cache
from textwrap import wrap

from bgi import *
from gallery.catalogue import C_NAMES, NAMES, Demo, load

ENTER, ESC, UP, DOWN, LEFT, RIGHT, HOME, END = 13, 27, 72, 80, 75, 77, 71, 79
MARGIN, TOP = 16, 72
CHOICES = NAMES + C_NAMES
COLUMN = (len(CHOICES) + 1) // 2
ROW = min(42, 384 // COLUMN)
COLUMN_WIDTH = 132
PREVIEW_LEFT, PREVIEW_WIDTH, PREVIEW_HEIGHT = 303, 320, 240
LABELS = "123456789abcdefghijklmnopqrstuvwxyz"
KEYS = "↑ ↓ ← → choose    Enter, or its key, start    Esc end"


def choose(selected: int) -> int | None:
    """Show the menu until a demo is chosen; returns its place in CHOICES, or None for the end."""
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
        if 0 <= LABELS.find(chr(key)) < len(CHOICES):
            return LABELS.find(chr(key))
        if key == 0:  # an arrow: its second half follows
            selected = _moved(selected, getch())


def _moved(selected: int, scan: int) -> int:
    """The place that a key leads to; beyond the last comes the first."""
    steps = {UP: -1, DOWN: 1, LEFT: -COLUMN, RIGHT: COLUMN, HOME: -selected, END: -selected - 1}
    return (selected + steps.get(scan, 0)) % len(CHOICES)


def _draw(selected: int) -> None:
    demo = load(CHOICES[selected])
    thumbnail = _preview(demo)
    graphdefaults()
    cleardevice()
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 3)
    _write(MARGIN + 2, 24, "graphics.h", BLUE)
    _write(MARGIN, 22, "graphics.h", YELLOW)
    settextstyle(DEFAULT_FONT, HORIZ_DIR, 1)
    _write(PREVIEW_LEFT, 36, "Borland's graphics library in Python", LIGHTGRAY)
    for place in range(len(CHOICES)):
        _entry(place, place == selected)
    putimage(PREVIEW_LEFT, TOP, thumbnail, COPY_PUT)
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
    column, row = divmod(place, COLUMN)
    left, top = MARGIN + column * (COLUMN_WIDTH + 4), TOP + row * ROW
    if is_selected:
        setfillstyle(SOLID_FILL, BLUE)
        bar(left, top, left + COLUMN_WIDTH - 1, top + ROW - 7)
        rectangle(left, top, left + COLUMN_WIDTH - 1, top + ROW - 7, LIGHTCYAN)
    middle = top + ROW // 2 - 7
    _write(left + 6, middle, LABELS[place], YELLOW)
    _write(left + 24, middle, CHOICES[place], WHITE if is_selected else LIGHTGRAY)


def _write(x: int, y: int, text: str, color: int) -> None:
    setcolor(color)
    outtextxy(x, y, text)


@cache
def _preview(demo: Demo) -> Image:
    """A demo's picture at half its size; of four pixels the one with the highest colour stays."""
    cleardevice()
    demo.draw()
    graphdefaults()  # the demo may have left a viewport
    pixels = getimage(0, 0, 2 * PREVIEW_WIDTH - 1, 2 * PREVIEW_HEIGHT - 1).array
    four = pixels.reshape(PREVIEW_HEIGHT, 2, PREVIEW_WIDTH, 2)
    return Image(four.max(axis=(1, 3)))
