"""Circles and ellipses: which pixels they may have, what is tried, and the usual mistakes.

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
from bgi.lab.drawn import (
    COMMON,
    INSTEAD,
    DrawingExercise,
    Evidence,
    Fault,
    Place,
    Sign,
    Trial,
    by_bgi,
    off_by_one,
    only,
)

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


# The signs


def _around(fault: Fault, pixels: set[Place]) -> set[Place]:
    """Pixels as they are seen from the centre."""
    x, y = fault.arguments[:2]
    return {(px - x, py - y) for px, py in pixels}


def _radius(fault: Fault) -> Place:
    radii = fault.arguments[2:-1]
    return radii[0], radii[-1]


def _parts(pixels: set[Place], radii: Place) -> set[tuple[bool, ...]]:
    """The eighths in which pixels lie; those between two eighths are in none."""
    rx, ry = radii
    return {
        (dx < 0, dy < 0, ry * ry * abs(dx) < rx * rx * abs(dy))
        for dx, dy in pixels
        if dx and dy and ry * ry * abs(dx) != rx * rx * abs(dy)
    }


def _empty_parts(number: int) -> Callable[[Evidence], bool]:
    """So many eighths are empty at least, and nothing else is wrong."""

    def seems(fault: Fault) -> bool:
        drawn = _parts(_around(fault, fault.drawn), _radius(fault))
        wanted = _parts(_around(fault, fault.wanted), _radius(fault))
        return not fault.extra and len(wanted - drawn) >= min(number, len(wanted))

    return lambda evidence: evidence.always(seems)


def _axes(fault: Fault) -> bool:
    """Only the points right, left, above and below are missing."""
    missing = _around(fault, fault.missing)
    return bool(missing) and not fault.extra and all(dx == 0 or dy == 0 for dx, dy in missing)


def _corners(fault: Fault) -> bool:
    """Only the pixels on the diagonals are missing."""
    missing = _around(fault, fault.missing)
    return bool(missing) and not fault.extra and all(abs(dx) == abs(dy) for dx, dy in missing)


def _filled(fault: Fault) -> bool:
    rx, ry = _radius(fault)
    inside = [
        ry * ry * x * x + rx * rx * y * y < (rx * ry) ** 2 for x, y in _around(fault, fault.extra)
    ]
    return len(inside) > rx * ry // 2 and all(inside) and not fault.missing


def _same_as(change: Callable[[Fault], tuple[Place, Place]]) -> Callable[[Evidence], bool]:
    """What is drawn is another one: `change` says its centre and radii."""

    def seems(fault: Fault) -> bool:
        (cx, cy), (rx, ry) = change(fault)
        if rx <= 1 or ry <= 1:
            return True  # too small to tell
        steps = quarter(rx, ry).steps
        spots = {
            (cx + right * x, cy + down * y)
            for right, down in MIRRORS
            for step in steps
            for x, y in step[:1]
        }
        seen = {(x, y) for x, y in spots if 0 <= x < 640 and 0 <= y < 480}
        return bool(seen) and len(seen - fault.drawn) <= len(seen) // 10

    return lambda evidence: evidence.always(seems)


def _larger(by: int, times: int = 1) -> Callable[[Fault], tuple[Place, Place]]:
    return lambda fault: (
        fault.arguments[:2],
        (_radius(fault)[0] * times + by, _radius(fault)[1] * times + by),
    )


def _gaps(evidence: Evidence) -> bool:
    """Pixels are missing at the left and right sides only."""

    def seems(fault: Fault) -> bool:
        rx, ry = _radius(fault)
        missing = _around(fault, fault.missing)
        return not fault.extra and all(ry * ry * abs(dx) > rx * rx * abs(dy) for dx, dy in missing)

    return evidence.always(seems)


def _holes(evidence: Evidence) -> bool:
    """Pixels are missing all around, in large ones only."""
    smallest = min(max(_radius(fault)) for fault in evidence.faults)
    return evidence.always(lambda fault: not fault.extra) and smallest > 8


def _thick(evidence: Evidence) -> bool:
    return evidence.always(lambda fault: not fault.missing and bool(fault.extra))


MOVED: list[Sign] = [
    (
        _same_as(lambda fault: ((0, 0), _radius(fault))),
        "it is drawn around 0, 0: add the centre's x and y to every pixel",
    ),
    (_same_as(_larger(-1)), "the radius is too small by one: range(a, b) stops before b"),
    (_same_as(_larger(1)), "the radius is too large by one"),
    (_same_as(_larger(0, 2)), "it is twice as large: the radius goes from the centre to the rim"),
]

CIRCLE_SIGNS: list[Sign] = [
    *COMMON,
    (
        _empty_parts(6),
        "a symmetric part is missing: an eighth, or two, is there. Each point that you compute"
        " gives eight pixels: x and y, exchanged, and with either sign",
    ),
    (_empty_parts(1), "a symmetric part is missing: which of the eight putpixel calls has gone?"),
    (only(_axes), "the points straight above, below, left and right are missing: begin with x = 0"),
    (only(_corners), "the pixels on the diagonals are missing: go on while x <= y"),
    (only(_filled), "the circle is filled: only its rim is wanted"),
    *MOVED,
    (
        _gaps,
        "there are gaps at the left and right sides: one pixel for each x is too few where the"
        " circle is steep; compute an eighth and mirror it",
    ),
    (_holes, "there are gaps in large circles: the step of the angle is too large for them"),
    (_thick, "there are pixels too many: each step along an eighth has one pixel"),
    (
        off_by_one,
        "off by one: of two neighbours the nearer one is wanted; int() cuts off, round() does not,"
        " and the midpoint's d begins with 1 - radius",
    ),
]


def _region(level: bool) -> Callable[[Evidence], bool]:
    """Of two regions one is missing: where the curve is more level, or where it is more upright."""

    def seems(fault: Fault) -> bool:
        rx, ry = _radius(fault)
        missing = _around(fault, fault.missing)
        there = [p for p in missing if (ry * ry * abs(p[0]) <= rx * rx * abs(p[1])) == level]
        return not fault.extra and 10 * len(there) >= 9 * len(missing) > 0

    return lambda evidence: not evidence.right and evidence.always(seems)


ELLIPSE_SIGNS: list[Sign] = [
    *COMMON,
    (
        _same_as(lambda fault: (fault.arguments[:2], _radius(fault)[::-1])),
        "the radii are exchanged: the first one goes to the right, the second one down",
    ),
    (
        _same_as(lambda fault: (fault.arguments[:2], (_radius(fault)[0],) * 2)),
        "it is a circle: the second radius, which goes down, is not used",
    ),
    (
        _region(level=False),
        "the sides are missing, or have gaps: where the ellipse is steep, step along y; that is the"
        " second region",
    ),
    (
        _region(level=True),
        "top and bottom are missing, or have gaps: where the ellipse is level, step along x; that"
        " is the first region",
    ),
    (
        _empty_parts(2),
        "a symmetric part is missing: each point that you compute gives four pixels",
    ),
    (only(_axes), "the points straight above, below, left and right are missing"),
    (only(_filled), "the ellipse is filled: only its rim is wanted"),
    *MOVED,
    (_holes, "there are gaps in large ellipses: the step of the angle is too large for them"),
    (_thick, "there are pixels too many: each step along a region has one pixel"),
    (
        off_by_one,
        "off by one: of two neighbours the nearer one is wanted; int() cuts off, round() does not,"
        " and each region has a d of its own to begin with",
    ),
]


def _trouble(fault: Fault) -> str:
    assert fault.outcome.trouble is not None
    if isinstance(fault.outcome.trouble.error, ValueError):
        return "the root of a number below 0? Outside of the curve there is no point"
    if fault.outcome.trouble.kind == "endless":
        return "x must grow, or y fall, in every step; the loop ends where they meet"
    return ""


def circle(exactly: bool) -> DrawingExercise:
    """Circles; exactly those of bgi, or any that are right."""
    names = "x", "y", "radius", "color"
    trials = partial(_circles, exactly)
    return DrawingExercise("circle", names, trials, CIRCLE_SIGNS, _trouble, instead=INSTEAD)


def ellipse(exactly: bool) -> DrawingExercise:
    """Ellipses; exactly those of bgi, or any that are right."""
    names = "x", "y", "xradius", "yradius", "color"
    trials = partial(_ellipses, exactly)
    return DrawingExercise("ellipse", names, trials, ELLIPSE_SIGNS, _trouble, instead=INSTEAD)
