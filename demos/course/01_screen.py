"""Lesson 1: a picture is a table of numbers.

    python demos/course/01_screen.py

Change the letters in ROWS and run it again. The page: docs/course/01-screen.md.
"""

from bgi import *
from squares import enlarge

# A picture: one letter for each pixel. COLORS says which number a letter stands for.
ROWS = [
    "................",
    ".......rr.......",
    "......rrrr......",
    ".....rrwwrr.....",
    ".....rwwwwr.....",
    "......wwww......",
    "......wbbw......",
    "......wbbw......",
    "......wwww......",
    "......wwww......",
    ".....rwwwwr.....",
    "....rrwwwwrr....",
    "....r.wwww.r....",
    "......yyyy......",
    ".......yy.......",
    "................",
]
COLORS = {".": BLACK, "r": LIGHTRED, "w": WHITE, "b": BLUE, "y": YELLOW}


def stamp(left, top):
    """Set the pixels of the picture, its upper left corner at left, top."""
    for y, row in enumerate(ROWS):
        for x, letter in enumerate(row):
            putpixel(left + x, top + y, COLORS[letter])


strict()
initgraph(VGA, VGAHI)

stamp(0, 0)
enlarge(16, 16, size=24)

# The screen's corners: the last column is getmaxx(), not getmaxx() + 1.
setcolor(LIGHTCYAN)
right, bottom = getmaxx(), getmaxy()
stamp(right - 15, 0)
stamp(right - 15, bottom - 15)
outtextxy(right - 100, 30, f"{right}, 0")
outtextxy(right - 100, bottom - 36, f"{right}, {bottom}")

# Five of them, each one 30 to the right of the one before and 20 further up.
for number in range(5):
    stamp(450 + 30 * number, 300 - 20 * number)

getch()
closegraph()
