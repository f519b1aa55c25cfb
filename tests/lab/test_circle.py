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


@wrong("pixels too many")
def many_angles(cx, cy, radius, color):
    for a in range(0, 3600):
        angle = a * pi / 1800
        putpixel(cx + round(radius * cos(angle)), cy + round(radius * sin(angle)), color)


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
