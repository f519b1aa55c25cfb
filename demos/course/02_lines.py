"""Lesson 2: four ways to draw a line, and where they fail.

    python demos/course/02_lines.py

The arrow keys move the end of the line round its beginning, Esc ends. Which of the four are right
in every direction? The page: docs/course/02-lines.md.
"""

from math import floor

from bgi import *
from squares import enlarge

COLUMNS, ROWS = 21, 13  # what is enlarged; the line begins in the middle
ARROWS = {72: (0, -1), 80: (0, 1), 75: (-1, 0), 77: (1, 0)}  # what getch() says after a 0
ESC = 27


def slope_line(x1, y1, x2, y2, color):
    """One pixel in each column."""
    if x1 == x2:
        return  # a division by zero
    slope = (y2 - y1) / (x2 - x1)
    for x in range(x1, x2 + 1):
        putpixel(x, floor(y1 + slope * (x - x1) + 0.5), color)


def dda_line(x1, y1, x2, y2, color):
    """As many steps as the longer side has; each adds the same to x and to y."""
    steps = max(abs(x2 - x1), abs(y2 - y1), 1)
    x, y = x1, y1
    for _ in range(steps + 1):
        putpixel(floor(x + 0.5), floor(y + 0.5), color)
        x += (x2 - x1) / steps
        y += (y2 - y1) / steps


def midpoint_line(x1, y1, x2, y2, color):
    """Whole numbers only: on which side of the line is the middle between two pixels?"""
    dx, dy = x2 - x1, y2 - y1
    decision = 2 * dy - dx
    y = y1
    for x in range(x1, x2 + 1):
        putpixel(x, y, color)
        if decision > 0:
            y += 1
            decision -= 2 * dx
        decision += 2 * dy


def bresenham_line(x1, y1, x2, y2, color):
    """Whole numbers only, and every direction."""
    dx, dy = abs(x2 - x1), abs(y2 - y1)
    step_x = 1 if x1 < x2 else -1
    step_y = 1 if y1 < y2 else -1
    longer = max(dx, dy)
    x, y, error = x1, y1, longer // 2
    for _ in range(longer + 1):
        putpixel(x, y, color)
        error -= min(dx, dy)
        aside = error < 0  # a step along the shorter side, too
        if aside:
            error += longer
        if dx >= dy or aside:
            x += step_x
        if dx < dy or aside:
            y += step_y


WAYS = {
    "slope": slope_line,
    "DDA": dda_line,
    "midpoint": midpoint_line,
    "Bresenham": bresenham_line,
}


def show(end_x, end_y):
    """Each way in a panel of its own."""
    for number, (name, draw) in enumerate(WAYS.items()):
        bar(0, 0, COLUMNS, ROWS, BLACK)  # the panels show what is drawn here
        draw(COLUMNS // 2, ROWS // 2, end_x, end_y, LIGHTCYAN)
        putpixel(COLUMNS // 2, ROWS // 2, LIGHTRED)
        left, top = 320 * (number % 2), 30 + 230 * (number // 2)
        outtextxy(left + 24, top, name)
        enlarge(COLUMNS, ROWS, size=13, left=left, top=top + 10)


strict()
initgraph(VGA, VGAHI)
x, y = 16, 9
key = 0
while key != ESC:
    show(x, y)
    key = getch()
    if key == 0:  # an arrow: which one, the next number says
        right, down = ARROWS.get(getch(), (0, 0))
        x = min(max(x + right, 0), COLUMNS - 1)
        y = min(max(y + down, 0), ROWS - 1)
closegraph()
