"""Lesson 6: lines and a polygon, cut at the edges of a window that moves.

    python demos/course/06_clipping.py

The arrow keys move the window, + and - change its size, Esc ends. What is cut off is dark. The
page: docs/course/06-clipping.md.
"""

from bgi import *

LEFT, RIGHT, ABOVE, BELOW = 1, 2, 4, 8
ARROWS = {72: (0, -20), 80: (0, 20), 75: (-20, 0), 77: (20, 0)}  # what getch() says after a 0
ESC = 27
LINES = [(20 + 60 * number, 40, 620 - 60 * number, 300) for number in range(11)]
POLYGON = [(120, 320), (320, 280), (520, 320), (460, 430), (380, 350), (320, 440), (260, 350)]


def outcode(x, y, window):
    """On which sides of the window a point is outside: a sum of the four numbers; 0 is inside."""
    left, top, right, bottom = window
    code = 0
    if x < left:
        code += LEFT
    elif x > right:
        code += RIGHT
    if y < top:
        code += ABOVE
    elif y > bottom:
        code += BELOW
    return code


def clipped(x1, y1, x2, y2, window):
    """The part of a line inside, by Cohen and Sutherland, and how many cuts it took; or None."""
    left, top, right, bottom = window
    cuts = 0
    while True:
        code1, code2 = outcode(x1, y1, window), outcode(x2, y2, window)
        if code1 == 0 and code2 == 0:
            return x1, y1, x2, y2, cuts
        if code1 & code2:
            return None  # both ends are outside on the same side
        code = code1 or code2
        if code & LEFT:
            x, y = left, y1 + (y2 - y1) * (left - x1) / (x2 - x1)
        elif code & RIGHT:
            x, y = right, y1 + (y2 - y1) * (right - x1) / (x2 - x1)
        elif code & ABOVE:
            x, y = x1 + (x2 - x1) * (top - y1) / (y2 - y1), top
        else:
            x, y = x1 + (x2 - x1) * (bottom - y1) / (y2 - y1), bottom
        if code == code1:
            x1, y1 = x, y
        else:
            x2, y2 = x, y
        cuts += 1


def cut(points, inside):
    """The part of a polygon where `inside`, a function of x and y, is not negative."""
    kept = []
    for i in range(len(points)):
        (x1, y1), (x2, y2) = points[i - 1], points[i]
        d1, d2 = inside(x1, y1), inside(x2, y2)
        if (d1 < 0) != (d2 < 0):
            t = d1 / (d1 - d2)
            kept.append((x1 + t * (x2 - x1), y1 + t * (y2 - y1)))
        if d2 >= 0:
            kept.append((x2, y2))
    return kept


def clipped_polygon(points, window):
    """The part of a polygon inside, by Sutherland and Hodgman: cut at one edge after the other."""
    left, top, right, bottom = window
    points = cut(points, lambda x, y: x - left)
    points = cut(points, lambda x, y: right - x)
    points = cut(points, lambda x, y: y - top)
    return cut(points, lambda x, y: bottom - y)


def show(window):
    """Everything dark, and what is inside bright; and how the lines fared."""
    cleardevice()
    setcolor(DARKGRAY)
    drawpoly([*POLYGON, POLYGON[0]])
    fates = {"inside": 0, "outside": 0, "cut": 0}
    for ends in LINES:
        line(*ends, DARKGRAY)
        part = clipped(*ends, window)
        if part is None:
            fates["outside"] += 1
            continue
        x1, y1, x2, y2, cuts = part
        fates["cut" if cuts else "inside"] += 1
        line(round(x1), round(y1), round(x2), round(y2), LIGHTGREEN)
    part = clipped_polygon(POLYGON, window)
    if part:
        setcolor(YELLOW)
        setfillstyle(LTSLASH_FILL, BROWN)
        fillpoly([(round(x), round(y)) for x, y in part])
    setcolor(LIGHTRED)
    rectangle(*window)
    setcolor(WHITE)
    words = ", ".join(f"{count} {fate}" for fate, count in fates.items())
    outtextxy(20, 462, f"lines: {words}; corners of the polygon: {len(part)}")
    swapbuffers()  # shows what was drawn: lesson 10


strict()
initgraph(VGA, VGAHI)
x, y, size = 320, 240, 100
key = 0
while key != ESC:
    show((x - size, y - size, x + size, y + size))
    key = getch()
    if key == 0:  # an arrow: which one, the next number says
        right, down = ARROWS.get(getch(), (0, 0))
        x, y = x + right, y + down
    elif key == ord("+"):
        size += 20
    elif key == ord("-"):
        size = max(size - 20, 20)
closegraph()
