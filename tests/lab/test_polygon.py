"""check.polygon: right algorithms pass, and each usual mistake gets its hint."""

from itertools import pairwise
from math import ceil, floor

import pytest

from bgi import fillpoly, line, putpixel
from bgi.lab import check
from tests.lab.mistakes import Mistakes


def sides(points):
    return [(points[i - 1], points[i]) for i in range(len(points))]


def crossings(points, y, end=lambda top, y, bottom: top <= y < bottom):
    found = []
    for (x1, y1), (x2, y2) in sides(points):
        if y1 > y2:
            x1, y1, x2, y2 = x2, y2, x1, y1
        if y1 != y2 and end(y1, y, y2):
            found.append(x1 + (y - y1) * (x2 - x1) / (y2 - y1))
    return found


def rows(points):
    heights = [y for _, y in points]
    return range(min(heights), max(heights) + 1)


def scan_line(points, color, left=round, right=round):
    for y in rows(points):
        found = sorted(crossings(points, y))
        for a, b in zip(found[::2], found[1::2], strict=True):
            for x in range(left(a), right(b) + 1):
                putpixel(x, y, color)


def edge_table(points, color):
    """With a table of sides by their first rows, and x that grows by 1/m."""
    table: dict[int, list[list[float]]] = {}
    for (x1, y1), (x2, y2) in sides(points):
        if y1 > y2:
            x1, y1, x2, y2 = x2, y2, x1, y1
        if y1 != y2:
            table.setdefault(y1, []).append([y2, float(x1), (x2 - x1) / (y2 - y1)])
    active: list[list[float]] = []
    for y in rows(points):
        active = [side for side in active + table.get(y, []) if side[0] > y]
        active.sort(key=lambda side: side[1])
        for one, other in zip(active[::2], active[1::2], strict=True):
            for x in range(ceil(one[1]), floor(other[1]) + 1):
                putpixel(x, y, color)
        for side in active:
            side[1] += side[2]


def in_the_middle_of_rows(points, color):
    for y in rows(points):
        found = sorted(crossings(points, y + 0.5))
        for a, b in zip(found[::2], found[1::2], strict=True):
            for x in range(ceil(a), ceil(b)):
                putpixel(x, y, color)


def with_its_sides(points, color):
    scan_line(points, color)
    for (x1, y1), (x2, y2) in sides(points):
        steps = max(abs(x2 - x1), abs(y2 - y1)) or 1
        for i in range(steps + 1):
            putpixel(round(x1 + (x2 - x1) * i / steps), round(y1 + (y2 - y1) * i / steps), color)


def by_level_lines(points, color):
    for y in rows(points):
        found = sorted(crossings(points, y))
        for a, b in zip(found[::2], found[1::2], strict=True):
            line(round(a), y, round(b), y, color)


def cut(points, color):
    scan_line(points, color, int, int)


RIGHT = [scan_line, edge_table, in_the_middle_of_rows, with_its_sides, by_level_lines, cut]


@pytest.mark.parametrize("function", RIGHT)
def test_any_rounding_at_the_sides_is_right(function):
    verdict = check.polygon(function)
    assert verdict, str(verdict)


wrong = Mistakes()


@wrong("does it call putpixel")
def draws_nothing(points, color):
    pass


@wrong("the exercise is to find them")
def calls_fillpoly(points, color):
    fillpoly(points)


@wrong("the colour that the function is given")
def in_white(points, color):
    scan_line(points, 1 if color == 15 else 15)


@wrong("x and y are exchanged")
def exchanged(points, color):
    scan_line([(y, x) for x, y in points], color)


@wrong("only the sides are there")
def only_its_sides(points, color):
    for (x1, y1), (x2, y2) in sides(points):
        steps = max(abs(x2 - x1), abs(y2 - y1)) or 1
        for i in range(steps + 1):
            putpixel(round(x1 + (x2 - x1) * i / steps), round(y1 + (y2 - y1) * i / steps), color)


@wrong("the whole box")
def box(points, color):
    across = [x for x, _ in points]
    for y in rows(points):
        for x in range(min(across), max(across) + 1):
            putpixel(x, y, color)


@wrong("Count each side from its upper end")
def corners_twice(points, color):
    for y in rows(points):
        found = sorted(crossings(points, y, lambda top, y, bottom: top <= y <= bottom))
        for a, b in zip(found[::2], found[1::2], strict=False):
            for x in range(round(a), round(b) + 1):
                putpixel(x, y, color)


@wrong("the side from the last point back to the first")
def not_closed(points, color):
    for y in rows(points):
        found = []
        for (x1, y1), (x2, y2) in sides(points)[1:]:
            if min(y1, y2) <= y < max(y1, y2):
                found.append(x1 + (y - y1) * (x2 - x1) / (y2 - y1))
        found.sort()
        for a, b in zip(found[::2], found[1::2], strict=False):
            for x in range(round(a), round(b) + 1):
                putpixel(x, y, color)


@wrong("every second row")
def interlaced(points, color):
    for y in rows(points):
        found = sorted(crossings(points, y))
        for a, b in zip(found[::2], found[1::2], strict=True):
            if y % 2 == 0:
                line(round(a), y, round(b), y, color)


