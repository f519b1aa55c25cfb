"""check.ellipse: right algorithms pass, and each usual mistake gets its hint."""

from math import sqrt

import pytest

from bgi import ellipse, putpixel
from bgi.lab import check
from tests.lab.mistakes import Mistakes
from tests.lab.test_circle import by_angles, four


def upper(cx, cy, rx, ry, color, set_four=four):
    """The midpoint algorithm's first region; returns where it ends."""
    x, y, d = 0, ry, ry * ry - rx * rx * ry + rx * rx / 4
    while ry * ry * x < rx * rx * y:
        set_four(cx, cy, x, y, color)
        x += 1
        if d >= 0:
            y -= 1
            d -= 2 * rx * rx * y
        d += 2 * ry * ry * x + ry * ry
    return x, y


def lower(cx, cy, rx, ry, color, x, y, set_four=four):
    """And its second region."""
    d = ry * ry * (x + 0.5) ** 2 + rx * rx * (y - 1) ** 2 - rx * rx * ry * ry
    while y >= 0:
        set_four(cx, cy, x, y, color)
        y -= 1
        if d <= 0:
            x += 1
            d += 2 * ry * ry * x
        d += rx * rx - 2 * rx * rx * y


def midpoint(cx, cy, rx, ry, color, set_four=four):
    x, y = upper(cx, cy, rx, ry, color, set_four)
    lower(cx, cy, rx, ry, color, x, y, set_four)


def by_roots(cx, cy, rx, ry, color, cut=round):
    """Each loop goes a little beyond the place where they meet: else there are gaps."""
    for x in range(rx + 1):
        y = ry * sqrt(1 - (x / rx) ** 2)
        if ry * ry * (x - 1) <= rx * rx * (y + 1):
            four(cx, cy, x, cut(y), color)
    for y in range(ry + 1):
        x = rx * sqrt(1 - (y / ry) ** 2)
        if ry * ry * (x + 1) > rx * rx * (y - 1):
            four(cx, cy, cut(x), y, color)


@pytest.mark.parametrize("function", [midpoint, by_roots])
def test_any_ellipse_is_right(function):
    verdict = check.ellipse(function)
    assert verdict, str(verdict)


def test_exactly_asks_for_the_pixels_of_ellipse():
    verdict = check.ellipse(midpoint, exactly=True)
    assert not verdict and "right, but not bgi's" in verdict.hint


wrong = Mistakes()


@wrong("does it call putpixel")
def draws_nothing(x, y, rx, ry, color):
    pass


@wrong("the exercise is to find out which")
def calls_ellipse(x, y, rx, ry, color):
    ellipse(x, y, 0, 360, rx, ry)


@wrong("the colour that the function is given")
def in_white(x, y, rx, ry, color):
    midpoint(x, y, rx, ry, 1 if color == 15 else 15)


@wrong("the radii are exchanged")
def exchanged(x, y, rx, ry, color):
    midpoint(x, y, ry, rx, color)


@wrong("it is a circle")
def one_radius(x, y, rx, ry, color):
    midpoint(x, y, rx, rx, color)


@wrong("the sides are missing")
def first_region(x, y, rx, ry, color):
    upper(x, y, rx, ry, color)


@wrong("top and bottom are missing")
def second_region(x, y, rx, ry, color):
    lower(x, y, rx, ry, color, *upper(x, y, rx, ry, color, lambda *pixel: None))


@wrong("the sides are missing, or have gaps")
def one_pixel_for_each_x(cx, cy, rx, ry, color):
    for x in range(rx + 1):
        four(cx, cy, x, round(ry * sqrt(1 - (x / rx) ** 2)), color)


@wrong("gives four pixels")
def one_quarter(x, y, rx, ry, color):
    def one(cx, cy, x, y, color):
        putpixel(cx + x, cy - y, color)

    midpoint(x, y, rx, ry, color, one)


@wrong("gives four pixels")
def the_right_half(x, y, rx, ry, color):
    def two(cx, cy, x, y, color):
        putpixel(cx + x, cy - y, color)
        putpixel(cx + x, cy + y, color)

    midpoint(x, y, rx, ry, color, two)


@wrong("straight above and below")
def without_the_axes(x, y, rx, ry, color):
    def inner(cx, cy, x, y, color):
        if x and y:
            four(cx, cy, x, y, color)

    midpoint(x, y, rx, ry, color, inner)


