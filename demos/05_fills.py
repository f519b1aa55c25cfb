"""The twelve fill patterns and one's own, on everything that can be filled.

    python demos/05_fills.py

What it shows: setfillstyle() chooses pattern and colour for bar, fillpoly, fillellipse, pieslice,
sector and floodfill alike; setfillpattern() takes eight bytes of one's own. Patterns are anchored
to the screen: shapes that touch join without a seam.
"""

from collections.abc import Callable
from functools import partial
from math import cos, radians, sin

from bgi import *
from gallery.pages import Page, leaf_through, show

MODE = (VGA, VGAHI)
# The patterns, in the order of their numbers.
NAMES = (
    "EMPTY_FILL",
    "SOLID_FILL",
    "LINE_FILL",
    "LTSLASH_FILL",
    "SLASH_FILL",
    "BKSLASH_FILL",
    "LTBKSLASH_FILL",
    "HATCH_FILL",
    "XHATCH_FILL",
    "INTERLEAVE_FILL",
    "WIDE_DOT_FILL",
    "CLOSE_DOT_FILL",
)
HUES = (LIGHTBLUE, LIGHTGREEN, LIGHTCYAN, LIGHTRED, LIGHTMAGENTA, YELLOW)
# Eight rows of eight pixels each: a pattern is a picture of its bits.
PICTURES = {
    "hearts": (0x00, 0x66, 0xFF, 0xFF, 0x7E, 0x3C, 0x18, 0x00),
    "bricks": (0xFF, 0x80, 0x80, 0x80, 0xFF, 0x08, 0x08, 0x08),
    "scales": (0x81, 0x42, 0x3C, 0x18, 0x18, 0x24, 0xC3, 0x81),
    "checks": (0xF0, 0xF0, 0xF0, 0xF0, 0x0F, 0x0F, 0x0F, 0x0F),
    "weave": (0xF8, 0x74, 0x22, 0x47, 0x8F, 0x17, 0x22, 0x71),
    "tiles": (0xFF, 0xC3, 0xA5, 0x99, 0x99, 0xA5, 0xC3, 0xFF),
}


