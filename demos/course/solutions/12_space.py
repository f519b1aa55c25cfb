"""Lesson 12: one way to solve its exercises.

python demos/course/solutions/12_space.py
"""

from math import cos, hypot, pi, sin, tan

from bgi import *
from bgi.lab import check

THETA = pi / 4


def my_paper(x, y, z, theta, x0, y0):
    """Exercise 1: equation 1."""
    return x0 + y - x * sin(theta), y0 - z + x * cos(theta)


def draw_ripples():
    """Two families of lines; 70 pixels per unit of x and y, 50 per unit of z look good."""
    steps = [-2.5 + 0.1 * i for i in range(51)]
    for a in steps:
        draw_path([ripple(a, b) for b in steps], LIGHTGREEN)
        draw_path([ripple(b, a) for b in steps], GREEN)


def ripple(x, y):
    """Where the screen shows the surface at x, y."""
    return my_paper(70 * x, 70 * y, 50 * sin(x * x + y * y), THETA, 320, 240)


def draw_path(points, color):
    """Lines from point to point."""
    for i in range(len(points) - 1):
        (x1, y1), (x2, y2) = points[i], points[i + 1]
        line(round(x1), round(y1), round(x2), round(y2), color)


def my_projection(x, y, z, distance):
    """Exercise 2: what is twice as far from the eye appears half as large."""
    part = distance / (distance + z)
    return x * part, y * part


def draw_tunnel():
    """Frames, each 200 behind the one before, and lines that join their corners."""
    corners = [(-320, 240), (320, 240), (320, -239), (-320, -239), (-320, 240)]
    before = None
    for number in range(12):
        points = []
        for x, y in corners:
            right, up = my_projection(x, y, 200 * number, 400)
            points.append((320 + right, 240 - up))
        draw_path(points, YELLOW)
        if before is not None:
            for i in range(4):
                draw_path([before[i], points[i]], BROWN)
        before = points


def times(row, matrix):
    """A row times a matrix."""
    columns = range(len(matrix[0]))
    return [sum(row[i] * matrix[i][j] for i in range(len(row))) for j in columns]


def product(a, b):
    """A matrix times a matrix: each row of the first one times the second."""
    return [times(row, b) for row in a]


def screen_turn(degrees):
    """Exercise 3: back to space, turn, and forth to the screen, in one matrix."""
    c, s = cos(degrees * pi / 180), sin(degrees * pi / 180)
    there = [[-sin(THETA), cos(THETA), 0], [1, 0, 0], [0, -1, 1]]
    back = [[0, 1, 0], [1 / cos(THETA), tan(THETA), 0], [1 / cos(THETA), tan(THETA), 1]]
    return product(product(back, [[c, s, 0], [-s, c, 0], [0, 0, 1]]), there)


def turn(triple, matrix, x0, y0):
    """Take the origin off, turn, and add it again."""
    x, y, z = times([triple[0] - x0, triple[1] - y0, triple[2]], matrix)
    return [x + x0, y + y0, z]


def go_round():
    """How far a triple is astray: kept as it is, rounded each time, and turned as printed."""
    first = [*my_paper(100, 200, 50, THETA, 320, 240), 50]
    matrix = screen_turn(1)
    exact = rounded = first
    for _ in range(360):
        exact = turn(exact, matrix, 320, 240)
        rounded = turn(rounded, matrix, 320, 240)
        rounded = [round(rounded[0]), round(rounded[1]), rounded[2]]
    printed = times(first, matrix)
    right = turn(first, matrix, 320, 240)
    return apart(exact, first), apart(rounded, first), apart(printed, right)


def apart(a, b):
    """How many pixels are between two triples on the screen."""
    return hypot(a[0] - b[0], a[1] - b[1])


strict()
assert check.paper(my_paper)
assert check.projection(my_projection)
initgraph(VGA, VGAHI)
draw_ripples()
getch()

cleardevice()
draw_tunnel()
getch()

exact, rounded, printed = go_round()
assert exact < 1e-9
cleardevice()
outtextxy(20, 20, f"360 times one degree, kept as it is: {exact:.0e} pixels astray")
outtextxy(20, 40, f"rounded each time: {rounded:.0f} pixels astray")
outtextxy(20, 60, f"one degree, the origin not taken off: {printed:.0f} pixels astray")
getch()
closegraph()
