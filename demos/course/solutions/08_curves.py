"""Lesson 8: one way to solve its exercises.

python demos/course/solutions/08_curves.py
"""

from math import cos, hypot, pi, sin

from bgi import *
from bgi.lab import check


def my_bezier(points, t):
    """Exercise 1: divide the lines between the points until one point is left."""
    while len(points) > 1:
        row = []
        for i in range(len(points) - 1):
            (x1, y1), (x2, y2) = points[i], points[i + 1]
            row.append((x1 + t * (x2 - x1), y1 + t * (y2 - y1)))
        points = row
    return points[0]


def draw_curve(points, color):
    """Fifty lines along the curve, and its points."""
    before = points[0]
    for step in range(1, 51):
        here = my_bezier(points, step / 50)
        line(round(before[0]), round(before[1]), round(here[0]), round(here[1]), color)
        before = here
    for x, y in points:
        circle(x, y, 3, color)


def my_bspline(points, t):
    """Exercise 2: four points, each with its weight."""
    s = 1 - t
    weights = [
        s**3 / 6,
        (3 * t**3 - 6 * t**2 + 4) / 6,
        (3 * s**3 - 6 * s**2 + 4) / 6,
        t**3 / 6,
    ]
    x = y = 0
    for weight, (px, py) in zip(weights, points, strict=True):
        x = x + weight * px
        y = y + weight * py
    return x, y


def closed(points, color):
    """A B-spline that ends where it began: one piece for each point."""
    count = len(points)
    before = None
    for first in range(count):
        four = [points[(first + i) % count] for i in range(4)]
        for step in range(21):
            x, y = my_bspline(four, step / 20)
            if before is not None:
                line(*before, round(x), round(y), color)
            before = round(x), round(y)


def draw_flat(points, color):
    """Exercise 3: a line where the curve is flat, else both halves; returns how many lines."""
    (x1, y1), (x2, y2) = points[0], points[-1]
    if is_flat(points):
        line(round(x1), round(y1), round(x2), round(y2), color)
        return 1
    first, second = halves(points)
    return draw_flat(first, color) + draw_flat(second, color)


def is_flat(points):
    """Whether all corners lie within half a pixel of the line between the ends.

    A corner's distance is twice the area of its triangle with the line, over the line's length.
    Where the ends are one point there is no line: then the distance from that point counts.
    """
    (x1, y1), (x2, y2) = points[0], points[-1]
    length = hypot(x2 - x1, y2 - y1)
    for x, y in points[1:-1]:
        if length == 0:
            distance = hypot(x - x1, y - y1)
        else:
            distance = abs((x2 - x1) * (y - y1) - (x - x1) * (y2 - y1)) / length
        if distance > 0.5:
            return False
    return True


def halves(points):
    """The points of the first half of a curve and of the second one."""
    first, second = [points[0]], [points[-1]]
    while len(points) > 1:
        row = []
        for i in range(len(points) - 1):
            (x1, y1), (x2, y2) = points[i], points[i + 1]
            row.append(((x1 + x2) / 2, (y1 + y2) / 2))
        points = row
        first.append(points[0])
        second.insert(0, points[-1])
    return first, second


strict()
assert check.casteljau(my_bezier)
assert check.bspline(my_bspline)
initgraph(VGA, VGAHI)
outtextxy(8, 8, "1: curves of two, three and five points")
draw_curve([(20, 60), (180, 150)], LIGHTGREEN)
draw_curve([(220, 150), (290, 30), (360, 150)], YELLOW)
draw_curve([(400, 150), (380, 30), (500, 160), (620, 30), (600, 150)], LIGHTCYAN)

outtextxy(8, 180, "2: a closed curve")
cloud = []
for i in range(16):
    far = 1.4 if i % 2 else 0.7
    cloud.append((150 + 110 * far * cos(i * pi / 8), 310 + 60 * far * sin(i * pi / 8)))
closed(cloud, WHITE)

corners = [(330, 440), (380, 130), (640, 240), (560, 440)]
count = draw_flat(corners, LIGHTRED)
outtextxy(330, 180, f"3: a curve of {count} lines")
getch()
closegraph()
