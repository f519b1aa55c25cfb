"""check.line: right algorithms pass, and each usual mistake gets its hint."""

import pytest

from bgi import line, putpixel
from bgi.lab import check
from tests.lab.mistakes import Mistakes

# Right ones


def dda(x1, y1, x2, y2, color):
    steps = max(abs(x2 - x1), abs(y2 - y1))
    for i in range(steps + 1):
        part = i / steps if steps else 0
        putpixel(round(x1 + part * (x2 - x1)), round(y1 + part * (y2 - y1)), color)


def dda_of_the_textbook(x1, y1, x2, y2, color):
    dx, dy = x2 - x1, y2 - y1
    steps = max(abs(dx), abs(dy))
    x, y = x1, y1
    putpixel(round(x), round(y), color)
    for _ in range(steps):
        x += dx / steps
        y += dy / steps
        putpixel(int(x + 0.5), int(y + 0.5), color)


def bresenham(x1, y1, x2, y2, color):
    dx, dy = abs(x2 - x1), -abs(y2 - y1)
    step_x, step_y = 1 if x1 < x2 else -1, 1 if y1 < y2 else -1
    error = dx + dy
    while True:
        putpixel(x1, y1, color)
        if (x1, y1) == (x2, y2):
            break
        twice = 2 * error
        if twice >= dy:
            error += dy
            x1 += step_x
        if twice <= dx:
            error += dx
            y1 += step_y


def pixel(steep, x, y, color):
    if steep:
        putpixel(y, x, color)
    else:
        putpixel(x, y, color)


def midpoint(x1, y1, x2, y2, color):
    steep = abs(y2 - y1) > abs(x2 - x1)
    if steep:
        x1, y1, x2, y2 = y1, x1, y2, x2
    if x1 > x2:
        x1, y1, x2, y2 = x2, y2, x1, y1
    dx, dy, step = x2 - x1, abs(y2 - y1), 1 if y2 > y1 else -1
    d, y = 2 * dy - dx, y1
    for x in range(x1, x2 + 1):
        pixel(steep, x, y, color)
        if d > 0:
            y += step
            d -= 2 * dx
        d += 2 * dy


def from_the_other_end(x1, y1, x2, y2, color):
    midpoint(x2, y2, x1, y1, color)


@pytest.mark.parametrize(
    "function", [dda, dda_of_the_textbook, bresenham, midpoint, from_the_other_end]
)
def test_any_algorithm_is_right(function):
    verdict = check.line(function)
    assert verdict, str(verdict)
    assert verdict.passed == verdict.tried > 200


# Wrong ones

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


@pytest.mark.parametrize(("function", "hint"), wrong.table, ids=wrong.names)
def test_each_mistake_gets_its_hint(function, hint):
    verdict = check.line(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)


class TestExactly:
    def test_asks_for_the_pixels_of_line(self):
        """Which draws downwards, and steps early at a tie."""

        def downwards(x1, y1, x2, y2, color):
            if y1 > y2:
                x1, y1, x2, y2 = x2, y2, x1, y1
            steps, rest = max(abs(x2 - x1), y2 - y1), min(abs(x2 - x1), y2 - y1)
            right = 1 if x2 > x1 else -1
            for i in range(steps + 1):
                less = (2 * rest * i + steps) // (2 * steps) if steps else 0
                if steps == y2 - y1:
                    putpixel(x1 + right * less, y1 + i, color)
                else:
                    putpixel(x1 + right * i, y1 + less, color)

        assert check.line(downwards, exactly=True)
        assert check.line(from_the_other_end)
        assert not check.line(from_the_other_end, exactly=True)
