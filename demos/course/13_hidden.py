"""Lesson 13: what is near hides what is far.

    python demos/course/13_hidden.py

A mesh of lines shows everything, also what should be hidden. The painter begins at the back and
paints over it. The floating horizon begins at the front, and draws only what sticks out above or
below all that is there. The z-buffer asks at each pixel whether something nearer has been set. 1 to
4 choose the way, Esc ends. Watch them with --slow 20000. The page: docs/course/13-hidden.md.
"""

from math import cos, exp, pi, sin

from bgi import *

ESC = 27
N = 32  # cells in each direction
THETA = pi / 4
X0, Y0 = 320, 230
SIDE, HIGH = 36, 85  # pixels per unit
WAYS = ["a mesh of lines", "painter's algorithm", "floating horizon", "z-buffer"]


def height(x, y):
    """The hill: rings that become lower farther out."""
    far = x * x + y * y
    return cos(far / 2) * exp(-far / 12)


def place(i, j):
    """Point i, j of the mesh: where it is on the screen, and how far toward us it lies."""
    x = 8 * i / N - 4  # toward us
    y = 8 * j / N - 4
    across = X0 + SIDE * (y - x * sin(THETA))
    down = Y0 + SIDE * x * cos(THETA) - HIGH * height(x, y)
    return across, down, x


def color_of(i, j):
    """A colour by the height of the cell."""
    z = height(8 * (i + 0.5) / N - 4, 8 * (j + 0.5) / N - 4)
    return [BLUE, CYAN, GREEN, LIGHTGREEN, YELLOW, WHITE][min(5, int((z + 0.7) * 4))]


def corners(i, j):
    """The four corners of a cell, around it."""
    return [POINTS[i][j], POINTS[i][j + 1], POINTS[i + 1][j + 1], POINTS[i + 1][j]]


def draw_mesh():
    """All lines, those behind too."""
    for i in range(N):
        for j in range(N):
            flat = [(round(x), round(y)) for x, y, _ in corners(i, j)]
            drawpoly([*flat, flat[0]])


def draw_painter():
    """Cell by cell, the farthest row first: what comes later covers what was there."""
    for i in range(N):
        for j in range(N):
            flat = [(round(x), round(y)) for x, y, _ in corners(i, j)]
            fillpoly(flat, fill=color_of(i, j), color=DARKGRAY)


def draw_horizon():
    """Line by line, the nearest first: each is seen where it leaves what was drawn so far."""
    highest = [getmaxy() + 1] * (getmaxx() + 1)  # of each column, so far
    lowest = [-1] * (getmaxx() + 1)
    for i in range(N, -1, -1):
        before = None  # where the line was seen in the column before
        for x, y in columns(POINTS[i]):
            seen = y < highest[x] or y > lowest[x]
            if seen and before is not None:
                line(x - 1, before, x, y)
            elif seen:
                putpixel(x, y, getcolor())
            before = y if seen else None
            highest[x] = min(highest[x], y)
            lowest[x] = max(lowest[x], y)


def columns(points):
    """The pixels of a line from point to point, one in each column."""
    pixels = []
    for j in range(len(points) - 1):
        (x1, y1, _), (x2, y2, _) = points[j], points[j + 1]
        for x in range(round(x1), round(x2)):
            pixels.append((x, round(y1 + (y2 - y1) * (x - x1) / (x2 - x1))))
    return pixels


def draw_zbuffer():
    """Cell by cell in any order: a pixel is set where nothing nearer is."""
    nearest = [[-1000.0] * 640 for _ in range(480)]  # of each pixel, how near it is so far
    for i in range(N):
        for j in range(N):
            a, b, c, d = corners(i, j)
            fill_triangle(a, b, c, color_of(i, j), nearest)
            fill_triangle(a, c, d, color_of(i, j), nearest)


def fill_triangle(a, b, c, color, nearest):
    """Set those pixels of a triangle that are nearer than what is there."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    if area == 0:
        return
    for y in range(round(min(a[1], b[1], c[1])), round(max(a[1], b[1], c[1])) + 1):
        for x in range(round(min(a[0], b[0], c[0])), round(max(a[0], b[0], c[0])) + 1):
            # How much of a, b and c is in this pixel: three parts that add up to 1.
            part_b = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area
            part_c = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area
            part_a = 1 - part_b - part_c
            if min(part_a, part_b, part_c) >= 0:
                near = part_a * a[2] + part_b * b[2] + part_c * c[2]
                if near > nearest[y][x]:
                    nearest[y][x] = near
                    putpixel(x, y, color)


strict()
initgraph(VGA, VGAHI)
POINTS = [[place(i, j) for j in range(N + 1)] for i in range(N + 1)]
DRAW = [draw_mesh, draw_painter, draw_horizon, draw_zbuffer]
key = ord("1")
while key != ESC:
    if ord("1") <= key <= ord("4"):
        cleardevice()
        setcolor(WHITE)
        outtextxy(8, 8, WAYS[key - ord("1")])
        outtextxy(8, 464, "1 mesh   2 painter   3 horizon   4 z-buffer   Esc end")
        setcolor(LIGHTCYAN)
        DRAW[key - ord("1")]()
    key = getch()