@wrong("even-odd rule")
def filled_twice(points, color):
    """The other rule: how often a side goes around a place."""
    for y in rows(points):
        found = []
        for (x1, y1), (x2, y2) in sides(points):
            if min(y1, y2) <= y < max(y1, y2):
                found.append((x1 + (y - y1) * (x2 - x1) / (y2 - y1), 1 if y2 > y1 else -1))
        turns, found = 0, sorted(found)
        for (a, step), (b, _) in pairwise(found):
            turns += step
            if turns:
                line(round(a), y, round(b), y, color)


@wrong("come back")
def from_the_first_to_the_last(points, color):
    for y in rows(points):
        found = crossings(points, y)
        if found:
            line(round(min(found)), y, round(max(found)), y, color)


@wrong("sort its crossings from left to right")
def unsorted(points, color):
    for y in rows(points):
        found = crossings(points, y)
        for a, b in zip(found[::2], found[1::2], strict=True):
            line(round(a), y, round(b), y, color)


@wrong("is rounded only to set a pixel")
def slope_cut_off(points, color):
    scan_line(points, color, lambda x: int(x) - 2, lambda x: int(x) + 2)


@wrong("leave it out")
def divides_by_level_sides(points, color):
    for y in rows(points):
        for (x1, y1), (x2, y2) in sides(points):
            putpixel(round(x1 + (y - y1) * (x2 - x1) / (y2 - y1)), y, color)


def by_pairs(
    points, color, crossing, take=lambda found: zip(found[::2], found[1::2], strict=False)
):
    """As learners write it: `crossing` says where a side meets a row."""
    for y in rows(points):
        found = []
        for (x1, y1), (x2, y2) in sides(points):
            if min(y1, y2) <= y < max(y1, y2):
                found += crossing(x1, y1, x2, y2, y)
        for a, b in take(sorted(found)):
            for x in range(max(round(a), 0), min(round(b), 639) + 1):
                putpixel(x, y, color)


def right_crossing(x1, y1, x2, y2, y):
    return [x1 + (y - y1) * (x2 - x1) / (y2 - y1)]


@wrong("x1 + (y - y1) * (x2 - x1) / (y2 - y1)")
def whole_slopes(points, color):
    by_pairs(points, color, lambda x1, y1, x2, y2, y: [x1 + (y - y1) * ((x2 - x1) // (y2 - y1))])


@wrong("with x1 and y1 of the same end")
def x_of_another_end(points, color):
    def crossing(x1, y1, x2, y2, y):
        return [x1 + (y - min(y1, y2)) * (x2 - x1) / (y2 - y1)]

    by_pairs(points, color, crossing)


@wrong("between its upper end and its lower end")
def sides_that_stay(points, color):
    """The edge table, out of which nothing is ever taken."""
    for y in rows(points):
        found = sorted(crossings(points, y, lambda top, y, bottom: top <= y))
        for a, b in zip(found[::2], found[1::2], strict=False):
            line(max(round(a), 0), y, min(round(b), 639), y, color)


@wrong("also those with sides that go up")
def only_sides_that_go_down(points, color):
    by_pairs(points, color, lambda x1, y1, x2, y2, y: right_crossing(x1, y1, x2, y2, y) * (y1 < y2))


@wrong("sorted them from left to right")
def sorted_from_the_right(points, color):
    by_pairs(points, color, right_crossing, lambda found: zip(found[1::2], found[::2], strict=True))


@wrong("from the third to the fourth")
def between_all(points, color):
    by_pairs(points, color, right_crossing, pairwise)


@wrong("from the third to the fourth")
def the_first_pair(points, color):
    by_pairs(points, color, right_crossing, lambda found: [found[:2]] if len(found) > 1 else [])


@wrong("only the sides are there")
def sets_the_crossings(points, color):
    by_pairs(points, color, right_crossing, lambda found: zip(found, found, strict=True))


@wrong("take them in a loop")
def of_four_points(points, color):
    a, b, c, d = points
    scan_line([a, b, c, d], color)


@wrong("That is joined to the first")
def beyond_the_last_point(points, color):
    for i, (x1, y1) in enumerate(points):
        x2, y2 = points[i + 1]
        line(x1, y1, x2, y2, color)


@wrong("no variables from outside")
def always_one(points, color):
    scan_line([(10, 10), (50, 10), (30, 40)], color)


@wrong("what it returns is not looked at")
def returns_rows(points, color):
    return [crossings(points, y) for y in rows(points)]


@wrong("an odd number of crossings")
def pairs_that_are_not_there(points, color):
    for y in rows(points):
        found = sorted(crossings(points, y, lambda top, y, bottom: top <= y <= bottom))
        for i in range(0, len(found), 2):
            line(round(found[i]), y, round(found[i + 1]), y, color)


@pytest.mark.parametrize(("function", "hint"), wrong.table, ids=wrong.names)
def test_each_mistake_gets_its_hint(function, hint):
    verdict = check.polygon(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
