"""Lesson 8: a curve is points between points.

    python demos/course/08_curves.py

Four points make a curve. Between each two neighbours lies a point, part t of the way; between those
points lie others, and at last there is one: it is on the curve. + and - change t; 1 to 4 choose a
point, the arrows move it, b shows the B-spline of the points, Esc ends. The page:
docs/course/08-curves.md.
"""

from bgi import *

ESC = 27
STEPS = 50  # the curve is drawn as so many short lines
COLORS = [DARKGRAY, LIGHTBLUE, LIGHTGREEN, WHITE]  # of each row of points between points


def between(p, q, t):
    """The point that lies part t of the way from p to q."""
    return p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])


def shorter(points, t):
    """The points between neighbours: one less than there were."""
    row = []
    for i in range(len(points) - 1):
        row.append(between(points[i], points[i + 1], t))
    return row


def bezier(points, t):
    """The point of the curve at t, which runs from 0 to 1: de Casteljau's way."""
    while len(points) > 1:
        points = shorter(points, t)
    return points[0]


def bspline(points, t):
    """The point at t of a uniform cubic B-spline: the four points, each with its weight."""
    s = 1 - t
    weights = [
        s**3 / 6,
        (3 * t**3 - 6 * t**2 + 4) / 6,
        (3 * s**3 - 6 * s**2 + 4) / 6,
        t**3 / 6,
    ]
    x = sum(weights[i] * points[i][0] for i in range(4))
    y = sum(weights[i] * points[i][1] for i in range(4))
    return x, y


def draw_path(points, color):
    """Lines from point to point."""
    for i in range(len(points) - 1):
        (x1, y1), (x2, y2) = points[i], points[i + 1]
        line(round(x1), round(y1), round(x2), round(y2), color)


def draw_dots(points, color):
    """A dot at every point."""
    setcolor(color)
    setfillstyle(SOLID_FILL, color)
    for x, y in points:
        fillellipse(round(x), round(y), 4, 4)


def draw_rows(points, t):
    """De Casteljau's points between points, row by row, down to the one on the curve."""
    for color in COLORS:
        draw_path(points, color)
        draw_dots(points, color)
        points = shorter(points, t)


def draw(points, chosen, t, curve):
    """The picture: the curve, what leads to it, and the numbers."""
    cleardevice()
    if curve is bezier:
        draw_rows(points, t)
    else:
        draw_path(points, DARKGRAY)
        draw_dots(points, DARKGRAY)
    path = [curve(points, step / STEPS) for step in range(STEPS + 1)]
    draw_path(path, YELLOW)
    draw_dots([curve(points, t)], WHITE)
    draw_dots([points[chosen]], LIGHTRED)
    setcolor(LIGHTGRAY)
    for i, (x, y) in enumerate(points):
        outtextxy(x + 8, y - 12, str(i + 1))
    name = "Bézier" if curve is bezier else "B-spline"
    outtextxy(8, 8, f"{name}, t = {t:.2f}")
    outtextxy(8, 464, "+ - change t   1 2 3 4 choose   arrows move   b other curve   Esc end")
    swapbuffers()


strict()
initgraph(VGA, VGAHI)
points = [(90, 400), (170, 90), (470, 70), (560, 370)]
chosen = 0
hundredths = 40  # t, as a whole number: so steps add up exactly
curve = bezier
key = 0
while key != ESC:
    draw(points, chosen, hundredths / 100, curve)
    key = getch()
    if key == 0:  # an arrow: a second number says which
        scan = getch()
        x, y = points[chosen]
        x = x + 10 * ((scan == 77) - (scan == 75))
        y = y + 10 * ((scan == 80) - (scan == 72))
        points[chosen] = (x, y)
    elif key == ord("+"):
        hundredths = min(100, hundredths + 5)
    elif key == ord("-"):
        hundredths = max(0, hundredths - 5)
    elif key == ord("b"):
        curve = bspline if curve is bezier else bezier
    elif ord("1") <= key <= ord("4"):
        chosen = key - ord("1")
