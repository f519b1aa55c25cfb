"""check.boundary and check.flood: right algorithms pass, and each usual mistake gets its hint."""

import sys

import pytest

from bgi import floodfill, getmaxx, getmaxy, getpixel, line, putpixel, setfillstyle
from bgi.lab import check
from tests.lab.mistakes import Mistakes

FOUR = (1, 0), (-1, 0), (0, 1), (0, -1)
EIGHT = (*FOUR, (1, 1), (-1, -1), (1, -1), (-1, 1))


def on_screen(x, y):
    return 0 <= x <= getmaxx() and 0 <= y <= getmaxy()


def by_list(x, y, color, inside, neighbours=FOUR, bounded=on_screen):
    waiting = [(x, y)]
    while waiting:
        x, y = waiting.pop()
        if bounded(x, y) and inside(getpixel(x, y)):
            putpixel(x, y, color)
            waiting += [(x + dx, y + dy) for dx, dy in neighbours]


def boundary(x, y, color, border, **more):
    by_list(x, y, color, lambda found: found not in (color, border), **more)


def flood(x, y, color, **more):
    old = getpixel(x, y)
    if old != color:
        by_list(x, y, color, lambda found: found == old, **more)


def boundary_by_rows(x, y, color, border):
    def inside(x, y):
        return on_screen(x, y) and getpixel(x, y) not in (color, border)

    waiting = [(x, y)]
    while waiting:
        x, y = waiting.pop()
        if not inside(x, y):
            continue
        left = right = x
        while inside(left - 1, y):
            left -= 1
        while inside(right + 1, y):
            right += 1
        line(left, y, right, y, color)
        for x in range(left, right + 1):
            waiting += [(x, y + dy) for dy in (-1, 1) if inside(x, y + dy)]


def recursive(x, y, color, border):
    if on_screen(x, y) and getpixel(x, y) not in (color, border):
        putpixel(x, y, color)
        for dx, dy in FOUR:
            recursive(x + dx, y + dy, color, border)


def recursive_flood(x, y, color, old=None):
    if old is None:
        old = getpixel(x, y)
    if on_screen(x, y) and getpixel(x, y) == old != color:
        putpixel(x, y, color)
        for dx, dy in FOUR:
            recursive_flood(x + dx, y + dy, color, old)


def test_the_right_ones_pass():
    for function in (boundary, boundary_by_rows):
        assert check.boundary(function)
    assert check.flood(flood)


def test_one_that_calls_itself_passes_in_small_areas():
    assert check.boundary(recursive, deep=False)
    assert check.flood(recursive_flood, deep=False)


class TestDepth:
    def test_python_ends_a_deep_recursion(self):
        verdict = check.boundary(recursive)
        assert "calls deep" in verdict.reason and "recursion too deep" in verdict.hint
        assert verdict.passed == verdict.tried - 1

    def test_a_higher_limit_does_not_help(self):
        limit = sys.getrecursionlimit()
        sys.setrecursionlimit(10**6)
        try:
            verdict = check.flood(recursive_flood)
        finally:
            sys.setrecursionlimit(limit)
        assert "it goes 1," in verdict.reason and "recursion too deep" in verdict.hint


borders, floods = Mistakes(), Mistakes()


@borders("does it call putpixel")
def draws_nothing(x, y, color, border):
    pass


@borders("the exercise is to find them")
def calls_floodfill(x, y, color, border):
    setfillstyle(1, color)
    floodfill(x, y, border)


@borders("only the first pixel is set")
def only_the_seed(x, y, color, border):
    if getpixel(x, y) not in (color, border):
        putpixel(x, y, color)


@borders("only one line is filled")
def one_row(x, y, color, border):
    boundary(x, y, color, border, neighbours=FOUR[:2])


@borders("to the left")
def not_left(x, y, color, border):
    boundary(x, y, color, border, neighbours=[FOUR[0], *FOUR[2:]])


@borders("above the place")
def not_up(x, y, color, border):
    boundary(x, y, color, border, neighbours=FOUR[:3])


@borders("below the place")
def not_down(x, y, color, border):
    boundary(x, y, color, border, neighbours=[*FOUR[:2], FOUR[3]])


@borders("the colour that the function is given")
def in_blue(x, y, color, border):
    by_list(x, y, 1, lambda found: found not in (1, color, border))


@borders("not eight")
def eight_neighbours(x, y, color, border):
    boundary(x, y, color, border, neighbours=EIGHT)


@borders("whatever its colour")
def only_black(x, y, color, border):
    by_list(x, y, color, lambda found: found == 0)


@borders("a place on the border is not inside")
def begins_anywhere(x, y, color, border):
    putpixel(x, y, color)
    for dx, dy in FOUR:
        boundary(x + dx, y + dy, color, border)


@borders("the border is painted over")
def asks_too_late(x, y, color, border):
    waiting = [(x, y)]
    while waiting:
        x, y = waiting.pop()
        found = getpixel(x, y)
        if on_screen(x, y) and found != color:
            putpixel(x, y, color)
            if found != border:
                waiting += [(x + dx, y + dy) for dx, dy in FOUR]


@borders("around corners")
def straight_rows(x, y, color, border):
    def row(y):
        for step in (1, -1):
            at = x
            while (on_screen(at, y) and getpixel(at, y) not in (color, border)) or at == x:
                putpixel(at, y, color)
                at += step

    for step in (1, -1):
        at = y if step == 1 else y - 1
        while on_screen(x, at) and getpixel(x, at) not in (color, border):
            row(at)
            at += step