def caption(x: int, y: int, text: str) -> None:
    """A text, its middle at x."""
    setcolor(LIGHTGRAY)
    outtextxy(x - textwidth(text) // 2, y, text)


def each_pattern(shape: Callable[[int, int], None]) -> None:
    """A page with twelve copies of a shape, given its centre: one in each pattern."""
    for pattern, name in enumerate(NAMES):
        x, y = 84 + 157 * (pattern % 4), 74 + 149 * (pattern // 4)
        setfillstyle(pattern, HUES[pattern % len(HUES)])
        setcolor(WHITE)
        shape(x, y)
        caption(x, y + 66, f"{pattern} {name}")


def box(x: int, y: int) -> None:
    """bar fills without an outline; rectangle draws one."""
    bar(x - 66, y - 56, x + 66, y + 56)
    rectangle(x - 66, y - 56, x + 66, y + 56)


def disc(x: int, y: int) -> None:
    """fillellipse in both directions."""
    fillellipse(x, y, 66, 36)
    fillellipse(x, y, 24, 56)


def slices(x: int, y: int) -> None:
    """Two slices of a pie, and one of an ellipse, pulled out."""
    pieslice(x, y, 90, 200, 56)
    pieslice(x, y, 200, 360, 56)
    sector(x + 7, y - 7, 0, 90, 58, 46)


def star(x: int, y: int) -> None:
    """A star of one stroke is hollow: the even-odd rule."""
    points = []
    for degrees in range(0, 720, 144):
        angle = radians(degrees)
        points.append((x + 62 * sin(angle), y + 4 - 62 * cos(angle)))
    fillpoly(points)


def poured(x: int, y: int) -> None:
    """floodfill pours between two ellipses, up to their colour."""
    circle(x, y, 56)
    ellipse(x, y, 0, 360, 20, 34)
    line(x - 60, y, x - 16, y)
    floodfill(x + 38, y, WHITE)


def own() -> None:
    """setfillpattern: the bits, ten times as large, and what they look like."""
    for place, (name, rows) in enumerate(PICTURES.items()):
        left, top = 20 + 208 * (place % 3), 18 + 222 * (place // 3)
        bits(left, top, rows)
        setfillpattern(rows, HUES[place])
        setcolor(WHITE)
        fillpoly(
            [(left + 92, top), (left + 184, top), (left + 184, top + 78), (left + 92, top + 78)]
        )
        fillellipse(left + 92, top + 134, 90, 44)
        setcolor(LIGHTGRAY)
        outtextxy(left, top + 186, name)
        outtextxy(left, top + 198, bytes(rows).hex(" ").upper())


def bits(left: int, top: int, rows: tuple[int, ...]) -> None:
    """A square for each bit of a pattern; the highest bit of a byte is its leftmost pixel."""
    for row, byte in enumerate(rows):
        for column in range(8):
            is_set = byte & (0b10000000 >> column)
            setfillstyle(SOLID_FILL, YELLOW if is_set else BLUE)
            x, y = left + 10 * column, top + 10 * row
            bar(x, y, x + 8, y + 8)


def landscape() -> None:
    """A scene of filled shapes, drawn from the back to the front."""
    setfillstyle(LTBKSLASH_FILL, BLUE)
    bar(0, 0, 639, 300)
    setfillstyle(SOLID_FILL, YELLOW)
    setcolor(YELLOW)
    fillellipse(500, 90, 48, 48)
    for left, width, height, pattern, color in (
        (-60, 360, 190, INTERLEAVE_FILL, LIGHTGRAY),
        (170, 340, 240, WIDE_DOT_FILL, WHITE),
        (400, 330, 170, INTERLEAVE_FILL, LIGHTGRAY),
    ):
        setcolor(WHITE)
        setfillstyle(pattern, color)
        fillpoly([(left, 300), (left + width // 2, 300 - height), (left + width, 300)])
    setfillpattern((0x88, 0x22, 0x88, 0x22, 0x88, 0x22, 0x88, 0x22), LIGHTGREEN)
    setcolor(GREEN)
    fillpoly([(0, 286), (220, 298), (430, 288), (639, 299), (639, 455), (0, 455)])
    house(90, 300)
    for x, y in ((300, 360), (372, 330), (560, 372), (470, 342)):
        tree(x, y)


def house(left: int, top: int) -> None:
    """Bricks, a roof of scales, a door, a window."""
    setcolor(WHITE)
    setfillpattern(PICTURES["bricks"], LIGHTRED)
    fillpoly([(left, top), (left + 130, top), (left + 130, top + 90), (left, top + 90)])
    setfillpattern(PICTURES["scales"], BROWN)
    fillpoly([(left - 14, top), (left + 65, top - 62), (left + 144, top)])
    setfillstyle(SOLID_FILL, BROWN)
    bar(left + 20, top + 36, left + 50, top + 90)
    rectangle(left + 20, top + 36, left + 50, top + 90)
    setfillstyle(SOLID_FILL, YELLOW)
    bar(left + 76, top + 30, left + 112, top + 62)
    rectangle(left + 76, top + 30, left + 112, top + 62)
    line(left + 94, top + 30, left + 94, top + 62)
    line(left + 76, top + 46, left + 112, top + 46)


def tree(x: int, y: int) -> None:
    """A trunk and three crowns."""
    setfillstyle(SOLID_FILL, BROWN)
    bar(x - 6, y, x + 6, y + 56)
    setcolor(LIGHTGREEN)
    setfillpattern(PICTURES["weave"], GREEN)
    for step, radius in enumerate((38, 30, 20)):
        fillellipse(x, y - 22 * step, radius, 24)


PAGES = (
    Page("bar", partial(each_pattern, box)),
    Page("fillellipse", partial(each_pattern, disc)),
    Page("pieslice and sector", partial(each_pattern, slices)),
    Page("fillpoly", partial(each_pattern, star)),
    Page("floodfill", partial(each_pattern, poured)),
    Page("setfillpattern", own),
    Page("All of them", landscape),
)


def draw() -> None:
    """The landscape."""
    show(PAGES, len(PAGES) - 1)


def main() -> None:
    """Leaf through the pages until Esc comes."""
    leaf_through(PAGES)


if __name__ == "__main__":
    main()
