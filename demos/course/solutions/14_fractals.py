"""Lesson 14: one way to solve its exercises.

python demos/course/solutions/14_fractals.py
"""

from bgi import *


def carpet(x, y, size, depth):
    """Exercise 1: the middle ninth black, and the same with the other eight.

    It returns how many squares it has painted: 1 + 8 + 64 + 512 = 585 at depth 4.
    """
    if depth == 0:
        return 0
    third = size // 3
    bar(x + third, y + third, x + 2 * third - 1, y + 2 * third - 1, BLACK)
    painted = 1
    for row in range(3):
        for column in range(3):
            if (row, column) != (1, 1):
                painted = painted + carpet(x + column * third, y + row * third, third, depth - 1)
    return painted


def dragon(x1, y1, x2, y2, depth, turn=1):
    """Exercise 2: a line becomes two, with a peak to the left (turn 1) or to the right (-1)."""
    if depth == 0:
        line(round(x1), round(y1), round(x2), round(y2), LIGHTRED)
        return
    dx, dy = (x2 - x1) / 2, (y2 - y1) / 2
    peak_x = x1 + dx + turn * dy
    peak_y = y1 + dy - turn * dx
    dragon(x1, y1, peak_x, peak_y, depth - 1, 1)
    dragon(peak_x, peak_y, x2, y2, depth - 1, -1)


def steps_to_leave(c, most):
    """After how many steps z is farther than 2 from 0; 0 where it is not after the most."""
    z = 0
    for step in range(1, most + 1):
        z = z * z + c
        if z.real * z.real + z.imag * z.imag > 4:
            return step
    return 0


def mandelbrot(left, top, middle, width, most):
    """Exercise 3: 200 by 150 pixels of the set, at left, top on the screen.

    The larger the picture, the more steps it takes until neighbours differ: so `most` must grow.
    After fourteen enlargements neighbouring pixels are the same number: it has 16 digits only.
    """
    for y in range(150):
        for x in range(200):
            c = middle + complex(x - 100, y - 75) * width / 200
            putpixel(left + x, top + y, steps_to_leave(c, most) % 16)


strict()
initgraph(VGA, VGAHI)
bar(20, 20, 20 + 242, 20 + 242, YELLOW)
assert carpet(20, 20, 243, 4) == 1 + 8 + 64 + 512
dragon(360, 300, 570, 300, 12)
getch()

cleardevice()
for number in range(4):
    left, top = 10 + 210 * (number % 2), 10 + 160 * (number // 2)
    mandelbrot(left, top, -0.7453 + 0.1127j, 3 / 10**number, 30 * 2**number)
getch()
closegraph()
