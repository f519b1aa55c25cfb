"""Lesson 6: one way to solve its exercises.

    python demos/course/solutions/06_clipping.py

The exercises stand on the page docs/course/06-clipping.md.
"""

from bgi import *
from bgi.lab import check


def outside(x1, y1, x2, y2, left, top, right, bottom):
    """Exercise 1: the parts of a line that are outside, none to two, by Liang and Barsky."""
    dx, dy = x2 - x1, y2 - y1
    enter, leave = 0, 1
    for toward, room in (
        (-dx, x1 - left),
        (dx, right - x1),
        (-dy, y1 - top),
        (dy, bottom - y1),
    ):
        if toward < 0:
            enter = max(enter, room / toward)
        elif toward > 0:
            leave = min(leave, room / toward)
        elif room < 0:
            enter, leave = 1, 0
    if enter > leave:
        return [(x1, y1, x2, y2)]
    parts = []
    if enter > 0:
        parts.append((x1, y1, x1 + enter * dx, y1 + enter * dy))
    if leave < 1:
        parts.append((x1 + leave * dx, y1 + leave * dy, x2, y2))
    return parts


def halving(x1, y1, x2, y2, left, top, right, bottom):
    """Exercise 2: what is neither inside nor outside is cut in half, up to fifty times."""

    def code(x, y):
        return (x < left, x > right, y < top, y > bottom)

    def visible(x1, y1, x2, y2, times):
        code1, code2 = code(x1, y1), code(x2, y2)
        if not any(code1) and not any(code2):
            return x1, y1, x2, y2
        if any(one and two for one, two in zip(code1, code2, strict=True)):
            return None
        if times == 0:
            return x1, y1, x2, y2  # too short to be seen
        x, y = (x1 + x2) / 2, (y1 + y2) / 2
        first = visible(x1, y1, x, y, times - 1)
        second = visible(x, y, x2, y2, times - 1)
        if first is None or second is None:
            return first or second
        return first[:2] + second[2:]

    return visible(x1, y1, x2, y2, 50)


def clip_to(points, window):
    """Exercise 3: a window with any number of corners, no corner pointing inwards, clockwise."""
    for i in range(len(window)):
        (wx1, wy1), (wx2, wy2) = window[i - 1], window[i]
        kept = []
        for j in range(len(points)):
            (x1, y1), (x2, y2) = points[j - 1], points[j]
            d1 = (wx2 - wx1) * (y1 - wy1) - (wy2 - wy1) * (x1 - wx1)
            d2 = (wx2 - wx1) * (y2 - wy1) - (wy2 - wy1) * (x2 - wx1)
            if (d1 < 0) != (d2 < 0):
                t = d1 / (d1 - d2)
                kept.append((x1 + t * (x2 - x1), y1 + t * (y2 - y1)))
            if d2 >= 0:
                kept.append((x2, y2))
        points = kept
    return points


def in_a_box(points, left, top, right, bottom):
    """Exercise 3, with a window as check.clip_polygon() gives it."""
    return clip_to(points, [(left, top), (right, top), (right, bottom), (left, bottom)])


strict()
initgraph(VGA, VGAHI)
rectangle(70, 90, 150, 150)
rectangle(280, 90, 360, 150)
for end in range(20, 221, 10):
    for part in outside(end, 20, 220 - end + 20, 220, 70, 90, 150, 150):
        setcolor(LIGHTRED)
        line(*map(round, part))
    part = halving(end + 210, 20, 450 - end, 220, 280, 90, 360, 150)
    if part:
        setcolor(LIGHTGREEN)
        line(*map(round, part))

setcolor(WHITE)
window = [(530, 20), (620, 120), (530, 220), (440, 120)]
drawpoly([*window, window[0]])
star = [(530, 10), (580, 190), (445, 80), (615, 80), (480, 190)]
setcolor(LIGHTCYAN)
setfillstyle(SOLID_FILL, BLUE)
fillpoly([(round(x), round(y)) for x, y in clip_to(star, window)])
check.clip_line(halving)
check.clip_polygon(in_a_box)
getch()
closegraph()
