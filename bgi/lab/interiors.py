"""Filled polygons: which pixels must be filled, what is tried, and the usual mistakes.

The rule: a pixel that a side touches, which is less than one pixel away, across or down, is free.
All others are filled if they are inside by the even-odd rule, as `fillpoly` has it, and only then.
So it does not matter how crossings are rounded, nor to which of two polygons a common side belongs.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from bgi.lab.comparison import Pixels
from bgi.lab.drawn import DrawingExercise, Evidence, Fault, Place, Sign, Trial, places
from bgi.lab.signs import COMMON, only

Mask = NDArray[np.bool_]
Shape = list[Place]


def sides(points: Shape) -> list[tuple[Place, Place]]:
    """From corner to corner, and back to the first."""
    return list(pairwise([*points, points[0]]))


def touched(points: Shape, size: tuple[int, int]) -> Mask:
    """The pixels that a side comes nearer to than one pixel: the side meets a square around them.

    That is so if it is not beyond the square in x, nor in y, nor seen along the side itself.
    """
    y, x = np.mgrid[: size[0], : size[1]]
    found = np.zeros(size, np.bool_)
    for (x1, y1), (x2, y2) in sides(points):
        dx, dy = x2 - x1, y2 - y1
        near_x = (min(x1, x2) < x + 1) & (max(x1, x2) > x - 1)
        near_y = (min(y1, y2) < y + 1) & (max(y1, y2) > y - 1)
        aside = np.abs(dx * (y - y1) - dy * (x - x1))
        found |= near_x & near_y & (aside < max(abs(dx) + abs(dy), 1))
    return found


def inside(points: Shape, size: tuple[int, int]) -> Mask:
    """The pixels inside by the even-odd rule; those on a side may be in or out."""
    y, x = np.mgrid[: size[0], : size[1]]
    found = np.zeros(size, np.bool_)
    for (x1, y1), (x2, y2) in sides(points):
        if y1 > y2:
            x1, y1, x2, y2 = x2, y2, x1, y1
        if y1 < y2:
            found ^= (y1 <= y) & (y < y2) & ((x - x1) * (y2 - y1) < (x2 - x1) * (y - y1))
    return found


def _expected(points: Shape, color: int) -> Callable[[Pixels], Pixels]:
    def expected(got: Pixels) -> Pixels:
        width, height = (max(side) + 2 for side in zip(*points, strict=True))
        size = height, width
        free, filled = touched(points, size), inside(points, size)
        picture = np.zeros_like(got)
        part = picture[:height, :width]
        part[filled & ~free] = color
        part[free & (got[:height, :width] != 0)] = color
        return picture

    return expected


SHAPES: list[tuple[str, Shape]] = [
    ("plain", [(20, 20), (60, 20), (60, 50), (20, 50)]),
    ("plain", [(20, 60), (40, 20), (75, 70)]),
    ("plain", [(50, 20), (80, 45), (50, 75), (20, 45)]),
    ("corner", [(20, 20), (70, 35), (65, 60), (30, 70)]),
    ("corner", [(50, 20), (90, 50), (75, 90), (25, 90), (10, 50)]),
    ("concave", [(20, 20), (50, 60), (80, 20), (80, 90), (20, 90)]),
    ("concave", [(20, 20), (80, 20), (80, 90), (50, 40), (20, 90)]),
    ("level", [(20, 20), (40, 20), (40, 50), (70, 50), (70, 20), (90, 20), (90, 80), (20, 80)]),
    ("level", [(20, 40), (50, 40), (50, 20), (80, 20), (80, 70), (60, 70), (60, 90), (20, 90)]),
    (
        "concave",
        [(60, 10), (75, 45), (110, 45), (82, 68), (93, 105), (60, 82), (27, 105), (38, 68)],
    ),
    ("crossing", [(60, 10), (90, 105), (10, 45), (110, 45), (30, 105)]),
    ("crossing", [(20, 20), (90, 80), (90, 20), (20, 80)]),
]
RANDOM = 40


def _trials() -> Iterator[Trial]:
    chance = random.Random(5)
    shapes = list(SHAPES)
    for number in range(RANDOM):
        corners = 3 if number < RANDOM // 2 else chance.randrange(4, 9)
        shape = [(chance.randrange(5, 140), chance.randrange(5, 120)) for _ in range(corners)]
        shapes.append(("plain" if corners == 3 else "crossing", shape))
    for number, (about, shape) in enumerate(shapes):
        color = 15 - number % 15
        yield Trial((shape, color), _expected(shape, color), about=about)


# The signs


def _shape(fault: Fault) -> Shape:
    shape: Shape = fault.arguments[0]
    return shape


def _only_sides(evidence: Evidence) -> bool:
    """What is drawn are the sides, and nothing inside."""

    def seems(fault: Fault) -> bool:
        rows = {y for _, y in fault.drawn}
        inside = fault.drawn & _required(fault)
        return not fault.extra and not inside and len(fault.drawn) > len(rows) > 1

    return evidence.mostly and evidence.always(seems)


def _required(fault: Fault) -> set[Place]:
    size = fault.got.shape[0], fault.got.shape[1]
    return places(inside(_shape(fault), size) & ~touched(_shape(fault), size))


def _exchanged(evidence: Evidence) -> bool:
    """x and y are."""
    return evidence.mostly and evidence.always(
        lambda fault: {(y, x) for x, y in _required(fault)} <= fault.drawn
    )


def _boxed(evidence: Evidence) -> bool:
    """All of the box around the polygon is filled."""

    def seems(fault: Fault) -> bool:
        across, down = zip(*_shape(fault), strict=True)
        box = (max(across) - min(across)) * (max(down) - min(down))
        return not fault.missing and len(fault.drawn) >= box

    return evidence.always(seems)


def _in_rows(rows: Callable[[Fault], set[int]]) -> Callable[[Evidence], bool]:
    """Only such rows are wrong."""
    return lambda evidence: (
        len(evidence.faults) > 1
        and evidence.always(
            lambda fault: {y for _, y in fault.missing | fault.extra} <= rows(fault)
        )
    )


def _corner_rows(fault: Fault) -> set[int]:
    return {y for _, y in _shape(fault)}


def _last_side_rows(fault: Fault) -> set[int]:
    (_, y1), (_, y2) = _shape(fault)[-1], _shape(fault)[0]
    return set(range(min(y1, y2), max(y1, y2) + 1))


def _every_second_row(evidence: Evidence) -> bool:
    def seems(fault: Fault) -> bool:
        rows = {y for _, y in fault.missing}
        return not fault.extra and len({y % 2 for y in rows}) == 1

    return evidence.mostly and evidence.always(seems)


def _near_sides(evidence: Evidence) -> bool:
    """What is wrong lies within two pixels of a side."""

    def seems(fault: Fault) -> bool:
        x, y = (np.array(side) for side in zip(*(fault.missing | fault.extra), strict=True))
        free = touched(_shape(fault), (int(y.max()) + 4, int(x.max()) + 4))
        near = free.copy()
        for down in (-2, -1, 0, 1, 2):
            for right in (-2, -1, 0, 1, 2):
                near |= np.roll(free, (down, right), (0, 1))
        return bool(near[y, x].all())

    return evidence.always(seems)


def _kinds(*kinds: str) -> Callable[[Evidence], bool]:
    """Only polygons of such kinds are wrong."""
    return only(lambda fault: fault.trial.about in kinds)


def _only_extra(evidence: Evidence) -> bool:
    return evidence.always(lambda fault: not fault.missing)


def _only_missing(evidence: Evidence) -> bool:
    return evidence.always(lambda fault: not fault.extra)


SIGNS: list[Sign] = [
    *COMMON,
    (_boxed, "the whole box around the polygon is filled: where does each row begin and end?"),
    (_exchanged, "x and y are exchanged: putpixel(x, y, color), x to the right, y down"),
    (_only_sides, "only the sides are there: the pixels between them are wanted"),
    (
        lambda evidence: _kinds("crossing")(evidence) and _only_extra(evidence),
        "sides that cross: by the even-odd rule a part that lies inside twice is outside",
    ),
    (
        _in_rows(_corner_rows),
        "rows that go through a corner are wrong: there two sides meet. Count each side from its"
        " upper end, and stop before its lower end; level sides are not counted at all",
    ),
    (
        _in_rows(_last_side_rows),
        "the side from the last point back to the first is missing",
    ),
    (_every_second_row, "every second row is missing: the step of y is 1"),
    (
        _kinds("concave", "level", "crossing"),
        "a row may leave the polygon and come back: sort its crossings from left to right, and fill"
        " from the first to the second, from the third to the fourth",
    ),
    (
        _near_sides,
        "the rim is off: it is more than a pixel beside the true side. x grows by dx / dy from row"
        " to row, and is rounded only to set a pixel",
    ),
    (
        _only_missing,
        "parts are not filled: has each row found all its crossings, also those with sides that go"
        " up, and sorted them from left to right?",
    ),
    (_only_extra, "it is filled too far: where does a row end?"),
]


def _trouble(fault: Fault) -> str:
    assert fault.outcome.trouble is not None
    if isinstance(fault.outcome.trouble.error, ZeroDivisionError):
        return "a level side: y2 - y1 is 0. It crosses no row: leave it out"
    if isinstance(fault.outcome.trouble.error, IndexError):
        return (
            "an odd number of crossings in a row? Count each side from its upper end, and stop"
            " before its lower end. Or points[i + 1] after the last point? That is joined to the"
            " first one"
        )
    if isinstance(fault.outcome.trouble.error, ValueError):
        return "a polygon has any number of points, three or more: take them in a loop"
    return ""


EXERCISE = DrawingExercise(
    "polygon",
    ("points", "color"),
    _trials,
    SIGNS,
    _trouble,
    allowed=("line",),
    instead="set the pixels by putpixel, or level lines by line(): the exercise is to find them",
    otherwise="the crossings are elsewhere: where a row y meets a side, x is"
    " x1 + (y - y1) * (x2 - x1) / (y2 - y1), with x1 and y1 of the same end, and / not //. A side"
    " counts only between its upper end and its lower end",
)
