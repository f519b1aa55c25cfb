"""check.line: each usual mistake gets its hint."""

import sys
from math import hypot

import pytest

from bgi import getch, getmaxy, initgraph, line, putpixel
from bgi.lab import check
from tests.lab.mistakes import Mistakes
from tests.lab.test_line import bresenham, dda, pixel

wrong = Mistakes()


@wrong("does it call putpixel")
def draws_nothing(x1, y1, x2, y2, color):
    pass


@wrong("the exercise is to find out which")
def calls_line(x1, y1, x2, y2, color):
    line(x1, y1, x2, y2, color)


@wrong("the colour that the function is given")
def always_white(x1, y1, x2, y2, color):
    bresenham(x1, y1, x2, y2, 1 if color == 15 else 15)


@wrong("x and y are exchanged")
def exchanged(x1, y1, x2, y2, color):
    bresenham(y1, x1, y2, x2, color)


@wrong("the last pixel is missing")
def stops_before_the_end(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(steps):
        putpixel(round(x1 + i * (x2 - x1) / steps), round(y1 + i * (y2 - y1) / steps), color)
    if steps == 0:
        putpixel(x1, y1, color)


@wrong("the first pixel is missing")
def steps_before_it_draws(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(1, steps + 1):
        putpixel(round(x1 + i * (x2 - x1) / steps), round(y1 + i * (y2 - y1) / steps), color)
    if steps == 0:
        putpixel(x1, y1, color)


@wrong("goes on beyond its end")
def one_too_many(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1)) or 1
    for i in range(steps + 2):
        putpixel(round(x1 + i * (x2 - x1) / steps), round(y1 + i * (y2 - y1) / steps), color)


@wrong("a line from a point to itself")
def no_point(x1, y1, x2, y2, color):
    if (x1, y1) != (x2, y2):
        bresenham(x1, y1, x2, y2, color)


@wrong("nothing to divide by")
def divides_by_no_steps(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(steps + 1):
        putpixel(round(x1 + i * (x2 - x1) / steps), round(y1 + i * (y2 - y1) / steps), color)


@wrong("an upright line: x2 - x1 is 0")
def slope(x1, y1, x2, y2, color):
    m = (y2 - y1) / (x2 - x1)
    for x in range(x1, x2 + 1):
        putpixel(x, round(y1 + m * (x - x1)), color)


@wrong("gaps where the line is steep")
def one_pixel_for_each_x(x1, y1, x2, y2, color):
    if x1 == x2:
        bresenham(x1, y1, x2, y2, color)
        return
    for x in range(min(x1, x2), max(x1, x2) + 1):
        putpixel(x, round(y1 + (y2 - y1) * (x - x1) / (x2 - x1)), color)


@wrong("nothing is drawn from right to left")
def only_to_the_right(x1, y1, x2, y2, color):
    if x1 <= x2:
        bresenham(x1, y1, x2, y2, color)


@wrong("nothing is drawn upwards")
def only_down(x1, y1, x2, y2, color):
    if y1 <= y2:
        bresenham(x1, y1, x2, y2, color)


@wrong("off by one")
def cuts_off(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(steps + 1):
        part = i / steps if steps else 0
        putpixel(int(x1 + part * (x2 - x1)), int(y1 + part * (y2 - y1)), color)


@wrong("off by one")
def begins_with_another_d(x1, y1, x2, y2, color):
    steep = abs(y2 - y1) > abs(x2 - x1)
    if steep:
        x1, y1, x2, y2 = y1, x1, y2, x2
    if x1 > x2:
        x1, y1, x2, y2 = x2, y2, x1, y1
    dx, dy, step = x2 - x1, abs(y2 - y1), 1 if y2 > y1 else -1
    d, y = -dx, y1
    for x in range(x1, x2 + 1):
        pixel(steep, x, y, color)
        d += 2 * dy
        if d > dx:
            y += step
            d -= 2 * dx


@wrong("seven octants are missing")
def first_octant(x1, y1, x2, y2, color):
    dx, dy = x2 - x1, y2 - y1
    d, y = 2 * dy - dx, y1
    for x in range(x1, x2 + 1):
        putpixel(x, y, color)
        if d > 0:
            y += 1
            d -= 2 * dx
        d += 2 * dy


@wrong("steep lines are wrong")
def half_of_the_exchange(x1, y1, x2, y2, color):
    if abs(y2 - y1) > abs(x2 - x1) > 0:
        bresenham(y1, x1, y2, x2, color)
    else:
        bresenham(x1, y1, x2, y2, color)


@wrong("up to the right")
def always_steps_down(x1, y1, x2, y2, color):
    if x1 > x2:
        x1, y1, x2, y2 = x2, y2, x1, y1
    if x1 - x2 != 0 and y2 < y1:
        y2 = 2 * y1 - y2
    bresenham(x1, y1, x2, y2, color)


@wrong("more than one pixel for a step")
def two_pixels_thick(x1, y1, x2, y2, color):
    dx, dy = x2 - x1, y2 - y1
    bresenham(x1, y1, x2, y2, color)
    if abs(dx) > abs(dy) > 0:
        putpixel((x1 + x2) // 2, min(y1, y2), color)
        putpixel((x1 + x2) // 2, max(y1, y2), color)


@wrong("count the steps, and do not ask whether a float")
def asks_whether_a_float_is_there(x1, y1, x2, y2, color):
    x = float(x1)
    while x != x2:
        putpixel(round(x), y1, color)
        x += 0.3


@wrong("it steps away from the second end")
def walks_away(x1, y1, x2, y2, color):
    if y1 == y2:
        while x1 != x2:
            putpixel(x1, y1, color)
            x1 += 1
        putpixel(x2, y2, color)
    else:
        bresenham(x1, y1, x2, y2, color)


@wrong("an end is missing")
def both_ends_missing(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(1, steps):
        putpixel(round(x1 + i * (x2 - x1) / steps), round(y1 + i * (y2 - y1) / steps), color)


@wrong("the last pixel is missing")
def stops_before_x2(x1, y1, x2, y2, color):
    """And does nothing at all to the left: the first mistake comes first."""
    steps, x, y = max(abs(x2 - x1), abs(y2 - y1)), float(x1), float(y1)
    while x < x2:
        putpixel(round(x), round(y), color)
        x, y = x + (x2 - x1) / steps, y + (y2 - y1) / steps


@wrong("range(x1, x2 - 1, -1)")
def range_upwards_only(x1, y1, x2, y2, color):
    if abs(x2 - x1) < abs(y2 - y1) or x1 == x2:
        bresenham(x1, y1, x2, y2, color)
        return
    for x in range(x1, x2 + 1, 1 if x1 < x2 else -1):
        putpixel(x, round(y1 + (x - x1) * (y2 - y1) / (x2 - x1)), color)


def in_steps(steps, x1, y1, x2, y2, color, cut=round):
    for i in range(steps + 1):
        part = i / steps if steps else 0
        putpixel(cut(x1 + part * (x2 - x1)), cut(y1 + part * (y2 - y1)), color)


@wrong("max(abs(dx), abs(dy))")
def the_larger_with_its_sign(x1, y1, x2, y2, color):
    in_steps(max(x2 - x1, y2 - y1), x1, y1, x2, y2, color)


@wrong("max(abs(dx), abs(dy))")
def the_shorter_side(x1, y1, x2, y2, color):
    in_steps(min(abs(x2 - x1), abs(y2 - y1)), x1, y1, x2, y2, color)


@wrong("max(abs(dx), abs(dy))")
def only_both_ends(x1, y1, x2, y2, color):
    in_steps(1, x1, y1, x2, y2, color)


@wrong("more than one pixel for a step")
def both_sides_together(x1, y1, x2, y2, color):
    in_steps(abs(x2 - x1) + abs(y2 - y1), x1, y1, x2, y2, color)


@wrong("more than one pixel for a step")
def as_many_as_it_is_long(x1, y1, x2, y2, color):
    in_steps(int(hypot(x2 - x1, y2 - y1)), x1, y1, x2, y2, color)


@wrong("so does putpixel")
def floats_for_putpixel(x1, y1, x2, y2, color):
    in_steps(max(abs(x2 - x1), abs(y2 - y1)), x1, y1, x2, y2, color, lambda v: v)


@wrong("divide by /, not //")
def whole_steps(x1, y1, x2, y2, color):
    steps, x, y = max(abs(x2 - x1), abs(y2 - y1)), x1, y1
    for _ in range(steps + 1):
        putpixel(x, y, color)
        if steps:
            x, y = x + (x2 - x1) // steps, y + (y2 - y1) // steps


@wrong("Does it go left, or up?")
def without_signs(x1, y1, x2, y2, color):
    dda(x1, y1, x1 + abs(x2 - x1), y1 + abs(y2 - y1), color)


@wrong("Is the line steep?")
def one_loop_of_the_textbook(x1, y1, x2, y2, color):
    if x1 > x2:
        x1, y1, x2, y2 = x2, y2, x1, y1
    dx, dy, y = x2 - x1, abs(y2 - y1), y1
    d = 2 * dy - dx
    for x in range(x1, x2 + 1):
        putpixel(x, y, color)
        y, d = (y + 1, d + 2 * dy - 2 * dx) if d > 0 else (y, d + 2 * dy)


@wrong("the slope is upside down")
def dx_through_dy(x1, y1, x2, y2, color):
    if x1 == x2 or y1 == y2:
        bresenham(x1, y1, x2, y2, color)
        return
    for x in range(min(x1, x2), max(x1, x2) + 1):
        putpixel(x, round(y1 + (x - x1) * (x2 - x1) / (y2 - y1)), color)


@wrong("it begins at 0")
def without_the_start(x1, y1, x2, y2, color):
    dda(0, 0, x2 - x1, y2 - y1, color)


@wrong("it begins at 0")
def without_y1(x1, y1, x2, y2, color):
    if abs(y2 - y1) > abs(x2 - x1):
        dda(0, y1, x2 - x1, y2, color)
    else:
        dda(x1, 0, x2, y2 - y1, color)


@wrong("y grows downwards, and is added")
def subtracts_y(x1, y1, x2, y2, color):
    dda(x1, y1, x2, y1 - (y2 - y1), color)


@wrong("upside down")
def as_in_mathematics(x1, y1, x2, y2, color):
    dda(320 + x1, 240 - y1, 320 + x2, 240 - y2, color)


@wrong("upside down")
def from_the_bottom(x1, y1, x2, y2, color):
    dda(x1, getmaxy() - y1, x2, getmaxy() - y2, color)


@wrong("all is there, but elsewhere")
def beside(x1, y1, x2, y2, color):
    dda(x1 + 1, y1, x2 + 1, y2, color)


@wrong("x1 belongs to y1")
def exchanges_x_only(x1, y1, x2, y2, color):
    if x1 > x2:
        x1, x2 = x2, x1
    dda(x1, y1, x2, y2, color)


@wrong("x1 belongs to y1")
def sorts_both(x1, y1, x2, y2, color):
    dda(min(x1, x2), min(y1, y2), max(x1, x2), max(y1, y2), color)


@wrong("exchange them back for putpixel")
def not_exchanged_back(x1, y1, x2, y2, color):
    if abs(y2 - y1) > abs(x2 - x1):
        x1, y1, x2, y2 = y1, x1, y2, x2
    bresenham(x1, y1, x2, y2, color)


@wrong("level lines are wrong")
def no_level_lines(x1, y1, x2, y2, color):
    if y1 != y2:
        dda(x1, y1, x2, y2, color)


@wrong("d gets smaller by twice the longer side")
def d_only_grows(x1, y1, x2, y2, color):
    steep = abs(y2 - y1) > abs(x2 - x1)
    if steep:
        x1, y1, x2, y2 = y1, x1, y2, x2
    d, y = 2 * abs(y2 - y1) - abs(x2 - x1), y1
    for i in range(abs(x2 - x1) + 1):
        pixel(steep, x1 + (i if x2 > x1 else -i), y, color)
        if d > 0:
            y += 1 if y2 > y1 else -1
        d += 2 * abs(y2 - y1)


@wrong("must stop somewhere")
def halves_for_ever(x1, y1, x2, y2, color):
    x, y = (x1 + x2) // 2, (y1 + y2) // 2
    putpixel(x, y, color)
    halves_for_ever(x1, y1, x, y, color)
    halves_for_ever(x, y, x2, y2, color)


@wrong("no variables from outside")
def always_one(x1, y1, x2, y2, color):
    dda(10, 10, 50, 30, color)


@wrong("what it returns is not looked at")
def returns_them(x1, y1, x2, y2, color):
    return [(x, y1) for x in range(x1, x2 + 1)]


@wrong("putpixel(x, y, color) is what sets a pixel")
def prints_them(x1, y1, x2, y2, color):
    print(x1, y1, "to", x2, y2)


@wrong("initgraph() and closegraph() stand outside")
def opens_the_screen(x1, y1, x2, y2, color):
    initgraph()
    dda(x1, y1, x2, y2, color)


@wrong("leave keys to the program")
def waits_for_a_key(x1, y1, x2, y2, color):
    dda(x1, y1, x2, y2, color)
    getch()


@wrong("return ends a function")
def exits(x1, y1, x2, y2, color):
    dda(x1, y1, x2, y2, color)
    sys.exit()


@wrong("set it first, or use the arguments")
def a_variable_from_outside(x1, y1, x2, y2, color):
    steps += 1  # type: ignore[name-defined]  # noqa: F821, F841


@pytest.mark.parametrize(("function", "hint"), wrong.table, ids=wrong.names)
def test_each_mistake_gets_its_hint(function, hint):
    verdict = check.line(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
