"""Lesson 12: three numbers become two.

    python demos/course/12_space.py

A point of space has three numbers, a point of the screen two. The paper's map leans the third axis
to the left; looking from the front drops it; perspective divides by the distance, so what is far is
small. p takes another way, left and right turn the house, up and down tilt it, + and - change the
angle of the paper's axis or the distance of the eye, Esc ends. The page: docs/course/12-space.md.
"""

from math import cos, pi, sin

from bgi import *

ESC = 27
X0, Y0 = 320, 250  # where the middle of space lies on the screen
SCALE = 90  # pixels per unit
WAYS = ["the paper's map", "from the front", "perspective"]

# The house: x toward us, y to the right, z up.
CORNERS = [
    (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, -1),
    (1, -1, 0.4), (1, 1, 0.4), (-1, 1, 0.4), (-1, -1, 0.4),
    (1, 0, 1.2), (-1, 0, 1.2),
    (1, -0.3, -1), (1, -0.3, -0.2), (1, 0.3, -0.2), (1, 0.3, -1),
]  # fmt: skip
EDGES = [
    (0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 7), (5, 6),
    (4, 8), (8, 5), (7, 9), (9, 6), (8, 9), (10, 11), (11, 12), (12, 13),
]  # fmt: skip
AXES = [((1.8, 0, 0), "x"), ((0, 1.8, 0), "y"), ((0, 0, 1.8), "z")]


def turned(point, turn, tilt):
    """The point, turned about the z axis and then tilted about the y axis; in radians."""
    x, y, z = point
    x, y = x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn)
    x, z = x * cos(tilt) + z * sin(tilt), z * cos(tilt) - x * sin(tilt)
    return x, y, z


def paper(x, y, z, theta):
    """Equation 1: two numbers of three; the x axis leans theta away from straight down."""
    return y - x * sin(theta), x * cos(theta) - z


def front(x, y, z):
    """Parallel rays from the front: x does not count."""
    return y, -z


def perspective(x, y, z, distance):
    """Rays into an eye at x = distance: what is twice as far away is half as large."""
    size = distance / (distance - x)
    return y * size, -z * size


def project(point):
    """Where a point of space lies on the screen, the way that is chosen now."""
    x, y, z = turned(point, turn * pi / 180, tilt * pi / 180)
    if way == 0:
        across, down = paper(x, y, z, theta * pi / 180)
    elif way == 1:
        across, down = front(x, y, z)
    else:
        across, down = perspective(x, y, z, distance)
    return round(X0 + SCALE * across), round(Y0 + SCALE * down)


def draw_line(start, end, color):
    """A line between two points of space."""
    x1, y1 = project(start)
    x2, y2 = project(end)
    line(x1, y1, x2, y2, color)


def draw():
    """The axes, the house, and the numbers."""
    cleardevice()
    for end, name in AXES:
        draw_line((0, 0, 0), end, DARKGRAY)
        setcolor(LIGHTGRAY)
        x, y = project(end)
        outtextxy(x + 4, y - 4, name)
    for i, (first, second) in enumerate(EDGES):
        color = YELLOW if i < 15 else LIGHTRED
        draw_line(CORNERS[first], CORNERS[second], color)
    setcolor(WHITE)
    number = [f", theta = {theta}", "", f", the eye at {distance}"][way]
    outtextxy(8, 8, f"{WAYS[way]}{number}; turned by {turn}, tilted by {tilt} degrees")
    outtextxy(8, 464, "p another way   arrows turn and tilt   + - change   Esc end")
    swapbuffers()


strict()
initgraph(VGA, VGAHI)
way = 0
turn, tilt, theta = 0, 0, 45  # degrees
distance = 4
key = 0
while key != ESC:
    draw()
    key = getch()
    if key == 0:
        scan = getch()
        turn = turn + 5 * ((scan == 77) - (scan == 75))
        tilt = tilt + 5 * ((scan == 80) - (scan == 72))
    elif key == ord("p"):
        way = (way + 1) % 3
    elif key in (ord("+"), ord("-")):
        step = 1 if key == ord("+") else -1
        if way == 0:
            theta = min(85, max(5, theta + 5 * step))
        if way == 2:
            distance = min(20, max(3, distance + step))
