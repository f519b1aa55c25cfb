"""check.line: right algorithms pass."""

import pytest

from bgi import putpixel
from bgi.lab import check


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
        for function in (dda, bresenham, from_the_other_end):
            verdict = check.line(function, exactly=True)
            assert not verdict and "right, but not bgi's" in verdict.hint
