"""Lesson 5: one way to solve its exercises.

    python demos/course/solutions/05_filling.py

The exercises stand on the page docs/course/05-filling.md.
"""

from bgi import *
from bgi.lab import check


def on_screen(x, y):
    """Whether there is such a pixel; getpixel() says 0 where there is none."""
    return 0 <= x <= getmaxx() and 0 <= y <= getmaxy()


def neighbours(x, y):
    """The four pixels beside a pixel."""
    return [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]


def own_stack(x, y, color, border):
    """Exercise 1: boundary fill with a list in place of recursion."""
    waiting = [(x, y)]
    while waiting:
        x, y = waiting.pop()
        if on_screen(x, y) and getpixel(x, y) not in (border, color):
            putpixel(x, y, color)
            waiting += neighbours(x, y)


def spans(x, y, color):
    """Exercise 2: flood fill by whole rows, one seed for each piece of a row above and below."""
    old = getpixel(x, y)
    if old == color:
        return

    def is_old(x, y):
        return on_screen(x, y) and getpixel(x, y) == old

    waiting = [(x, y)]
    while waiting:
        x, y = waiting.pop()
        while is_old(x - 1, y):
            x -= 1
        above = below = False
        while is_old(x, y):
            putpixel(x, y, color)
            if is_old(x, y - 1) and not above:
                waiting.append((x, y - 1))
            if is_old(x, y + 1) and not below:
                waiting.append((x, y + 1))
            above, below = is_old(x, y - 1), is_old(x, y + 1)
            x += 1


def chequered(x, y, color, other):
    """Exercise 3: what is done already cannot be seen from its colour, so it is remembered."""
    old = getpixel(x, y)
    waiting = [(x, y)]
    seen = {(x, y)}
    while waiting:
        x, y = waiting.pop()
        for place in neighbours(x, y):
            if on_screen(*place) and place not in seen and getpixel(*place) == old:
                seen.add(place)
                waiting.append(place)
        putpixel(x, y, color if (x // 4 + y // 4) % 2 else other)


strict()
initgraph(VGA, VGAHI)
circle(110, 120, 100)
circle(110, 120, 30)
own_stack(110, 40, LIGHTRED, WHITE)
circle(320, 120, 100)
rectangle(300, 60, 500, 180)
spans(320, 120, LIGHTGREEN)
circle(530, 320, 100)
line(400, 300, 639, 340)
chequered(530, 280, YELLOW, BLACK)
check.boundary(own_stack)
check.flood(spans)
getch()
closegraph()
