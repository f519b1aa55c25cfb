"""Circles and ellipses: which pixels they may have, and what is tried.

The rule: where the curve is more level than upright, of each column the pixel that is nearest to
the true curve; of each row elsewhere. Midpoint and Bresenham find the same pixels for a circle
(M. D. McIlroy, "Best approximate circles on integer grids", ACM Transactions on Graphics 2, 1983).
For an ellipse they do not quite: so there a tenth of a pixel is no mistake, and where level and
upright meet, a pixel that is less than one away from the curve is right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, partial
from math import sqrt
from typing import NamedTuple

import numpy as np

from bgi.graphics import Graphics
from bgi.lab.comparison import Pixels
from bgi.lab.drawn import DrawingExercise, Fault, Place, Sign, Trial, by_bgi
from bgi.lab.ovalsigns import CIRCLE_SIGNS, ELLIPSE_SIGNS, NO_CIRCLE, NO_ELLIPSE
from bgi.lab.signs import INSTEAD, only

MIRRORS = (1, 1), (-1, 1), (1, -1), (-1, -1)

SLACK = 0.1
"""How far from its nearest place a pixel of an ellipse may be, beyond a half."""


class Quarter(NamedTuple):
    """The pixels of a quarter, seen from the centre."""

    steps: list[list[Place]]
    """Of each column and of each row: one of these must be set; the first is the usual one."""
    legal: set[Place]
    """All that may be set."""


@cache
def quarter(rx: int, ry: int) -> Quarter:
    """The rule for the pixels to the right and up, both counted from 0."""
    legal = {(x, y) for x in range(rx + 1) for y in _near(x, rx, ry) if _is_right(x, y, rx, ry)}
    legal |= {(x, y) for y in range(ry + 1) for x in _near(y, ry, rx) if _is_right(x, y, rx, ry)}
    legal = {(x, y) for x, y in legal if x <= rx and y <= ry}
    steps = [[p for p in sorted(legal) if p[0] == x] for x in range(rx + 1)]
    steps += [[p for p in sorted(legal) if p[1] == y] for y in range(ry + 1)]
    usual = {(x, y) for x, y in legal if _off(x, y, rx, ry) <= 0.5}
    for step in steps:
        step.sort(key=lambda pixel: pixel not in usual)
    return Quarter(steps, legal)


def _near(x: int, rx: int, ry: int) -> tuple[int, int]:
    """The two pixels of a column that lie around the curve."""
    below = int(_height(x, rx, ry))
    return below, below + 1


def _height(x: int, rx: int, ry: int) -> float:
    return ry * sqrt(rx * rx - x * x) / rx if rx else ry


def _off(x: int, y: int, rx: int, ry: int) -> float:
    """How far a pixel is from the curve: down where that is level, across where it is upright."""
    if ry * ry * x <= rx * rx * y:
        return abs(y - _height(min(x, rx), rx, ry))
    return abs(x - _height(min(y, ry), ry, rx))


def _is_right(x: int, y: int, rx: int, ry: int) -> bool:
    off = _off(x, y, rx, ry)
    if rx == ry:
        return off <= 0.5
    level_before = ry * ry * (x - 1) <= rx * rx * (y + 1)
    level_after = ry * ry * (x + 1) <= rx * rx * (y - 1)
    down, across = y - _height(min(x, rx), rx, ry), x - _height(min(y, ry), ry, rx)
    meeting = level_before and not level_after and max(abs(down), abs(across)) < 1
    return off <= 0.5 + SLACK or meeting


def _right(center: Place, radii: Place, color: int) -> Callable[[Pixels], Pixels]:
    def expected(got: Pixels) -> Pixels:
        (cx, cy), picture = center, np.zeros_like(got)
        for right, down in MIRRORS:
            for step in quarter(*radii).steps:
                there = [(cx + right * x, cy + down * y) for x, y in step]
                for x, y in [(x, y) for x, y in there if got[y, x]] or there[:1]:
                    picture[y, x] = color
        return picture

    return expected


LARGE = 61, 77, 90, 118, 150, 187, 200


def _circles(exactly: bool) -> Iterator[Trial]:
    """The easy ones first."""
    for number, radius in enumerate([10, 5, 3, 2, 1, 0, *range(6, 60), *LARGE]):
        center, color = (320, 240) if radius > 60 else (200 + number, 100), 15 - number % 15
        if exactly:
            expected = by_bgi(partial(_circle, center=center, radius=radius, color=color))
        else:
            expected = _right(center, (radius, radius), color)
        yield Trial((*center, radius, color), expected)


def _circle(screen: Graphics, center: Place, radius: int, color: int) -> None:
    screen.circle(*center, radius, color)


def _radii() -> Iterator[Place]:
    """No ellipse is so flat that its ends are a level line: textbooks' algorithms stop before."""
    yield from [(20, 10), (10, 20), (12, 12)]
    for rx in range(4, 120, 9):
        for ry in range(4, 100, 11):
            if ry * ry > 2 * rx and rx * rx > 2 * ry:
                yield rx, ry
    yield from [(200, 100), (100, 200), (300, 40), (35, 230)]


def _ellipses(exactly: bool) -> Iterator[Trial]:
    """The easy ones first."""
    for number, (rx, ry) in enumerate(_radii()):
        center, color = (320, 235 + number % 5), 15 - number % 15
        if exactly:
            expected = by_bgi(partial(_ellipse, center=center, radii=(rx, ry), color=color))
        else:
            expected = _right(center, (rx, ry), color)
        yield Trial((*center, rx, ry, color), expected)


def _ellipse(screen: Graphics, center: Place, radii: Place, color: int) -> None:
    screen.ellipse(*center, 0, 360, *radii, color)


def _keeps_the_rule(fault: Fault) -> bool:
    """It is a right one, where exactly that of bgi is wanted."""
    x, y, *radii, color = fault.arguments
    expected = _right((x, y), (radii[0], radii[-1]), color)
    return np.array_equal(fault.got, expected(fault.got))


NOT_BGIS: Sign = (
    only(_keeps_the_rule),
    "it is right, but not bgi's: look at the pixels that differ. Two are nearly as near there, or"
    " it is a very small one",
)


def _trouble(fault: Fault) -> str:
    """The hint for an error, or a loop without an end."""
    assert fault.outcome.trouble is not None
    if isinstance(fault.outcome.trouble.error, ValueError):
        return (
            "the root of a number below 0? Outside of the curve there is no point, and x is counted"
            " from the centre"
        )
    if fault.outcome.trouble.kind == "endless":
        return (
            "the loop's end is never met: in every step x must grow, or y fall, or the angle grow;"
            " and ask whether a float is less, not whether it is equal"
        )
    return ""


def circle(exactly: bool) -> DrawingExercise:
    """Circles; exactly those of bgi, or any that are right."""
    names = "x", "y", "radius", "color"
    trials = partial(_circles, exactly)
    return DrawingExercise(
        "circle",
        names,
        trials,
        [NOT_BGIS, *CIRCLE_SIGNS],
        _trouble,
        instead=INSTEAD,
        otherwise=NO_CIRCLE,
    )


def ellipse(exactly: bool) -> DrawingExercise:
    """Ellipses; exactly those of bgi, or any that are right."""
    names = "x", "y", "xradius", "yradius", "color"
    trials = partial(_ellipses, exactly)
    return DrawingExercise(
        "ellipse",
        names,
        trials,
        [NOT_BGIS, *ELLIPSE_SIGNS],
        _trouble,
        instead=INSTEAD,
        otherwise=NO_ELLIPSE,
    )
