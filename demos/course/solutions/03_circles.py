"""Lesson 3: one way to solve its exercises.

    python demos/course/solutions/03_circles.py

The exercises stand on the page docs/course/03-circles.md.
"""

from math import sqrt

from bgi import *
from bgi.lab import check


def eighths(x, y, radius, color):
    """Exercise 1: an eighth by the root, and its seven mirror images."""
    across = 0
    down = radius
    while across <= down:
        for dx, dy in ((across, down), (down, across)):
            for right, below in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
                putpixel(x + right * dx, y + below * dy, color)
        across += 1
        down = round(sqrt(max(radius * radius - across * across, 0)))


def four(center_x, center_y, x, y, color):
    """A point of an ellipse, and its three mirror images."""
    for right, down in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        putpixel(center_x + right * x, center_y + down * y, color)


def additions(center_x, center_y, a, b, color):
    """Exercise 2: the midpoint ellipse, whose decision is kept up to date by additions."""
    a2, b2 = a * a, b * b
    x, y = 0, b
    right, down = 0, 2 * a2 * y  # 2 b² x and 2 a² y: what a step changes the decision by
    decision = 4 * b2 - 4 * a2 * b + a2  # four times the value at the first middle
    while right < down:
        four(center_x, center_y, x, y, color)
        x += 1
        right += 2 * b2
        if decision > 0:
            y -= 1
            down -= 2 * a2
            decision -= 4 * down
        decision += 4 * (right + b2)
    decision = b2 * (2 * x + 1) ** 2 + 4 * a2 * (y - 1) ** 2 - 4 * a2 * b2
    while y >= 0:
        four(center_x, center_y, x, y, color)
        y -= 1
        down -= 2 * a2
        if decision <= 0:
            x += 1
            right += 2 * b2
            decision += 4 * right
        decision += 4 * (a2 - down)
    return x


def flat(center_x, center_y, a, b, color):
    """Exercise 3: the row in the middle goes on to the ends, where the second region came late."""
    for x in range(additions(center_x, center_y, a, b, color), a + 1):
        four(center_x, center_y, x, 0, color)


strict()
initgraph(VGA, VGAHI)
for radius in range(0, 100, 9):
    eighths(110, 120, radius, YELLOW)
    additions(320, 120, radius, 100 - radius, LIGHTGREEN)
for height in range(12):
    flat(320, 260 + 18 * height, 300, height, LIGHTCYAN)
    assert getpixel(20, 260 + 18 * height) == getpixel(620, 260 + 18 * height) == LIGHTCYAN
flat(560, 120, 0, 0, LIGHTCYAN)
flat(560, 120, 0, 100, LIGHTCYAN)
assert getpixel(560, 20) == getpixel(560, 220) == LIGHTCYAN
check.circle(eighths)
check.ellipse(additions)
check.ellipse(flat)
getch()
closegraph()
