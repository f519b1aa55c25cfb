"""check.bezier, casteljau and bspline: right formulas pass, each usual mistake gets its hint."""

from itertools import pairwise
from math import comb

import pytest

from bgi.lab import check
from tests.lab.mistakes import Mistakes


def mixed(points, weights):
    pairs = list(zip(points, weights, strict=False))
    return sum(w * x for (x, _), w in pairs), sum(w * y for (_, y), w in pairs)


def casteljau(points, t):
    while len(points) > 1:
        points = [mixed(pair, (1 - t, t)) for pair in pairwise(points)]
    return points[0]


def in_place(points, t):
    """Changes the list that it is given, as the algorithm is often written."""
    for size in range(len(points) - 1, 0, -1):
        for i in range(size):
            points[i] = mixed(points[i : i + 2], (1 - t, t))
    return points[0]


def bernstein(points, t):
    n = len(points) - 1
    return mixed(points, [comb(n, i) * (1 - t) ** (n - i) * t**i for i in range(n + 1)])


def cubic(points, t):
    a, b, c, d = points
    return bernstein([a, b, c, d], t)


def bspline(points, t):
    u = 1 - t
    second, third = 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1
    return mixed(points, [w / 6 for w in (u**3, second, third, t**3)])


@pytest.mark.parametrize("function", [casteljau, in_place, bernstein, cubic])
def test_any_formula_is_right(function):
    verdict = check.bezier(function)
    assert verdict, str(verdict)


@pytest.mark.parametrize("function", [casteljau, in_place, bernstein])
def test_any_number_of_points(function):
    assert check.casteljau(function)


def test_a_spline():
    assert check.bspline(bspline)
    assert check.bspline(lambda points, t: list(bspline(points, t)))


bezier, any_number, splines = Mistakes(), Mistakes(), Mistakes()


@bezier("it runs backwards")
def backwards(points, t):
    return casteljau(points, 1 - t)


@bezier("it goes straight from point to point")
def straight(points, t):
    first = min(int(3 * t), 2)
    return mixed(points[first : first + 2], (1 - (3 * t - first), 3 * t - first))


@bezier("the last point is not used")
def without_the_last(points, t):
    return casteljau(points[:-1], t)


@bezier("the first point is not used")
def without_the_first(points, t):
    return casteljau(points[1:], t)


@bezier("it is a straight line")
def end_to_end(points, t):
    return mixed([points[0], points[-1]], (1 - t, t))


@bezier("y is computed from the points' x")
def x_twice(points, t):
    x, _ = casteljau(points, t)
    return x, x


@bezier("x and y are exchanged")
def exchanged(points, t):
    x, y = casteljau(points, t)
    return y, x


@bezier("count three times: 3 *")
def without_threes(points, t):
    return mixed(points, ((1 - t) ** 3, (1 - t) ** 2 * t, (1 - t) * t**2, t**3))


@bezier("not twice")
def with_twos(points, t):
    return mixed(points, ((1 - t) ** 3, 2 * (1 - t) ** 2 * t, 2 * (1 - t) * t**2, t**3))


@bezier("between are exchanged")
def middle_exchanged(points, t):
    return mixed(points, ((1 - t) ** 3, 3 * (1 - t) * t**2, 3 * (1 - t) ** 2 * t, t**3))


@bezier("that is a B-spline")
def a_spline(points, t):
    return bspline(points, t)


@bezier("rounded")
def rounded(points, t):
    x, y = casteljau(points, t)
    return round(x), round(y)


@bezier("two numbers, (x, y)")
def only_x(points, t):
    return casteljau(points, t)[0]


@bezier("stops at one point")
def endless_recursion(points, t):
    return endless_recursion(points, t)


@any_number("any number of points")
def of_four_points(points, t):
    return cubic(points, t)


@any_number("one less step")
def one_step_too_many(points, t):
    points = list(points)
    for _ in range(len(points)):
        points = [mixed((points[i], points[i + 1]), (1 - t, t)) for i in range(len(points))]
    return points[0]


@splines("that is a Bézier curve")
def a_bezier_curve(points, t):
    return casteljau(points, t)


@splines("divided by 6")
def not_divided(points, t):
    x, y = bspline(points, t)
    return 6 * x, 6 * y


@splines("it runs backwards")
def spline_backwards(points, t):
    return bspline(points, 1 - t)


@splines("Catmull-Rom")
def catmull_rom(points, t):
    return mixed(
        points,
        (
            (-(t**3) + 2 * t**2 - t) / 2,
            (3 * t**3 - 5 * t**2 + 2) / 2,
            (-3 * t**3 + 4 * t**2 + t) / 2,
            (t**3 - t**2) / 2,
        ),
    )


@splines("x and y are exchanged")
def spline_exchanged(points, t):
    return bspline(points, t)[::-1]


@splines("it is a straight line")
def spline_end_to_end(points, t):
    return end_to_end(points, t)


@splines("straight from point to point")
def spline_straight(points, t):
    return straight(points, t)


def weighed(points, t, a=1, b=4, c=3):
    """A spline whose weights can be mistaken."""
    second, third = 3 * t**3 - 6 * t**2 + b, a * (-3 * t**3 + 3 * t**2 + c * t + 1)
    return mixed(points, [w / 6 for w in ((1 - t) ** 3, second, third, t**3)])


@splines("the third point is not used")
def without_the_third(points, t):
    return weighed(points, t, a=0)


@splines("the 4 of the second weight")
def without_the_four(points, t):
    return weighed(points, t, b=1)


@splines("the sign of 3 * t")
def another_sign(points, t):
    return weighed(points, t, c=-3)


@splines("the first point and the last are exchanged")
def outer_exchanged(points, t):
    a, b, c, d = points
    return bspline([d, b, c, a], t)


@splines("the second point and the third are exchanged")
def inner_exchanged(points, t):
    a, b, c, d = points
    return bspline([a, c, b, d], t)


@splines("rounded")
def spline_rounded(points, t):
    return tuple(map(int, bspline(points, t)))


ALL = [("bezier", bezier), ("casteljau", any_number), ("bspline", splines)]
TABLE = [(exercise, *row) for exercise, mistakes in ALL for row in mistakes.table]


@pytest.mark.parametrize(
    ("exercise", "function", "hint"), TABLE, ids=[f"{row[0]}-{row[1].__name__}" for row in TABLE]
)
def test_each_mistake_gets_its_hint(exercise, function, hint):
    verdict = getattr(check, exercise)(function)
    assert not verdict
    assert hint in verdict.hint, str(verdict)
