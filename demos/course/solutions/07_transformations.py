"""Lesson 7: one way to solve its exercises.

    python demos/course/solutions/07_transformations.py

The exercises stand on the page docs/course/07-transformations.md.
"""

from math import cos, radians, sin

from bgi import *
from bgi.lab import check


def translation(tx, ty):
    """Exercise 1: what moves stands in the last column."""
    return [[1, 0, tx], [0, 1, ty], [0, 0, 1]]


def scaling(sx, sy):
    """What stretches stands on the diagonal."""
    return [[sx, 0, 0], [0, sy, 0], [0, 0, 1]]


def rotation(degrees):
    """Where the points 1, 0 and 0, 1 go, in columns."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def product(*factors):
    """One matrix for several; the last of them acts first."""
    first = factors[-1]
    for second in reversed(factors[:-1]):
        first = [[sum(row[k] * first[k][i] for k in range(3)) for i in range(3)] for row in second]
    return first


def applied(matrix, points):
    """Whole numbers for the screen."""
    (a, b, c), (d, e, f), _ = matrix
    return [(round(a * x + b * y + c), round(d * x + e * y + f)) for x, y in points]


def turn_about(degrees, x, y):
    """Exercise 2: bring the point to 0, 0, turn, and bring it back."""
    return product(translation(x, y), rotation(degrees), translation(-x, -y))


def mirror(degrees, x, y):
    """A mirror through x, y at that angle: turn it level, exchange above and below, turn back."""
    return product(turn_about(degrees, x, y), about_y(y), turn_about(-degrees, x, y))


def about_y(y):
    """A level mirror."""
    return product(translation(0, y), scaling(1, -1), translation(0, -y))


def window_to_viewport(window, viewport):
    """Exercise 3: its corner to 0, 0, stretched to the right size, moved to the other corner."""
    left, top, right, bottom = window
    to_left, to_top, to_right, to_bottom = viewport
    return product(
        translation(to_left, to_top),
        scaling((to_right - to_left) / (right - left), (to_bottom - to_top) / (bottom - top)),
        translation(-left, -top),
    )


def draw(points, color):
    """A closed outline."""
    setcolor(color)
    drawpoly([*points, points[0]])


strict()
initgraph(VGA, VGAHI)
flag = [(200, 120), (200, 30), (290, 55), (200, 80)]
for degrees in range(0, 360, 30):
    draw(applied(turn_about(degrees, 140, 120), flag[1:]), YELLOW)
line(330, 220, 630, 60, DARKGRAY)
draw(flag := applied(translation(200, 10), flag), LIGHTGREEN)
draw(applied(mirror(-28, 330, 220), flag), LIGHTCYAN)

wave = [(x / 10, sin(x / 10)) for x in range(-63, 64)]
for viewport in ((20, 270, 420, 460), (440, 270, 620, 350), (440, 370, 620, 460)):
    rectangle(*viewport, WHITE)
    setcolor(LIGHTRED)
    drawpoly(applied(window_to_viewport((-6.3, 1.2, 6.3, -1.2), viewport), wave))
check.translation(translation)
check.scaling(scaling)
check.rotation(rotation)
check.about(turn_about)
check.window_to_viewport(window_to_viewport)
getch()
closegraph()
