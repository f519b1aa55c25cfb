"""Lesson 5: a colour spreads, in four ways that remember different things.

    python demos/course/05_filling.py

1 fills by recursion, 2 by a stack, 3 by a queue, 4 by spans; Esc ends. Draw other walls into the
room and run it again. The page: docs/course/05-filling.md.
"""

import sys

from bgi import *
from squares import enlarge

COLUMNS, ROWS, SIZE = 40, 26, 12
TOP = 40
SEED_X, SEED_Y = 8, 8
COLORS = (LIGHTBLUE, LIGHTCYAN, LIGHTGREEN, YELLOW, LIGHTRED, LIGHTMAGENTA)
ESC = 27

sys.setrecursionlimit(5000)  # Python stops at 1000 calls inside each other


def room():
    """The walls, and the squares in which all is shown."""
    cleardevice()
    rectangle(0, 0, COLUMNS - 1, ROWS - 1)
    circle(14, 12, 6)
    line(26, 0, 26, 17)
    line(32, 8, 32, 25)
    putpixel(8, 12, BLACK)  # a door
    return enlarge(COLUMNS, ROWS, SIZE, top=TOP)


def paint(x, y):
    """Set a pixel, and its square; the colour says when."""
    global painted
    color = COLORS[painted // 40 % len(COLORS)]
    painted += 1
    putpixel(x, y, color)
    corner_x, corner_y = left + x * SIZE, top + y * SIZE
    bar(corner_x + 1, corner_y + 1, corner_x + SIZE - 1, corner_y + SIZE - 1, color)
    delay(4)


def recursion(x, y, depth=1):
    """A call for each neighbour; returns how many calls were inside each other."""
    if getpixel(x, y) != BLACK:
        return depth
    paint(x, y)
    return max(
        recursion(x + 1, y, depth + 1),
        recursion(x - 1, y, depth + 1),
        recursion(x, y + 1, depth + 1),
        recursion(x, y - 1, depth + 1),
    )


def stack(x, y, place=-1):
    """The pixels to do are in a list, and the last one is next; returns how many there were."""
    waiting = [(x, y)]
    most = 1
    while waiting:
        most = max(most, len(waiting))
        x, y = waiting.pop(place)
        if getpixel(x, y) == BLACK:
            paint(x, y)
            waiting += [(x, y - 1), (x, y + 1), (x - 1, y), (x + 1, y)]
    return most


def queue(x, y):
    """The same, but the first one is next."""
    return stack(x, y, place=0)


def spans(x, y):
    """Whole rows are painted; one pixel is remembered for each piece of a row above and below."""
    waiting = [(x, y)]
    most = 1
    while waiting:
        most = max(most, len(waiting))
        x, y = waiting.pop()
        while getpixel(x - 1, y) == BLACK:
            x -= 1
        above = below = False  # whether the pixel above, or below, is in a piece already seen
        while getpixel(x, y) == BLACK:
            paint(x, y)
            if getpixel(x, y - 1) == BLACK and not above:
                waiting.append((x, y - 1))
            if getpixel(x, y + 1) == BLACK and not below:
                waiting.append((x, y + 1))
            above = getpixel(x, y - 1) == BLACK
            below = getpixel(x, y + 1) == BLACK
            x += 1
    return most


WAYS = {"1": recursion, "2": stack, "3": queue, "4": spans}

strict()
initgraph(VGA, VGAHI)
left, top = room()
outtextxy(24, 400, "1 recursion   2 stack   3 queue   4 spans   Esc ends")
while (key := getch()) != ESC:
    if chr(key) in WAYS:
        way = WAYS[chr(key)]
        painted = 0
        left, top = room()
        most = way(SEED_X, SEED_Y)
        outtextxy(24, 400, f"{way.__name__}: {painted} pixels, {most} remembered at most")
        outtextxy(24, 420, "1 recursion   2 stack   3 queue   4 spans   Esc ends")
closegraph()
