"""Lesson 2: one way to solve its exercises.

    python demos/course/solutions/02_lines.py

The exercises stand on the page docs/course/02-lines.md.
"""

from bgi import *
from bgi.lab import check


def every_direction(x1, y1, x2, y2, color):
    """Exercise 1: the slope, along x or along y, from whichever end comes first."""
    if x1 == x2 and y1 == y2:
        putpixel(x1, y1, color)
    elif abs(x2 - x1) >= abs(y2 - y1):
        slope = (y2 - y1) / (x2 - x1)
        for x in range(min(x1, x2), max(x1, x2) + 1):
            putpixel(x, round(y1 + slope * (x - x1)), color)
    else:
        slope = (x2 - x1) / (y2 - y1)
        for y in range(min(y1, y2), max(y1, y2) + 1):
            putpixel(round(x1 + slope * (y - y1)), y, color)


def whole_numbers(x1, y1, x2, y2, color):
    """Exercise 2: Bresenham's line, with a decision for each of the two cases."""
    dx, dy = abs(x2 - x1), abs(y2 - y1)
    step_x = 1 if x1 < x2 else -1
    step_y = 1 if y1 < y2 else -1
    x, y = x1, y1
    if dx >= dy:
        decision = 2 * dy - dx
        for _ in range(dx + 1):
            putpixel(x, y, color)
            if decision > 0:
                y += step_y
                decision -= 2 * dx
            x += step_x
            decision += 2 * dy
    else:
        decision = 2 * dx - dy
        for _ in range(dy + 1):
            putpixel(x, y, color)
            if decision > 0:
                x += step_x
                decision -= 2 * dy
            y += step_y
            decision += 2 * dx


def same_as_bgi(x1, y1, x2, y2, color):
    """Exercise 3: line() begins at the upper end, and steps aside early where both are as near."""
    if y1 > y2:
        x1, y1, x2, y2 = x2, y2, x1, y1
    dx, dy = abs(x2 - x1), y2 - y1
    step_x = 1 if x1 < x2 else -1
    steps, aside = max(dx, dy), min(dx, dy)
    for step in range(steps + 1):
        moved = (2 * aside * step + steps) // (2 * steps) if steps else 0
        if dx >= dy:
            putpixel(x1 + step_x * step, y1 + moved, color)
        else:
            putpixel(x1 + step_x * moved, y1 + step, color)


strict()
initgraph(VGA, VGAHI)
for draw, x, color in (
    (every_direction, 110, YELLOW),
    (whole_numbers, 320, LIGHTGREEN),
    (same_as_bgi, 530, LIGHTCYAN),
):
    for end in range(-100, 101, 20):
        draw(x, 240, x + end, 140, color)
        draw(x, 240, x + end, 340, color)
        draw(x, 240, x - 100, 240 + end, color)
        draw(x, 240, x + 100, 240 + end, color)
check.line(every_direction)
check.line(whole_numbers)
check.line(same_as_bgi, exactly=True)
getch()
closegraph()