@wrong("is filled")
def filled(cx, cy, rx, ry, color):
    midpoint(cx, cy, rx, ry, color)
    for y in range(-ry, ry + 1):
        for x in range(-rx, rx + 1):
            if ry * ry * x * x + rx * rx * y * y < rx * rx * ry * ry:
                putpixel(cx + x, cy + y, color)


@wrong("around 0, 0")
def without_its_centre(x, y, rx, ry, color):
    midpoint(0, 0, rx, ry, color)


@wrong("too small by one")
def too_small(x, y, rx, ry, color):
    midpoint(x, y, rx - 1, ry - 1, color)


@wrong("twice as large")
def takes_the_diameters(x, y, rx, ry, color):
    midpoint(x, y, 2 * rx, 2 * ry, color)


@wrong("off by one")
def cuts_off(cx, cy, rx, ry, color):
    by_roots(cx, cy, rx, ry, color, int)


def angles(hint, name, **what):
    """A loop over angles."""

    def function(x, y, rx, ry, color):
        by_angles(x, y, rx, ry, color, **what)

    function.__name__ = name
    wrong(hint)(function)


STEPS = "the steps of the angle do not fit"
angles(STEPS, "a_degree_a_step")
angles(STEPS, "a_tenth_of_a_degree", angles=[a / 10 for a in range(3600)])
angles(STEPS, "ten_degrees", angles=range(0, 360, 10))
angles("int() cuts off, and so does putpixel", "angles_cut_off", cut=int)
angles("want radians", "degrees", unit=1)
angles("the upper half is missing", "to_pi", angles=range(181))
angles("only a quarter is there", "to_half_pi", angles=range(91))


@wrong("it is a circle")
def a_round_loop(x, y, rx, ry, color):
    by_angles(x, y, rx, rx, color)


@wrong("the radii are exchanged")
def sin_for_cos(x, y, rx, ry, color):
    by_angles(x, y, ry, rx, color)


@wrong("end with y = 0")
def without_the_last_row(cx, cy, rx, ry, color):
    def above(cx, cy, x, y, color):
        if y > 0:
            four(cx, cy, x, y, color)

    midpoint(cx, cy, rx, ry, color, above)


@wrong("four symmetric points, not eight")
def mirrored_as_a_circle(x, y, rx, ry, color):
    midpoint(x, y, rx, ry, color)
    midpoint(x, y, ry, rx, color)


@wrong("hardly a pixel lies exactly on the ellipse")
def exactly_on_it(cx, cy, rx, ry, color):
    for x in range(-rx, rx + 1):
        for y in range(-ry, ry + 1):
            if ry * ry * x * x + rx * rx * y * y == rx * rx * ry * ry:
                putpixel(cx + x, cy + y, color)


@wrong("not where x is y")
def regions_of_a_circle(cx, cy, rx, ry, color):
    x, y, d = 0, ry, ry * ry - rx * rx * ry + rx * rx / 4
    while x <= y:
        four(cx, cy, x, y, color)
        x += 1
        if d >= 0:
            y -= 1
            d -= 2 * rx * rx * y
        d += 2 * ry * ry * x + ry * ry
    lower(cx, cy, rx, ry, color, x, y)


@wrong("(x / rx)**2 + (y / ry)**2 is 1")
def without_squares(cx, cy, rx, ry, color):
    for x in range(rx + 1):
        four(cx, cy, x, round(ry * sqrt(1 - x / rx)), color)


@wrong("a d of its own to begin with")
def one_d_for_both(cx, cy, rx, ry, color):
    x, y, d = 0, ry, ry * ry - rx * rx * ry + rx * rx / 4
    while y >= 0:
        four(cx, cy, x, y, color)
        level = ry * ry * x < rx * rx * y
        if level or d <= 0:
            x += 1
            d += 2 * ry * ry * x
        if not level or d >= 0:
            y -= 1
            d -= 2 * rx * rx * y
        d += ry * ry if level else rx * rx


@wrong("always drawn around the same place")
def in_the_middle(x, y, rx, ry, color):
    midpoint(320, 240, rx, ry, color)


@wrong("half as large")
def halved(x, y, rx, ry, color):
    midpoint(x, y, rx // 2, ry // 2, color)


@pytest.mark.parametrize(("function", "hint"), wrong.table, ids=wrong.names)
def test_each_mistake_gets_its_hint(function, hint):
    verdict = check.ellipse(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
