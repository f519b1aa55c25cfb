"""Lesson 7: a house, moved, turned and stretched by one matrix.

    python demos/course/07_transformations.py

The arrow keys move it, + and - change its size, l and r turn it about 0, 0; L and R turn it about
its own middle, m mirrors it, 0 begins anew, Esc ends. The page: docs/course/07-transformations.md.
"""

from math import cos, radians, sin

from bgi import *

HOUSE = [(-40, 30), (40, 30), (40, -20), (0, -60), (-40, -20)]
DOOR = [(-10, 30), (-10, 0), (10, 0), (10, 30)]
UNCHANGED = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
ESC = 27


def translation(tx, ty):
    """Moves by tx to the right and ty down."""
    return [[1, 0, tx], [0, 1, ty], [0, 0, 1]]


def scaling(sx, sy):
    """Stretches, away from 0, 0."""
    return [[sx, 0, 0], [0, sy, 0], [0, 0, 1]]


def rotation(degrees):
    """Turns about 0, 0; on the screen, where y grows downwards, clockwise."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def product(second, first):
    """The matrix that does what `first` does, and then what `second` does."""
    result = []
    for row in second:
        result.append([sum(row[k] * first[k][column] for k in range(3)) for column in range(3)])
    return result


def applied(matrix, points):
    """Where a matrix brings some points: each is taken as the column x, y, 1."""
    (a, b, c), (d, e, f), _ = matrix
    return [(a * x + b * y + c, d * x + e * y + f) for x, y in points]


def about(x, y, matrix):
    """The same about the point x, y in place of 0, 0: move it there, do it, move back."""
    return product(translation(x, y), product(matrix, translation(-x, -y)))


MOVES = {72: (0, -20), 80: (0, 20), 75: (-20, 0), 77: (20, 0)}  # what getch() says after a 0
KEYS = {
    "+": scaling(1.25, 1.25),
    "-": scaling(0.8, 0.8),
    "l": rotation(-15),
    "r": rotation(15),
    "m": scaling(-1, 1),
}


def next_matrix(matrix, key):
    """What a key makes of the matrix."""
    if key == 0:  # an arrow: which one, the next number says
        return product(translation(*MOVES.get(getch(), (0, 0))), matrix)
    letter = chr(key)
    if letter == "0":
        return UNCHANGED
    if letter in "LR":
        ((x, y),) = applied(matrix, [(0, 0)])  # where its middle is now
        return product(about(x, y, KEYS[letter.lower()]), matrix)
    return product(KEYS.get(letter, UNCHANGED), matrix)


def show(matrix):
    """The axes, the house, and the matrix in numbers."""
    cleardevice()
    line(0, 240, 639, 240, DARKGRAY)
    line(320, 0, 320, 479, DARKGRAY)
    to_screen = product(translation(320, 240), matrix)  # 0, 0 in the middle of the screen
    for shape, color in ((HOUSE, YELLOW), (DOOR, LIGHTRED)):
        corners = [(round(x), round(y)) for x, y in applied(to_screen, shape)]
        setcolor(color)
        drawpoly([*corners, corners[0]])
    setcolor(WHITE)
    for number, row in enumerate(matrix):
        outtextxy(20, 20 + 14 * number, " ".join(f"{value:8.2f}" for value in row))
    swapbuffers()  # shows what was drawn: lesson 10


strict()
initgraph(VGA, VGAHI)
matrix = UNCHANGED
key = 0
show(matrix)
while (key := getch()) != ESC:
    matrix = next_matrix(matrix, key)
    show(matrix)
closegraph()
