"""Points of curves: Bézier's, by de Casteljau or by the formula, and uniform cubic B-splines."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import comb, prod

from bgi.lab.answered import AnswerExercise, Arguments, Slip, point

Point = tuple[float, float]
Points = Sequence[Point]


def bezier(points: Points, t: float) -> Point:
    """The point of a Bézier curve: de Casteljau's construction, for any number of points."""
    found = list(points)
    while len(found) > 1:
        found = [_between(a, b, t) for a, b in pairwise(found)]
    return found[0]


def bspline(points: Points, t: float) -> Point:
    """The point of one segment of a uniform cubic B-spline."""
    u = 1 - t
    return _mixed(
        points, (u**3 / 6, (3 * t**3 - 6 * t**2 + 4) / 6, (3 * u**3 - 6 * u**2 + 4) / 6, t**3 / 6)
    )


def _between(a: Point, b: Point, t: float) -> Point:
    return a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])


def _mixed(points: Points, weights: Sequence[float]) -> Point:
    pairs = list(zip(weights, points, strict=False))
    return sum(w * x for w, (x, _) in pairs), sum(w * y for w, (_, y) in pairs)


HAT = [(0, 0), (100, 200), (300, 200), (400, 0)]
TIMES = 0, 1, 0.5, 0.25, 0.75, 0.1, 1 / 3, 0.9


def _cases(*sizes: int) -> Iterator[Arguments]:
    for t in TIMES:
        yield HAT, t
    chance = random.Random(2)
    for size in sizes * 4:
        points = [(chance.randrange(640), chance.randrange(480)) for _ in range(size)]
        for t in TIMES:
            yield points, t


def _powers(points: Points, t: float, *factors: int) -> Point:
    """A cubic with other binomial factors."""
    u = 1 - t
    terms = u**3, u**2 * t, u * t**2, t**3
    return _mixed(points, [f * term for f, term in zip(factors, terms, strict=True)])


def _catmull_rom(points: Points, t: float) -> Point:
    weights = (
        (-(t**3) + 2 * t**2 - t) / 2,
        (3 * t**3 - 5 * t**2 + 2) / 2,
        (-3 * t**3 + 4 * t**2 + t) / 2,
        (t**3 - t**2) / 2,
    )
    return _mixed(points, weights)


def _along(points: Points, t: float) -> Point:
    """The straight line from the first point to the last one."""
    return _between(points[0], points[-1], t)


def _sides(points: Points, t: float) -> Point:
    """The lines from point to point."""
    place = t * (len(points) - 1)
    first = min(int(place), len(points) - 2)
    return _between(points[first], points[first + 1], place - first)


def _sixths(t: float) -> Sequence[float]:
    """Bézier's weights, divided by 6."""
    return [comb(3, i) * t**i * (1 - t) ** (3 - i) / 6 for i in range(4)]


def _times_six(points: Points, t: float) -> Point:
    x, y = bspline(points, t)
    return 6 * x, 6 * y


def _backwards(points: Points, t: float) -> Point:
    return bezier(points, 1 - t)


def _one_coordinate(points: Points, t: float) -> Point:
    x, _ = bezier(points, t)
    return x, x


