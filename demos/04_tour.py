"""Every way to draw, each in a panel of its own.

    python demos/04_tour.py

What it shows: a panel is a viewport. Inside it 0, 0 is its own corner and nothing is drawn beyond
its edges, so every panel is a few lines that know nothing of the others. Space turns the palette:
the pixels stay as they are, only the look of their colours changes. Any other key ends.
"""

from collections.abc import Callable

import numpy as np

from bgi import *

MODE = (VGA, VGAHI)
SPACE = ord(" ")
PANEL_WIDTH, PANEL_HEIGHT, GAP, TOP = 150, 138, 8, 34
# What a panel's viewport measures, without frame and caption.
WIDTH, HEIGHT = PANEL_WIDTH - 2, PANEL_HEIGHT - 16
CX, CY = WIDTH // 2, HEIGHT // 2


def pixels() -> None:
    """Sierpinski's triangle: the points whose x and y have no binary digit in common."""
    x, y = np.nonzero(np.bitwise_and.outer(np.arange(128), np.arange(HEIGHT)) == 0)
    putpixel(10 + x, y, LIGHTBLUE + (x + y) // 32)


def lines() -> None:
    """Straight lines that together look curved."""
    step = np.arange(0, 61, 4)
    line(CX, CY - step, CX - 60 + step, CY, LIGHTCYAN)
    line(CX, CY - step, CX + 60 - step, CY, LIGHTGREEN)
    line(CX, CY + step, CX - 60 + step, CY, LIGHTMAGENTA)
    line(CX, CY + step, CX + 60 - step, CY, LIGHTRED)


def line_styles() -> None:
    """The five styles, thin and thick; the last one is made of sixteen bits of our own."""
    styles = (
        (SOLID_LINE, "solid"),
        (DOTTED_LINE, "dotted"),
        (CENTER_LINE, "center"),
        (DASHED_LINE, "dashed"),
        (USERBIT_LINE, "user"),
    )
    for row, (style, name) in enumerate(styles):
        y = 13 + 24 * row
        setcolor(LIGHTGRAY)
        outtextxy(8, y - 4, name)
        setcolor(YELLOW)
        setlinestyle(style, 0b0000111100110101, NORM_WIDTH)
        line(64, y - 4, WIDTH - 9, y - 4)
        setlinestyle(style, 0b0000111100110101, THICK_WIDTH)
        line(64, y + 4, WIDTH - 9, y + 4)


def rectangles() -> None:
    """A tunnel."""
    near = 0.8 ** np.arange(12)
    left, top, color = CX - 66 * near, CY - 54 * near, 15 - np.arange(12)
    x, y = CX + 24 * (1 - near), CY - 10 * (1 - near)
    rectangle(x - CX + left, y - CY + top, x + CX - left, y + CY - top, color)


def bars() -> None:
    """The twelve fill patterns."""
    for pattern in range(USER_FILL):
        left, top = 6 + 35 * (pattern % 4), 6 + 38 * (pattern // 4)
        setfillstyle(pattern, LIGHTBLUE + pattern % 7)
        bar(left, top, left + 30, top + 33)
        rectangle(left, top, left + 30, top + 33)


def circles() -> None:
    """Circles around a circle."""
    angle = np.arange(0, 24) * np.pi / 12
    circle(CX + 28 * np.cos(angle), CY + 28 * np.sin(angle), 29, 9 + np.arange(24) % 6)


def polygons() -> None:
    """Four polygons of 361 points each, in one call."""
    turn = np.radians(np.arange(361))
    reach = np.outer((1, 0.8, 0.6, 0.4), 40 + 19 * np.cos(6 * turn))
    points = np.stack((CX + reach * np.sin(turn), CY - reach * np.cos(turn)), axis=2)
    drawpoly(points, color=(YELLOW, LIGHTRED, LIGHTMAGENTA, LIGHTBLUE))


def filled_polygons() -> None:
    """A star in one stroke: where it covers itself twice, it is empty (the even-odd rule)."""
    turn = np.radians(np.arange(0, 720, 144))
    setfillstyle(SOLID_FILL, RED)
    setcolor(YELLOW)
    fillpoly(np.stack((CX + 58 * np.sin(turn), CY + 4 - 58 * np.cos(turn)), axis=1))


def viewport() -> None:
    """What leaves the viewport is cut off."""
    radius = np.arange(6, 180, 6)
    circle(0, HEIGHT, radius, LIGHTBLUE)
    circle(WIDTH, 0, radius, LIGHTCYAN)


def xor() -> None:
    """Lines that cross in XOR mode leave a pattern that nobody drew."""
    setwritemode(XOR_PUT)
    across = np.arange(0, WIDTH, 2)
    line(CX, CY, across, 0, LIGHTMAGENTA)
    line(CX, CY, across, HEIGHT - 1, LIGHTMAGENTA)
    down = np.arange(0, HEIGHT, 2)
    line(CX, CY, 0, down, LIGHTMAGENTA)
    line(CX, CY, WIDTH - 1, down, LIGHTMAGENTA)
    setwritemode(COPY_PUT)


def text() -> None:
    """The font of the PC: code page 437."""
    rows = (
        (WHITE, "ABCDEFGHIJKLMNOP"),
        (LIGHTGRAY, "abcdefghijklmnop"),
        (YELLOW, "0123456789 +-*/="),
        (LIGHTGREEN, "ÄÖÜäöüß éèêñç ¿¡"),
        (LIGHTCYAN, "αΓπΣσµτΦΘΩδ∞φε∩√"),
        (LIGHTRED, "☺ ♥ ♦ ♣ ♠ ♂ ♀ ♫"),
        (LIGHTMAGENTA, "╔═╦═╗ ┌─┬─┐ ░▒▓█"),
        (LIGHTBLUE, "▀▄█▌▐■ ←↑→↓ ≈≤≥±"),
    )
    for row, (color, characters) in enumerate(rows):
        setcolor(color)
        outtextxy(10, 6 + 15 * row, characters)


def palette() -> None:
    """The sixteen colours and their numbers."""
    for color in range(16):
        left, top = 6 + 35 * (color % 4), 4 + 29 * (color // 4)
        setfillstyle(SOLID_FILL, color)
        bar(left, top, left + 30, top + 25)
        setcolor(WHITE if color < LIGHTGRAY or color == DARKGRAY else 0)
        number = str(color)
        outtextxy(left + 16 - textwidth(number) // 2, top + 9, number)
    setcolor(DARKGRAY)
    rectangle(6, 4, 36, 29)


PANELS: tuple[tuple[str, Callable[[], None]], ...] = (
    ("putpixel", pixels),
    ("line", lines),
    ("setlinestyle", line_styles),
    ("rectangle", rectangles),
    ("setfillstyle, bar", bars),
    ("circle", circles),
    ("drawpoly", polygons),
    ("fillpoly", filled_polygons),
    ("setviewport", viewport),
    ("setwritemode", xor),
    ("outtextxy", text),
    ("setpalette", palette),
)


def panel(place: int, title: str, content: Callable[[], None]) -> None:
    """Frame and caption on the whole screen, then the content in a viewport of its own."""
    left = GAP + place % 4 * (PANEL_WIDTH + GAP)
    top = TOP + place // 4 * (PANEL_HEIGHT + GAP)
    right, bottom = left + PANEL_WIDTH - 1, top + PANEL_HEIGHT - 1
    graphdefaults()
    setfillstyle(SOLID_FILL, BLUE)
    bar(left, top, right, top + 14)
    rectangle(left, top, right, bottom, BLUE)
    outtextxy(left + 6, top + 4, title)
    setviewport(left + 1, top + 15, right - 1, bottom - 1, 1)
    content()


def draw() -> None:
    """The whole screen."""
    for place, (title, content) in enumerate(PANELS):
        panel(place, title, content)
    graphdefaults()
    setfillstyle(SOLID_FILL, LIGHTGRAY)
    bar(0, 0, getmaxx(), 23)
    setcolor(0)
    outtextxy(GAP, 8, "graphics.h on one screen")
    keys = "space: turn the palette   any other key: end"
    outtextxy(getmaxx() - GAP - textwidth(keys), 8, keys)


def turn_palette() -> None:
    """Hand every colour's look on to the next one, but for the background's."""
    background, *colors = getpalette().colors
    setallpalette([background, colors[-1], *colors[:-1]])


def main() -> None:
    """Draw, and turn the palette until a key other than space comes."""
    initgraph(*MODE)
    draw()
    while getch() == SPACE:
        turn_palette()


if __name__ == "__main__":
    main()
