"""check.circle: right algorithms pass, and each usual mistake gets its hint."""

from math import cos, pi, sin, sqrt

import pytest

from bgi import circle, putpixel
from bgi.lab import check
from tests.lab.mistakes import Mistakes


def eight(cx, cy, x, y, color):
    for a, b in ((x, y), (y, x)):
        four(cx, cy, a, b, color)


def four(cx, cy, x, y, color):
    for right in (x, -x):
        for down in (y, -y):
            putpixel(cx + right, cy + down, color)


def midpoint(cx, cy, radius, color):
    x, y, d = 0, radius, 1 - radius
    while x <= y:
        eight(cx, cy, x, y, color)
        if d < 0:
            d += 2 * x + 3
        else:
            d += 2 * (x - y) + 5
            y -= 1
        x += 1


def bresenham(cx, cy, radius, color):
    x, y, d = 0, radius, 3 - 2 * radius
    while x <= y:
        eight(cx, cy, x, y, color)
        if d < 0:
            d += 4 * x + 6
        else:
            d += 4 * (x - y) + 10
            y -= 1
        x += 1


def by_roots(cx, cy, radius, color):
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            eight(cx, cy, x, y, color)


@pytest.mark.parametrize("function", [midpoint, bresenham, by_roots])
def test_any_circle_is_right(function):
    verdict = check.circle(function)
    assert verdict, str(verdict)


def test_exactly_asks_for_the_pixels_of_circle():
    verdict = check.circle(midpoint, exactly=True)
    assert (verdict.tried - verdict.passed, "right, but not bgi's" in verdict.hint) == (1, True)


wrong = Mistakes()


@wrong("does it call putpixel")
def draws_nothing(x, y, radius, color):
    pass


@wrong("the exercise is to find out which")
def calls_circle(x, y, radius, color):
    circle(x, y, radius)


@wrong("the colour that the function is given")
def in_white(x, y, radius, color):
    midpoint(x, y, radius, 1 if color == 15 else 15)


@wrong("Each point that you compute gives eight")
def one_octant(cx, cy, radius, color):
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            putpixel(cx + x, cy - y, color)


@wrong("Each point that you compute gives eight")
def one_quarter(cx, cy, radius, color):
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            putpixel(cx + x, cy - y, color)
            putpixel(cx + y, cy - x, color)


@wrong("which of the eight putpixel calls")
def seven_octants(cx, cy, radius, color):
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            four(cx, cy, x, y, color)
            for right, down in ((y, x), (-y, x), (y, -x)):
                putpixel(cx + right, cy + down, color)


@wrong("begin with x = 0")
def begins_with_one(cx, cy, radius, color):
    x, y, d = 0, radius, 1 - radius
    while x <= y:
        if x or not radius:
            eight(cx, cy, x, y, color)
        if d < 0:
            d += 2 * x + 3
        else:
            d += 2 * (x - y) + 5
            y -= 1
        x += 1


@wrong("go on while x <= y")
def no_diagonal(cx, cy, radius, color):
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x < y or radius == 0:
            eight(cx, cy, x, y, color)


@wrong("is filled")
def filled(cx, cy, radius, color):
    midpoint(cx, cy, radius, color)
    for y in range(-radius, radius + 1):
        for x in range(-radius, radius + 1):
            if x * x + y * y < radius * radius:
                putpixel(cx + x, cy + y, color)


@wrong("around 0, 0")
def without_its_centre(x, y, radius, color):
    midpoint(0, 0, radius, color)


@wrong("x and y are exchanged")
def centre_exchanged(x, y, radius, color):
    midpoint(y, x, radius, color)


@wrong("too small by one")
def too_small(x, y, radius, color):
    midpoint(x, y, max(radius - 1, 0), color)


@wrong("too large by one")
def too_large(x, y, radius, color):
    midpoint(x, y, radius + 1, color)


@wrong("twice as large")
def takes_the_diameter(x, y, radius, color):
    midpoint(x, y, radius * 2, color)


@wrong("gaps at the left and right sides")
def one_pixel_for_each_x(cx, cy, radius, color):
    for x in range(-radius, radius + 1):
        y = round(sqrt(radius * radius - x * x))
        putpixel(cx + x, cy + y, color)
        putpixel(cx + x, cy - y, color)


@wrong("the step of the angle")
def few_angles(cx, cy, radius, color):
    drawn = {
        (round(radius * cos(a * pi / 90)), round(radius * sin(a * pi / 90))) for a in range(180)
    }
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            for right, down in (
                (x, y),
                (y, x),
                (-x, y),
                (y, -x),
                (x, -y),
                (-y, x),
                (-x, -y),
                (-y, -x),
            ):
                if (right, down) in drawn:
                    putpixel(cx + right, cy + down, color)


@wrong("off by one")
def cuts_off(cx, cy, radius, color):
    for x in range(radius + 1):
        y = int(sqrt(radius * radius - x * x))
        if x <= y:
            eight(cx, cy, x, y, color)


def by_angles(cx, cy, rx, ry, color, angles=range(360), cut=round, unit=pi / 180):
    for a in angles:
        putpixel(cut(cx + rx * cos(a * unit)), cut(cy + ry * sin(a * unit)), color)


def angles(hint, name, **what):
    """A loop over angles."""

    def function(x, y, radius, color):
        by_angles(x, y, radius, radius, color, **what)

    function.__name__ = name
    wrong(hint)(function)


