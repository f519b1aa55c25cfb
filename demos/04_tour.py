"""Every way to draw, each in a panel of its own.

    python demos/04_tour.py

What it shows: a panel is a viewport. Inside it 0, 0 is its own corner and nothing is drawn beyond
its edges, so every panel is a few lines that know nothing of the others. Space turns the palette:
the pixels stay as they are, only the look of their colours changes. Any other key ends.
"""

from collections.abc import Callable
from math import cos, pi, radians, sin

from bgi import *

MODE = (VGA, VGAHI)
SPACE = ord(" ")
PANEL_WIDTH, PANEL_HEIGHT, GAP, TOP = 150, 138, 8, 34
# What a panel's viewport measures, without frame and caption.
WIDTH, HEIGHT = PANEL_WIDTH - 2, PANEL_HEIGHT - 16
CX, CY = WIDTH // 2, HEIGHT // 2


def pixels() -> None:
    """Sierpinski's triangle: the points whose x and y have no binary digit in common."""
    for y in range(HEIGHT):
        for x in range(128):
            if x & y == 0:
                putpixel(10 + x, y, LIGHTBLUE + (x + y) // 32)


def lines() -> None:
    """Straight lines that together look curved."""
    for step in range(0, 61, 4):
        line(CX, CY - step, CX - 60 + step, CY, LIGHTCYAN)
        line(CX, CY - step, CX + 60 - step, CY, LIGHTGREEN)
        line(CX, CY + step, CX - 60 + step, CY, LIGHTMAGENTA)
        line(CX, CY + step, CX + 60 - step, CY, LIGHTRED)


def line_styles() -> None:
    """The five styles, thin and thick; the last one is made of sixteen bits of our own."""
    bits = 0b0000111100110101
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
        setlinestyle(style, bits, NORM_WIDTH)
        line(64, y - 4, WIDTH - 9, y - 4)
        setlinestyle(style, bits, THICK_WIDTH)
        line(64, y + 4, WIDTH - 9, y + 4)


def rectangles() -> None:
    """A tunnel: each frame is a little smaller than the one before, and farther to the right."""
    near = 1.0
    for color in range(WHITE, RED - 1, -1):
        x, y = CX + 24 * (1 - near), CY - 10 * (1 - near)
        rectangle(x - 66 * near, y - 54 * near, x + 66 * near, y + 54 * near, color)
        near = 0.8 * near


def bars() -> None:
    """The twelve fill patterns."""
    for pattern in range(USER_FILL):
        left, top = 6 + 35 * (pattern % 4), 6 + 38 * (pattern // 4)
        setfillstyle(pattern, LIGHTBLUE + pattern % 7)
        bar(left, top, left + 30, top + 33)
        rectangle(left, top, left + 30, top + 33)


def circles() -> None:
    """Circles around a circle."""
    for number in range(24):
        angle = number * pi / 12
        circle(CX + 28 * cos(angle), CY + 28 * sin(angle), 29, LIGHTBLUE + number % 6)


def polygons() -> None:
    """Four polygons, one inside the other, of 361 points each."""
    for size, color in ((1, YELLOW), (0.8, LIGHTRED), (0.6, LIGHTMAGENTA), (0.4, LIGHTBLUE)):
        points = []
        for degrees in range(361):
            angle = radians(degrees)
            reach = size * (40 + 19 * cos(6 * angle))
            points.append((CX + reach * sin(angle), CY - reach * cos(angle)))
        drawpoly(points, color=color)


def filled_polygons() -> None:
    """A star in one stroke: where it covers itself twice, it is empty (the even-odd rule)."""
    points = []
    for degrees in range(0, 720, 144):
        angle = radians(degrees)
        points.append((CX + 58 * sin(angle), CY + 4 - 58 * cos(angle)))
    setfillstyle(SOLID_FILL, RED)
    setcolor(YELLOW)
    fillpoly(points)


def viewport() -> None:
    """What leaves the viewport is cut off."""
    for radius in range(6, 180, 6):
        circle(0, HEIGHT, radius, LIGHTBLUE)
        circle(WIDTH, 0, radius, LIGHTCYAN)


def xor() -> None:
    """Lines that cross in XOR mode leave a pattern that nobody drew."""
    setwritemode(XOR_PUT)
    for x in range(0, WIDTH, 2):
        line(CX, CY, x, 0, LIGHTMAGENTA)
        line(CX, CY, x, HEIGHT - 1, LIGHTMAGENTA)
    for y in range(0, HEIGHT, 2):
        line(CX, CY, 0, y, LIGHTMAGENTA)
        line(CX, CY, WIDTH - 1, y, LIGHTMAGENTA)
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
        setcolor(WHITE if color < LIGHTGRAY or color == DARKGRAY else BLACK)
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
    setcolor(BLACK)
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
