"""Moving colours instead of pixels.

    python demos/07_palette.py

What it shows: a pixel holds the number of a colour; the palette says how that number looks. When
setallpalette() or setrgbpalette() changes the palette, everything on the screen changes at once,
and nothing is drawn again: a tunnel rushes past, the sun rises, water flows. The last page has the
256 colours of the 8514.
"""

import itertools
from collections.abc import Sequence
from math import pi, sin

import numpy as np

from bgi import *
from gallery.pages import Page, leaf_through, show

MODE = (VGA, VGAHI)
WIDTH, HEIGHT = 640, 456  # what is left below the bar

# The tunnel's colours turn; 0, 7 and 15 stay, for the background, the bar and the text.
RING = (1, 2, 3, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14)
# Other looks for them, of the 64 that the EGA could mix; the last three have no name.
# fmt: off
LOOKS = (
    EGA_BLUE, EGA_MAGENTA, EGA_RED, EGA_LIGHTRED, EGA_YELLOW, EGA_WHITE, EGA_LIGHTCYAN,
    EGA_CYAN, EGA_LIGHTBLUE, EGA_BLUE, 1, 8, 33,
)
# fmt: on


def tunnel() -> None:
    """A spiral that becomes narrower towards the middle: drawn once, all pixels by one call."""
    y, x = np.indices((HEIGHT, WIDTH))
    across, down = x - WIDTH / 2 + 0.5, y - HEIGHT / 2 + 0.5
    depth = 11 * np.log(np.hypot(across, down))
    twist = np.arctan2(down, across) / (2 * np.pi) * len(RING)
    place = np.int64(np.floor(depth - twist)) % len(RING)
    putpixel(x, y, np.array(RING)[place])
    setfillstyle(SOLID_FILL, BLACK)
    fillellipse(WIDTH // 2, HEIGHT // 2, 17, 17)


def colors() -> None:
    """The same, with the colours and their numbers in a row beneath."""
    tunnel()
    setfillstyle(SOLID_FILL, BLACK)
    bar(0, HEIGHT - 44, WIDTH, HEIGHT)
    setcolor(WHITE)
    for color in range(16):
        left = 4 + 40 * color
        setfillstyle(SOLID_FILL, color)
        bar(left, HEIGHT - 40, left + 31, HEIGHT - 18)
        rectangle(left, HEIGHT - 40, left + 31, HEIGHT - 18)
        outtextxy(left + 8, HEIGHT - 12, f"{color:2}")


def turn() -> None:
    """Hand every colour's look on to the next one; -1 leaves a colour as it is."""
    now = getpalette().colors
    looks = [-1] * 16
    before = RING[-1]
    for color in RING:
        looks[color] = now[before]
        before = color
    setallpalette(looks)


def other_colors() -> None:
    """The tunnel in other looks, which turn the same way."""
    colors()
    for color, look in zip(RING, LOOKS, strict=True):
        setpalette(color, look)


# The morning: a colour, and how it looks at night, at dawn and by day: red, green, blue of 0..63.
SKY = (BLUE, CYAN, LIGHTBLUE, LIGHTCYAN, RED)
LIGHTS = (
    (BLUE, (0, 0, 8), (14, 8, 30), (16, 30, 60)),
    (CYAN, (0, 0, 11), (26, 10, 30), (22, 36, 62)),
    (LIGHTBLUE, (1, 1, 14), (42, 14, 24), (30, 42, 63)),
    (LIGHTCYAN, (2, 2, 17), (58, 26, 16), (40, 48, 63)),
    (RED, (3, 3, 20), (63, 42, 16), (50, 56, 63)),
    (YELLOW, (2, 2, 14), (63, 50, 20), (63, 63, 40)),
    (DARKGRAY, (2, 2, 6), (18, 10, 18), (26, 30, 38)),
    (BROWN, (1, 1, 4), (12, 6, 12), (18, 26, 22)),
    (GREEN, (0, 1, 3), (8, 6, 8), (8, 30, 8)),
    (LIGHTGREEN, (0, 2, 4), (14, 10, 8), (18, 42, 12)),
    (LIGHTRED, (60, 50, 10), (50, 40, 10), (20, 22, 30)),
)
HALF = 90  # steps from night to dawn, and from dawn to day
DAY = 2 * HALF
# There and back, for ever.
morning = itertools.cycle([*range(1, DAY), *range(DAY, -1, -1)])


def hills() -> None:
    """A landscape of eleven colours, each of which will follow the light."""
    for row, color in enumerate(SKY):
        setfillstyle(SOLID_FILL, color)
        bar(0, 64 * row, WIDTH, 64 * row + 64)
    setfillstyle(SOLID_FILL, YELLOW)
    setcolor(YELLOW)
    fillellipse(410, 236, 44, 44)
    for color, base, high, length in (
        (DARKGRAY, 262, 44, 71),
        (BROWN, 318, 26, 97),
        (LIGHTGREEN, 362, 18, 59),
        (GREEN, 404, 12, 83),
    ):
        points = [(WIDTH, HEIGHT), (0, HEIGHT)]
        for x in range(0, WIDTH + 10, 10):
            y = base + high * (sin(x / length) + sin(x / length / 0.37 + base) / 3)
            points.append((x, round(y)))
        fillpoly(points, fill=color, color=color)
    village(140, 386)
    light(0)


def village(left: int, top: int) -> None:
    """Houses with windows, which are lit at night."""
    for x, height in ((0, 26), (34, 34), (80, 22), (112, 30)):
        setfillstyle(SOLID_FILL, BLACK)
        bar(left + x, top - height, left + x + 26, top + 6)
        roof = [(left + x - 4, top - height), (left + x + 13, top - height - 16)]
        fillpoly([*roof, (left + x + 30, top - height)], color=BLACK)
        setfillstyle(SOLID_FILL, LIGHTRED)
        bar(left + x + 5, top - height + 6, left + x + 10, top - height + 13)
        bar(left + x + 16, top - height + 6, left + x + 21, top - height + 13)


def light(step: int) -> None:
    """Mix every colour for a moment: night is 0, dawn HALF, day twice as much.

    On the VGA setrgbpalette() loads a register, and the palette tells which one a colour uses.
    """
    registers = getpalette().colors
    for color, night, dawn, day in LIGHTS:
        if step < HALF:
            red, green, blue = mix(night, dawn, step / HALF)
        else:
            red, green, blue = mix(dawn, day, step / HALF - 1)
        setrgbpalette(registers[color], red, green, blue)


def mix(before: Sequence[int], after: Sequence[int], part: float) -> list[float]:
    """Red, green and blue that part of the way from one look to another."""
    return [start + part * (end - start) for start, end in zip(before, after, strict=True)]


def lighter() -> None:
    """A little later, or earlier."""
    light(next(morning))


# The water: colours 16 to 255 of the 8514, which has a palette entry of its own for each.
WAVES = 240
shifts = itertools.count(step=2)


def water() -> None:
    """Waves from four stones, laid on top of each other; 240 colours."""
    y, x = np.indices((HEIGHT, WIDTH))
    height = np.zeros((HEIGHT, WIDTH))
    for left, top, length in ((120, 90, 23), (520, 150, 29), (330, 420, 19), (40, 400, 31)):
        height += np.sin(np.hypot(x - left, y - top) / length)
    putpixel(x, y, 16 + np.int64(height * 60 + WAVES) % WAVES)
    flow()


def flow() -> None:
    """Load all 240 entries anew, shifted by two."""
    shift = next(shifts)
    for entry in range(WAVES):
        angle = 2 * pi * (entry + shift) / WAVES
        red, green, blue = (100 + 90 * sin(angle + phase) for phase in (0, 0.9, 2))
        setrgbpalette(16 + entry, 0.6 * red, green, blue + 60)


PAGES = (
    Page("setallpalette: colours turn", colors, turn, 60),
    Page("setpalette: other looks", other_colors, turn, 60),
    Page("setrgbpalette: a morning", hills, lighter, 30),
    Page("240 colours of the 8514", water, flow, 20, (IBM8514, IBM8514LO)),
)


def draw() -> None:
    """The first page."""
    show(PAGES)


def main() -> None:
    """Leaf through the pages until Esc comes."""
    leaf_through(PAGES)


if __name__ == "__main__":
    main()