STEPS = "the steps of the angle do not fit"
angles(STEPS, "a_degree_a_step")
angles(STEPS, "a_tenth_of_a_degree", angles=[a / 10 for a in range(3600)])
angles(STEPS, "five_degrees", angles=range(0, 360, 5))
angles(STEPS, "ten_degrees", angles=range(0, 360, 10))
angles("int() cuts off, and so does putpixel", "angles_cut_off", cut=int)
angles("int() cuts off, and so does putpixel", "angles_not_rounded", cut=lambda v: v)
angles("want radians", "degrees", unit=1)
angles("want radians", "degrees_to_360", angles=range(361), unit=1)
angles("want radians", "degrees_cut_off", cut=int, unit=1)
angles("the upper half is missing", "to_pi", angles=range(181))
angles("only a quarter is there", "to_half_pi", angles=range(91))


@wrong("x goes with cos, y with sin")
def cos_twice(cx, cy, radius, color):
    for a in range(360):
        part = radius * cos(a * pi / 180)
        putpixel(round(cx + part), round(cy + part), color)


@wrong("ask whether a float is less")
def asks_for_equal_floats(cx, cy, radius, color):
    a = 0.0
    while a != 2 * pi:
        by_angles(cx, cy, radius, radius, color, [a], unit=1)
        a += 0.01


@wrong("the lower half is missing")
def one_root(cx, cy, radius, color):
    for x in range(-radius, radius + 1):
        putpixel(cx + x, cy - round(sqrt(radius * radius - x * x)), color)


def of_all(cx, cy, radius, color, test):
    for x in range(-radius, radius + 1):
        for y in range(-radius, radius + 1):
            if test(sqrt(x * x + y * y)):
                putpixel(cx + x, cy + y, color)


@wrong("hardly a pixel lies exactly on the circle")
def exactly_on_it(cx, cy, radius, color):
    of_all(cx, cy, radius, color, lambda distance: distance == radius)


@wrong("is filled")
def all_inside(cx, cy, radius, color):
    of_all(cx, cy, radius, color, lambda distance: distance <= radius)


@wrong("thick in places")
def a_ring(cx, cy, radius, color):
    of_all(cx, cy, radius, color, lambda distance: round(distance) == radius)


def stepped(cx, cy, radius, color, d=None, more=(3, 5), goes_on=lambda x, y: x <= y):
    """The midpoint algorithm, whose parts can be mistaken."""
    x, y, d = 0, radius, 1 - radius if d is None else d
    while goes_on(x, y):
        eight(cx, cy, x, y, color)
        d, y = (d + 2 * x + more[0], y) if d < 0 else (d + 2 * (x - y) + more[1], y - 1)
        x += 1


@wrong("the eighth ends where x is y")
def goes_on_to_the_axis(x, y, radius, color):
    stepped(x, y, radius, color, goes_on=lambda x, y: y >= 0)


@wrong("d begins with 1 - radius")
def d_of_bresenham(x, y, radius, color):
    stepped(x, y, radius, color, 3 - 2 * radius)


@wrong("d begins with 1 - radius")
def d_begins_with_0(x, y, radius, color):
    stepped(x, y, radius, color, 0)


@wrong("as they are before the step")
def d_after_the_step(x, y, radius, color):
    stepped(x, y, radius, color, more=(5, 9))


@wrong("x grows by one, and y stays or falls")
def either_x_or_y(cx, cy, radius, color):
    x, y, d = 0, radius, 1 - radius
    while x <= y:
        eight(cx, cy, x, y, color)
        if d < 0:
            d, x = d + 2 * x + 3, x + 1
        else:
            d, y = d + 2 * (x - y) + 5, y - 1


@wrong("look at each of the putpixel calls")
def y_with_y(cx, cy, radius, color):
    for x in range(radius + 1):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            four(cx, cy, x, y, color)
            for v in (y, -y):
                putpixel(cx + v, cy + v, color)


@wrong("x is counted from the centre")
def x_of_the_screen(cx, cy, radius, color):
    for x in range(cx - radius, cx + radius + 1):
        putpixel(x, cy - round(sqrt(radius * radius - x * x)), color)


@wrong("radius 0 is its centre")
def nothing_for_0(x, y, radius, color):
    if radius > 0:
        midpoint(x, y, radius, color)


@wrong("always drawn around the same place")
def in_the_middle(x, y, radius, color):
    midpoint(320, 240, radius, color)


@wrong("are radius and colour exchanged")
def radius_and_color(x, y, radius, color):
    midpoint(x, y, color, radius)


@wrong("half as large")
def halved(x, y, radius, color):
    midpoint(x, y, radius // 2, color)


@wrong("x must grow, or y fall")
def never_ends(cx, cy, radius, color):
    x, y = 0, radius
    while x <= y:
        eight(cx, cy, x, y, color)


@wrong("root of a number below 0")
def beyond_the_end(cx, cy, radius, color):
    for x in range(radius + 2):
        y = round(sqrt(radius * radius - x * x))
        if x <= y:
            eight(cx, cy, x, y, color)


@pytest.mark.parametrize(("function", "hint"), wrong.table, ids=wrong.names)
def test_each_mistake_gets_its_hint(function, hint):
    verdict = check.circle(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
