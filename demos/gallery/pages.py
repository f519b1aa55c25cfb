"""Demos of several pages: a bar with the title and the keys above, the picture below it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from bgi import *

BAR, MARGIN = 24, 8
ESC, LEFT, PAGE_UP = 27, 75, 73
KEYS = "← → turn   Esc end"


@dataclass(frozen=True)
class Page:
    """A picture, what goes on in it every `pause` milliseconds until a key comes, and its mode."""

    title: str
    draw: Callable[[], None]
    move: Callable[[], None] | None = None
    pause: int = 20
    mode: tuple[int, int] = (VGA, VGAHI)


def show(pages: Sequence[Page], place: int = 0) -> None:
    """Draw a page on the screen as it is, below its bar; the viewport is what is left."""
    graphdefaults()
    cleardevice()
    setfillstyle(SOLID_FILL, min(LIGHTGRAY, getmaxcolor()))
    bar(0, 0, getmaxx(), BAR - 1)
    setcolor(BLACK)
    outtextxy(MARGIN, MARGIN, pages[place].title)
    keys = f"{place + 1}/{len(pages)}  {KEYS}"
    outtextxy(getmaxx() - MARGIN - textwidth(keys), MARGIN, keys)
    setcolor(min(WHITE, getmaxcolor()))
    setviewport(0, BAR, getmaxx(), getmaxy(), 1)
    pages[place].draw()


def leaf_through(pages: Sequence[Page]) -> None:
    """Show page after page, left and right by the arrows, until Esc comes."""
    place = 0
    while True:
        page = pages[place]
        initgraph(*page.mode)  # in the same window; also when only a new palette is wanted
        show(pages, place)
        while page.move is not None:
            page.move()
            delay(page.pause)
            if kbhit():
                break
        step = _step()
        if step == 0:
            return
        place = (place + step) % len(pages)


def _step() -> int:
    """The next key: -1 for a page back, 0 for the end, 1 for any other one."""
    key = getch()
    if key == 0:
        return -1 if getch() in (LEFT, PAGE_UP) else 1
    return 0 if key == ESC else 1
