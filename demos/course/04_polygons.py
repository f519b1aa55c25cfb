"""Lesson 4: a polygon is filled row by row, by a table of its edges.

    python demos/course/04_polygons.py

Each key fills one more row, and shows the edges that cross it; Esc hurries to the end. Move the
corners in POINTS and run it again. The page: docs/course/04-polygons.md.
"""

from math import ceil

from bgi import *
from squares import enlarge

POINTS = [(2, 3), (12, 7), (20, 1), (37, 12), (28, 26), (23, 12), (15, 24), (2, 18), (9, 12)]
COLUMNS, ROWS, SIZE = 40, 28, 11
TOP = 30
ESC = 27


def edge_table(points):
    """For each row the edges that begin there: each its last row (excluded), x, and step of x."""
    table = {}
    for i in range(len(points)):
        (x1, y1), (x2, y2) = points[i - 1], points[i]
        if y1 > y2:
            x1, y1, x2, y2 = x2, y2, x1, y1
        if y1 != y2:  # level edges cross no row
            table.setdefault(y1, []).append([y2, x1, (x2 - x1) / (y2 - y1)])
    return table


def fill_row(y, edges, color):
    """Set the pixels between the first edge and the second, the third and the fourth, ..."""
    edges.sort(key=lambda edge: edge[1])
    for left, right in zip(edges[::2], edges[1::2], strict=True):
        for x in range(ceil(left[1]), ceil(right[1])):
            putpixel(x, y, color)


def show(y, edges):
    """The rows so far, the true edges over them, and the edges that are active."""
    bar(490, TOP, getmaxx(), getmaxy(), BLACK)
    left, top = enlarge(COLUMNS, ROWS, SIZE, top=TOP)
    setcolor(LIGHTRED)
    middle = SIZE // 2
    corners = [(left + x * SIZE + middle, top + y * SIZE + middle) for x, y in POINTS]
    drawpoly([*corners, corners[0]])
    setcolor(WHITE)
    outtextxy(490, 60, f"row {y}: {len(edges)} edges")
    for number, (last, x, step) in enumerate(edges):
        outtextxy(490, 90 + 40 * number, f"x = {x:.2f}")
        outtextxy(490, 105 + 40 * number, f"{step:+.2f} to {last}")


strict()
initgraph(VGA, VGAHI)
setfillstyle(SOLID_FILL, BLACK)
table = edge_table(POINTS)
active = []
key = 0
for y in range(ROWS):
    active = [edge for edge in active if edge[0] > y] + table.get(y, [])
    fill_row(y, active, YELLOW)
    show(y, active)
    for edge in active:
        edge[1] += edge[2]
    if key != ESC:
        key = getch()
getch()
closegraph()