@borders("off the screen")
def without_edges(x, y, color, border):
    boundary(x, y, color, border, bounded=lambda x, y: True)


@borders("the same places come again and again")
def again_and_again(x, y, color, border):
    by_list(x, y, color, lambda found: found != border)


@borders("the same places come again and again")
def recursion_without_an_end(x, y, color, border):
    if getpixel(x, y) != border:
        putpixel(x, y, color)
        for dx, dy in FOUR:
            recursion_without_an_end(x + dx, y + dy, color, border)


@borders("every second pixel")
def over_the_corners(x, y, color, border):
    boundary(x, y, color, border, neighbours=EIGHT[4:])


@borders("two directions only")
def right_and_down(x, y, color, border):
    boundary(x, y, color, border, neighbours=FOUR[::2])


@borders("it goes through the border")
def or_for_and(x, y, color, border):
    by_list(x, y, color, lambda found: found != color or found != border)


@borders("it goes through the border")
def another_border(x, y, color, border):
    by_list(x, y, color, lambda found: found not in (4, color))


@borders("the edge of the screen")
def without_the_last_column(x, y, color, border):
    by_list(
        *(x, y, color),
        lambda found: found not in (color, border),
        bounded=lambda x, y: 0 <= x < getmaxx() and 0 <= y < getmaxy(),
    )


@borders("x and y are exchanged")
def exchanged(x, y, color, border):
    boundary(y, x, color, border)


@borders("while waiting:")
def never_asks_whether_it_waits(x, y, color, border):
    waiting = [(x, y)]
    while True:
        x, y = waiting.pop()
        if on_screen(x, y) and getpixel(x, y) not in (color, border):
            putpixel(x, y, color)
            waiting += [(x + dx, y + dy) for dx, dy in FOUR]


@borders("set it first, or use the arguments")
def counts_in_a_global(x, y, color, border):
    count += 1  # type: ignore[name-defined]  # noqa: F821, F841


@floods("find out the old colour once")
def asks_for_the_old_one_each_time(x, y, color):
    if on_screen(x, y) and getpixel(x, y) != color:
        putpixel(x, y, color)
        for dx, dy in FOUR:
            asks_for_the_old_one_each_time(x + dx, y + dy, color)


@floods("found out before that pixel is set")
def asks_too_late_for_it(x, y, color):
    putpixel(x, y, color)
    old = getpixel(x, y)
    by_list(x, y, color, lambda found: found == old != color)


@floods("only what can be reached")
def all_of_that_color(x, y, color):
    old = getpixel(x, y)
    for px in range(100):
        for py in range(100):
            if getpixel(px, py) == old:
                putpixel(px, py, color)


@floods("the colour that the function is given")
def in_red(x, y, color):
    flood(x, y, 4)


@floods("around corners")
def from_the_middle_of_each_row(x, y, color):
    old, waiting = getpixel(x, y), [(x, y)]
    while old != color and waiting:
        x, y = waiting.pop()
        left = right = x
        while on_screen(left - 1, y) and getpixel(left - 1, y) == old:
            left -= 1
        while on_screen(right + 1, y) and getpixel(right + 1, y) == old:
            right += 1
        line(left, y, right, y, color)
        waiting += [
            (x, y + d) for d in (-1, 1) if on_screen(x, y + d) and getpixel(x, y + d) == old
        ]


@floods("recursion too deep")
def a_call_for_each_pixel(x, y, color, old=None):
    recursive_flood(x, y, color, old)


@floods("does it call putpixel")
def fills_nothing(x, y, color):
    pass


@floods("the exercise is to find them")
def by_bgi(x, y, color):
    setfillstyle(1, color)
    floodfill(x, y, 15)


@floods("only the first pixel is set")
def only_its_seed(x, y, color):
    putpixel(x, y, color)


@floods("only one line is filled")
def one_column(x, y, color):
    flood(x, y, color, neighbours=FOUR[2:])


@floods("to the right")
def not_right(x, y, color):
    flood(x, y, color, neighbours=FOUR[1:])


@floods("not eight")
def with_corners(x, y, color):
    flood(x, y, color, neighbours=EIGHT)


@floods("only the colour that is found")
def as_far_as_white(x, y, color):
    by_list(x, y, color, lambda found: found not in (15, color))


@floods("only the colour that is found")
def replaces_black(x, y, color):
    by_list(x, y, color, lambda found: found == 0 != color)


@floods("must stop it")
def the_same_colour_for_ever(x, y, color):
    old = getpixel(x, y)
    by_list(x, y, color, lambda found: found == old)


@floods("off the screen")
def beyond_the_edges(x, y, color):
    flood(x, y, color, bounded=lambda x, y: True)


@floods("it goes everywhere")
def for_ever(x, y, color):
    by_list(x, y, color, lambda found: True)


@floods("is the name written as where it was set")
def a_name_that_is_not_there(x, y, color):
    putpixels(x, y, color)  # type: ignore[name-defined]  # noqa: F821


TABLE = [("boundary", *row) for row in borders.table] + [("flood", *row) for row in floods.table]


@pytest.mark.parametrize(
    ("exercise", "function", "hint"), TABLE, ids=[f"{row[0]}-{row[1].__name__}" for row in TABLE]
)
def test_each_mistake_gets_its_hint(exercise, function, hint):
    verdict = getattr(check, exercise)(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
