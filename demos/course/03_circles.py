"""Lesson 3: an ellipse by the midpoint algorithm, in its two regions.

    python demos/course/03_circles.py

Left and right change the radius to the side, up and down the other one. Space draws bgi's own
ellipse over it, Esc ends. The page: docs/course/03-circles.md.
"""

from bgi import *
from squares import enlarge

COLUMNS, ROWS = 45, 37  # what is enlarged, with the centre in the middle
CENTER_X, CENTER_Y = COLUMNS // 2, ROWS // 2
ARROWS = {72: (0, 1), 80: (0, -1), 75: (-1, 0), 77: (1, 0)}  # what getch() says after a 0
ESC, SPACE = 27, 32


def four(center_x, center_y, x, y, color):
    """A point, and its mirror images to the left, below, and both."""
    putpixel(center_x + x, center_y + y, color)
    putpixel(center_x - x, center_y + y, color)
    putpixel(center_x + x, center_y - y, color)
    putpixel(center_x - x, center_y - y, color)


def is_outside(x, y, a, b):
    """Whether a point lies outside the ellipse of the radii a and b; x and y count half pixels."""
    return b * b * x * x + a * a * y * y > 4 * a * a * b * b


def midpoint_ellipse(center_x, center_y, a, b):
    """From the top to the right end: along x while it is level, along y where it is steep."""
    x, y = 0, b
    while b * b * x < a * a * y:
        four(center_x, center_y, x, y, LIGHTCYAN)
        x += 1
        if is_outside(2 * x, 2 * y - 1, a, b):  # the middle between y and y - 1
            y -= 1
    while y >= 0:
        four(center_x, center_y, x, y, YELLOW)
        y -= 1
        if not is_outside(2 * x + 1, 2 * y, a, b):  # the middle between x and x + 1
            x += 1


def show(a, b, own):
    """The ellipse enlarged, and what it is."""
    bar(0, 0, COLUMNS, ROWS, BLACK)  # the squares show what is drawn here
    bar(490, 90, getmaxx(), 170, BLACK)
    midpoint_ellipse(CENTER_X, CENTER_Y, a, b)
    if own:
        ellipse(CENTER_X, CENTER_Y, 0, 360, a, b, LIGHTRED)
    putpixel(CENTER_X, CENTER_Y, DARKGRAY)
    enlarge(COLUMNS, ROWS, size=10, left=10, top=50)
    outtextxy(490, 90, f"radii {a} and {b}")
    outtextxy(490, 120, "cyan: along x")
    outtextxy(490, 140, "yellow: along y")
    if own:
        outtextxy(490, 160, "red: ellipse()")


strict()
initgraph(VGA, VGAHI)
a, b = 20, 12
own = False
key = 0
while key != ESC:
    show(a, b, own)
    key = getch()
    if key == SPACE:
        own = not own
    elif key == 0:  # an arrow: which one, the next number says
        right, up = ARROWS.get(getch(), (0, 0))
        a = min(max(a + right, 1), CENTER_X)
        b = min(max(b + up, 1), CENTER_Y)
closegraph()
