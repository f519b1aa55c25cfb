"""Arguments for the rows: places on a screen of 640x480, by chance that is always the same."""

import random
from collections.abc import Callable
from typing import Any

import numpy as np

from bench.timing import Arguments

Make = Callable[[random.Random], Arguments]
CALLS = 200


def points(extra: tuple[Any, ...] = (), count: int = CALLS) -> Make:
    """Places (x, y), each followed by `extra`."""
    return lambda dice: [(dice.randrange(640), dice.randrange(480), *extra) for _ in range(count)]


def boxes(width: int, height: int, count: int = CALLS) -> Make:
    """(left, top, right, bottom), both ends drawn, all within the screen."""

    def make(dice: random.Random) -> Arguments:
        corners = _corners(dice, width, height, count)
        return [(x, y, x + width - 1, y + height - 1) for x, y in corners]

    return make


def within(width: int, height: int, *extra: Any, count: int = CALLS) -> Make:
    """Corners (x, y) of boxes within the screen, each followed by `extra`."""
    return lambda dice: [(*corner, *extra) for corner in _corners(dice, width, height, count)]


def middles(radius: int, *extra: Any, count: int = CALLS) -> Make:
    """Centres (x, y) of circles within the screen, each followed by `extra`."""

    def make(dice: random.Random) -> Arguments:
        size = 2 * radius + 1
        corners = _corners(dice, size, size, count)
        return [(x + radius, y + radius, *extra) for x, y in corners]

    return make


def anywhere(radii: int, *angles: int, count: int = CALLS) -> Make:
    """Centres with one or two radii of any size, `angles` between, so that many are clipped."""

    def make(dice: random.Random) -> Arguments:
        return [
            (*place, *angles, *(dice.randrange(1, 100) for _ in range(radii)))
            for place in points(count=count)(dice)
        ]

    return make


def lines(count: int = CALLS) -> Make:
    """Ends anywhere."""
    return lambda dice: [
        (dice.randrange(640), dice.randrange(480), dice.randrange(640), dice.randrange(480))
        for _ in range(count)
    ]


def polygons(shape: list[tuple[int, int]], count: int = CALLS) -> Make:
    """A closed shape at many places."""
    width, height = (max(point[axis] for point in shape) + 1 for axis in (0, 1))

    def make(dice: random.Random) -> Arguments:
        corners = _corners(dice, width, height, count)
        return [([(x + dx, y + dy) for dx, dy in (*shape, shape[0])],) for x, y in corners]

    return make


def any_polygons(corners: int, size: int, count: int = CALLS) -> Make:
    """Closed polygons of any shape, so that none returns, within boxes of that size."""

    def make(dice: random.Random) -> Arguments:
        found = []
        for x, y in _corners(dice, size, size, count):
            shape = [(x + dice.randrange(size), y + dice.randrange(size)) for _ in range(corners)]
            found.append(([*shape, shape[0]],))
        return found

    return make


def floats(make: Make, count: int = 2) -> Make:
    """The same, the first `count` arguments as floats with fractions."""
    return lambda dice: [(*(v + 0.25 for v in each[:count]), *each[count:]) for each in make(dice)]


def numpy_ints(make: Make) -> Make:
    """The same, as numpy's integers."""
    return lambda dice: [tuple(np.int64(v) for v in each) for each in make(dice)]


def always(*values: Any, count: int = CALLS) -> Make:
    """The same arguments each time."""
    return lambda _: [values] * count


def in_turn(*choices: tuple[Any, ...], count: int = CALLS) -> Make:
    """One choice after the other."""
    return lambda _: [choices[number % len(choices)] for number in range(count)]


def _corners(dice: random.Random, width: int, height: int, count: int) -> list[tuple[int, int]]:
    return [(dice.randrange(641 - width), dice.randrange(481 - height)) for _ in range(count)]
