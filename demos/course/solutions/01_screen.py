"""Lesson 1: one way to solve its exercises.

    python demos/course/solutions/01_screen.py

The exercises stand on the page docs/course/01-screen.md.
"""

from pathlib import Path

from bgi import *
from bgi.lab import check

EXPECTED = Path(__file__).parents[1] / "expected"


def frame(color):
    """Exercise 1: the outermost pixels of the screen."""
    right, bottom = getmaxx(), getmaxy()
    for x in range(right + 1):
        putpixel(x, 0, color)
        putpixel(x, bottom, color)
    for y in range(bottom + 1):
        putpixel(0, y, color)
        putpixel(right, y, color)


def chessboard(left, top, side):
    """Exercise 2: eight times eight squares; the upper left one is white."""
    for y in range(8 * side):
        for x in range(8 * side):
            is_white = (x // side + y // side) % 2 == 0
            putpixel(left + x, top + y, WHITE if is_white else BLUE)


def plot(x, y, color):
    """Exercise 3: a pixel as in mathematics, 0, 0 in the middle and y upwards."""
    putpixel(320 + x, 240 - y, color)


strict()
initgraph(VGA, VGAHI)
frame(YELLOW)
check.picture(EXPECTED / "01_frame.png")

cleardevice()
chessboard(20, 20, 16)
check.picture(EXPECTED / "01_chessboard.png")

cleardevice()
for x in range(-320, 320):
    plot(x, 0, DARKGRAY)
for y in range(-239, 241):
    plot(0, y, DARKGRAY)
for x in range(-150, 151):
    plot(x, x * x // 100, LIGHTGREEN)
check.picture(EXPECTED / "01_parabola.png")
getch()
closegraph()