def _weighed(points: Points, t: float, factor: Callable[[int, int], int]) -> Point:
    """By the formula, with other binomial numbers."""
    n = len(points) - 1
    return _mixed(points, [factor(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])


def _lagrange(points: Points, t: float) -> Point:
    """The polynomial through all points."""
    n = len(points) - 1
    weights = [prod((n * t - j) / (i - j) for j in range(n + 1) if j != i) for i in range(n + 1)]
    return _mixed(points, weights)


SLIPS = [
    Slip(_backwards, "it runs backwards: at t = 0 it is at the first point, at t = 1 at the last"),
    Slip(_sides, "it goes straight from point to point: de Casteljau mixes them again and again"),
    Slip(
        lambda points, t: bezier(points[:-1], t),
        "the last point is not used, so the curve does not end there: range(a, b) stops before b",
    ),
    Slip(lambda points, t: bezier(points[1:], t), "the first point is not used"),
    Slip(_along, "it is a straight line: the points between are not used"),
    Slip(_one_coordinate, "y is computed from the points' x"),
    Slip(lambda points, t: bezier(points, t)[::-1], "x and y are exchanged"),
    Slip(
        lambda points, t: _powers(points, t, 1, 1, 1, 1),
        "the points between count three times: 3 * (1 - t)**2 * t and 3 * (1 - t) * t**2",
    ),
    Slip(
        lambda points, t: _powers(points, t, 1, 2, 2, 1),
        "the points between count three times, not twice: 1 3 3 1 is Pascal's row",
    ),
    Slip(
        lambda points, t: _mixed(
            points, ((1 - t) ** 3, 3 * (1 - t) * t**2, 3 * (1 - t) ** 2 * t, t**3)
        ),
        "the two points between are exchanged: the second one counts most at t = 1/3",
    ),
    Slip(bspline, "that is a B-spline, which does not go through its ends; a Bézier curve does"),
    Slip(_catmull_rom, "that is a curve from the second point to the third"),
    Slip(
        lambda points, t: bezier(points, t * t),
        "t is squared once too often",
    ),
    Slip(lambda points, t: bezier(points, 0.5), "t is not used: it is always in the middle"),
    Slip(
        lambda points, t: bezier(points, int(t)), "int() leaves 0 and 1 of t: t is no whole number"
    ),
    Slip(lambda points, t: points[0], "it stays at the first point: which one is returned?"),
    Slip(
        lambda points, t: _between(points[0], points[1], t),
        "that is one round only: go on until one point is left",
    ),
    Slip(
        lambda points, t: bezier(points[:3], t),
        "only the first three points are used: go on with as many as there are",
    ),
    Slip(
        lambda points, t: bezier(points[:4], t),
        "only the first four points are used: go on with as many as there are",
    ),
    Slip(
        lambda points, t: _weighed(points, t, lambda n, i: 1),
        "the binomial numbers are missing: math.comb(n, i) * t**i * (1 - t)**(n - i)",
    ),
    Slip(
        lambda points, t: _weighed(points, t, lambda n, i: comb(n, i) * (i < n)),
        "the last weight is missing: i runs from 0 to n, range(n + 1)",
    ),
    Slip(
        lambda points, t: _weighed([*points, (0, 0)], t, comb),
        "n is too large by one: four points make a curve of degree 3",
    ),
    Slip(_lagrange, "that curve goes through all its points: a Bézier curve through its ends only"),
]
OTHERWISE = (
    "each round mixes neighbours, (1 - t) * a + t * b for x and for y, until one point is left; at"
    " t = 0 that is the first point, at t = 1 the last one"
)
ERRORS = {
    "ValueError": "does it take any number of points?",
    "IndexError": "each round of de Casteljau has one point less: one less step",
    "deep": "de Casteljau calls itself with one point less, and stops at one point",
}

BSPLINE_SLIPS = [
    Slip(lambda points, t: bspline(points, 0.5), "t is not used: it is always in the middle"),
    Slip(
        lambda points, t: _mixed(((0, 0), *points), (0, *_sixths(t))),
        "the weights are those of a Bézier curve, divided by 6: 1 4 1 stands for 1 3 3 1 here",
    ),
    Slip(
        lambda points, t: _mixed(
            points, ((1 - t) ** 2 / 2, (-2 * t * t + 2 * t + 1) / 2, t * t / 2)
        ),
        "that is a quadratic B-spline, of three points",
    ),
    Slip(
        lambda points, t: _mixed([bspline(points, t)], (2,)),
        "the four weights are divided by 6: together they are 1",
    ),
    Slip(lambda points, t: bspline([*points[:3], (0, 0)], t), "the last point is not used"),
    Slip(lambda points, t: bspline([(0, 0), *points[1:]], t), "the first point is not used"),
    Slip(bezier, "that is a Bézier curve: a B-spline does not go through its points"),
    Slip(_times_six, "the four weights are divided by 6: together they are 1"),
    Slip(lambda points, t: bspline(points, 1 - t), "it runs backwards"),
    Slip(_catmull_rom, "that is a Catmull-Rom spline: it goes through its points"),
    Slip(lambda points, t: bspline(points, t)[::-1], "x and y are exchanged"),
    Slip(_along, "it is a straight line: the points between are not used"),
    Slip(_sides, "it goes straight from point to point"),
    Slip(
        lambda points, t: _mixed(
            points, ((1 - t) ** 3 / 6, (3 * t**3 - 6 * t**2 + 4) / 6, 0, t**3 / 6)
        ),
        "the third point is not used",
    ),
    Slip(
        lambda points, t: _mixed(
            points,
            (
                t**3 / 6,
                (3 * t**3 - 6 * t**2 + 4) / 6,
                (-3 * t**3 + 3 * t**2 + 3 * t + 1) / 6,
                (1 - t) ** 3 / 6,
            ),
        ),
        "the weights of the first point and the last are exchanged: the first has (1 - t)**3",
    ),
    Slip(
        lambda points, t: _mixed(
            points,
            (
                (1 - t) ** 3 / 6,
                (-3 * t**3 + 3 * t**2 + 3 * t + 1) / 6,
                (3 * t**3 - 6 * t**2 + 4) / 6,
                t**3 / 6,
            ),
        ),
        "the weights of the second point and the third are exchanged",
    ),
    Slip(
        lambda points, t: _mixed(
            points,
            (
                (1 - t) ** 3 / 6,
                (3 * t**3 - 6 * t**2 + 4) / 6,
                (-3 * t**3 + 3 * t**2 - 3 * t + 1) / 6,
                t**3 / 6,
            ),
        ),
        "the sign of 3 * t in the third weight is wrong: the four weights together are 1",
    ),
    Slip(
        lambda points, t: _mixed(
            points,
            (
                (1 - t) ** 3 / 6,
                (3 * t**3 - 6 * t**2 + 1) / 6,
                (-3 * t**3 + 3 * t**2 + 3 * t + 1) / 6,
                t**3 / 6,
            ),
        ),
        "the 4 of the second weight is missing: the four weights together are 1",
    ),
]

NAMES = "points", "t"
EXERCISES = {
    "bezier": AnswerExercise(
        *("bezier", NAMES, lambda: _cases(4, 4), bezier, point, SLIPS, ERRORS),
        otherwise=OTHERWISE,
    ),
    "casteljau": AnswerExercise(
        *("casteljau", NAMES, lambda: _cases(2, 3, 4, 5, 7), bezier, point, SLIPS, ERRORS),
        otherwise=OTHERWISE,
    ),
    "bspline": AnswerExercise(
        *("bspline", NAMES, lambda: _cases(4, 4), bspline, point, BSPLINE_SLIPS),
        otherwise="are the four weights 1 together, for every t? At t = 0 they are 1, 4, 1, 0"
        " sixths, at t = 1 they are 0, 1, 4, 1",
    ),
}
