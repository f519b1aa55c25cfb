"""Lesson 14: figures that are made of themselves.

    python demos/course/14_fractals.py

A tree is a branch with two smaller trees at its end; one rule, applied again and again, draws it
all. A function that calls itself needs to know when to stop: its depth says so. 1 a tree, 2 a
snowflake, 3 triangles in triangles, 4 Mandelbrot's set; + and - change the depth, Esc ends. Watch
them grow with --slow 1000. The page: docs/course/14-fractals.md.
"""

from math import cos, pi, sin

from bgi import *

ESC = 27
CORNERS = [(320, 30), (502, 345), (138, 345)]  # of the triangle that becomes a snowflake
NAMES = ["a tree", "Koch's snowflake", "Sierpinski's triangle", "Mandelbrot's set"]


def draw_tree(x, y, angle, length, depth):
    """A branch, and at its end two smaller trees."""
    if depth == 0:
        return
    end_x = x + length * cos(angle)
    end_y = y - length * sin(angle)
    color = BROWN if depth > 2 else LIGHTGREEN
    line(round(x), round(y), round(end_x), round(end_y), color)
    draw_tree(end_x, end_y, angle + pi / 6, length * 0.75, depth - 1)
    draw_tree(end_x, end_y, angle - pi / 5, length * 0.7, depth - 1)


def draw_side(x1, y1, x2, y2, depth):
    """A line; or, with a depth, four smaller sides, of which the middle two make a peak."""
    if depth == 0:
        line(round(x1), round(y1), round(x2), round(y2), LIGHTCYAN)
        return
    dx, dy = (x2 - x1) / 3, (y2 - y1) / 3
    peak_x = x1 + 1.5 * dx + dy * 3**0.5 / 2
    peak_y = y1 + 1.5 * dy - dx * 3**0.5 / 2
    draw_side(x1, y1, x1 + dx, y1 + dy, depth - 1)
    draw_side(x1 + dx, y1 + dy, peak_x, peak_y, depth - 1)
    draw_side(peak_x, peak_y, x2 - dx, y2 - dy, depth - 1)
    draw_side(x2 - dx, y2 - dy, x2, y2, depth - 1)


def draw_triangles(a, b, c, depth):
    """A triangle; or, with a depth, three of half its size in its corners."""
    if depth == 0:
        corners = [(round(x), round(y)) for x, y in (a, b, c)]
        fillpoly(corners, fill=YELLOW, color=YELLOW)
        return
    ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
    draw_triangles(a, ab, ca, depth - 1)
    draw_triangles(ab, b, bc, depth - 1)
    draw_triangles(ca, bc, c, depth - 1)


def middle(p, q):
    """The point half way between two."""
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2


def draw_mandelbrot(most):
    """Colour each point by how long z*z + c stays small; black where it always does."""
    for y in range(30, 450):
        for x in range(40, 600):
            c = complex((x - 420) / 190, (y - 240) / 190)
            putpixel(x, y, steps_to_leave(c, most) % 16)


def steps_to_leave(c, most):
    """After how many steps z is farther than 2 from 0; 0 where it is not after the most."""
    z = 0
    for step in range(1, most + 1):
        z = z * z + c
        if z.real * z.real + z.imag * z.imag > 4:
            return step
    return 0


def draw(number, depth):
    """One of the figures."""
    cleardevice()
    setcolor(WHITE)
    outtextxy(8, 8, f"{NAMES[number]}, depth {depth}")
    outtextxy(8, 464, "1 2 3 4 figures   + - depth   Esc end")
    if number == 0:
        draw_tree(320, 450, pi / 2, 110, depth + 4)
    elif number == 1:
        for i in range(3):
            draw_side(*CORNERS[i], *CORNERS[i - 2], depth)
    elif number == 2:
        draw_triangles((320, 30), (80, 446), (560, 446), depth)
    else:
        draw_mandelbrot(5 * depth)


strict()
initgraph(VGA, VGAHI)
number, depth = 0, 4
key = 0
while key != ESC:
    draw(number, depth)
    key = getch()
    if ord("1") <= key <= ord("4"):
        number = key - ord("1")
    elif key == ord("+"):
        depth = min(8, depth + 1)
    elif key == ord("-"):
        depth = max(1, depth - 1)
