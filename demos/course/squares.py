"""Pixels as large as the squares of an exercise book: what the lessons' programs look through."""

from bgi import *

NUMBER_EVERY = 5
ROOM = 24  # for the numbers at the left side and above


def enlarge(columns, rows, size=12, left=0, top=None, x=0, y=0):
    """Show some pixels of the screen again, each as a square, with their coordinates.

    Args:
        columns: how many pixels to the right.
        rows: how many pixels down.
        size: how wide a square becomes, in pixels.
        left: where the squares begin, with the numbers beside them.
        top: the same; below the pixels themselves unless given.
        x: the first pixel's place; 0, 0 is the screen's upper left corner.
        y: the same.

    Returns the upper left corner of the first square, to draw over the squares from there.
    """
    with slow(0):  # --slow is for what a lesson draws, not for the squares
        picture = [[getpixel(x + i, y + j) for i in range(columns)] for j in range(rows)]
        left += ROOM
        top = y + rows + ROOM if top is None else top + ROOM
        bar(left, top, left + columns * size, top + rows * size, DARKGRAY)
        for j, row in enumerate(picture):
            for i, color in enumerate(row):
                corner_x, corner_y = left + i * size, top + j * size
                bar(corner_x + 1, corner_y + 1, corner_x + size - 1, corner_y + size - 1, color)
        for i in range(-x % NUMBER_EVERY, columns, NUMBER_EVERY):
            outtextxy(left + i * size + 2, top - 10, str(x + i))
        for j in range(-y % NUMBER_EVERY, rows, NUMBER_EVERY):
            outtextxy(left - ROOM, top + j * size + size // 2 - 3, f"{y + j:3}")
    return left, top
