"""Lesson 4: one way to solve its exercises.

    python demos/course/solutions/04_polygons.py

The exercises stand on the page docs/course/04-polygons.md.
"""

from itertools import pairwise
from math import ceil, cos, pi, sin

from bgi import *
from bgi.lab import check


def edges(points):
    """The edges that are not level: each its upper end, its lower end, and 1 for downwards."""
    for i in range(len(points)):
        (x1, y1), (x2, y2) = points[i - 1], points[i]
        if y1 < y2:
            yield x1, y1, x2, y2, 1
        elif y1 > y2:
            yield x2, y2, x1, y1, -1


def rows(points):
    """The rows that a polygon has."""
    heights = [y for _, y in points]
    return range(min(heights), max(heights))


def striped(points, color):
    """Exercise 1: pixels are set only where x + y leaves 0 or 1 when divided by 4."""
    for y in rows(points):
        xs = []
        for x1, y1, x2, y2, _ in edges(points):
            if y1 <= y < y2:
                xs.append(x1 + (x2 - x1) * (y - y1) / (y2 - y1))
        xs.sort()
        for left, right in zip(xs[::2], xs[1::2], strict=True):
            for x in range(ceil(left), ceil(right)):
                if (x + y) % 4 < 2:
                    putpixel(x, y, color)


def whole_numbers(points, color):
    """Exercise 2: a crossing is rounded up by //, which rounds down what is negative."""
    for y in rows(points):
        xs = []
        for x1, y1, x2, y2, _ in edges(points):
            if y1 <= y < y2:
                xs.append(x1 - (x2 - x1) * (y - y1) // (y1 - y2))
        xs.sort()
        for left, right in zip(xs[::2], xs[1::2], strict=True):
            for x in range(left, right):
                putpixel(x, y, color)


def winding(points, color):
    """Exercise 3: inside is where the edges to the left do not go up as often as down."""
    for y in rows(points):
        crossings = []
        for x1, y1, x2, y2, direction in edges(points):
            if y1 <= y < y2:
                crossings.append((x1 + (x2 - x1) * (y - y1) / (y2 - y1), direction))
        crossings.sort()
        turns = 0
        for (left, direction), (right, _) in pairwise(crossings):
            turns += direction
            if turns != 0:
                for x in range(ceil(left), ceil(right)):
                    putpixel(x, y, color)


def star(x, y, radius):
    """The corners of a star of one stroke."""
    angles = [4 * pi * corner / 5 for corner in range(5)]
    return [(round(x + radius * sin(a)), round(y - radius * cos(a))) for a in angles]


strict()
initgraph(VGA, VGAHI)
striped(star(110, 120, 100), YELLOW)
whole_numbers(star(320, 120, 100), LIGHTGREEN)
winding(star(530, 120, 100), LIGHTCYAN)
ribbon = [(20, 260), (300, 440), (600, 260), (600, 440), (300, 260), (20, 440)]
striped(ribbon, LIGHTRED)
check.polygon(whole_numbers)
getch()
closegraph()
