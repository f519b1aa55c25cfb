"""Points of curves: Bézier's, by de Casteljau or by the formula, and uniform cubic B-splines."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from itertools import pairwise

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


def _times_six(points: Points, t: float) -> Point:
    x, y = bspline(points, t)
    return 6 * x, 6 * y


def _backwards(points: Points, t: float) -> Point:
    return bezier(points, 1 - t)


def _one_coordinate(points: Points, t: float) -> Point:
    x, _ = bezier(points, t)
    return x, x


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
]
ERRORS = {
    "ValueError": "does it take any number of points?",
    "IndexError": "each round of de Casteljau has one point less: one less step",
    "deep": "de Casteljau calls itself with one point less, and stops at one point",
}

BSPLINE_SLIPS = [
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
    "bezier": AnswerExercise("bezier", NAMES, lambda: _cases(4, 4), bezier, point, SLIPS, ERRORS),
    "casteljau": AnswerExercise(
        "casteljau", NAMES, lambda: _cases(2, 3, 4, 5, 7), bezier, point, SLIPS, ERRORS
    ),
    "bspline": AnswerExercise(
        "bspline", NAMES, lambda: _cases(4, 4), bspline, point, BSPLINE_SLIPS
    ),
}
